// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/zero_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr PetscInt fewest_nodes = 2, most_nodes = 16;  // per cell along each axis

/// Marches through cells and collects what it finds.
template <int Dim>
class Marcher {
 public:
  Marcher(const Grid<Dim>& grid, const std::function<double(const Point<Dim>&)>& distance)
      : grid_(grid), spacing_(grid.spacing() / most_nodes), distance_(distance) {}

  void march(const Index<Dim>& cell, PetscInt nodes_a_cell) {
    step_ = most_nodes / nodes_a_cell;
    Box<Dim> parts;
    for (int d = 0; d < Dim; ++d) {
      parts.lower[d] = nodes_a_cell * cell[d];
      parts.upper[d] = nodes_a_cell * (cell[d] + 1);
    }
    for_each<Dim>(parts, [&](Node corner) {
      for (auto& number : corner) number *= step_;
      march_cube(corner);
    });
  }

  SimplexMesh<Dim> mesh;

 private:
  using Node = Index<Dim>;  ///< index in the finest lattice
  using Corners = std::array<Node, Dim + 1>;

  Point<Dim> place(const Node& node) const {
    Point<Dim> place = grid_.lower();
    for (int d = 0; d < Dim; ++d) place[d] += static_cast<double>(node[d]) * spacing_[d];
    return place;
  }

  double value(const Node& node) {
    const auto [entry, is_new] = values_.try_emplace(node, 0.0);
    if (is_new) entry->second = distance_(place(node));
    return entry->second;
  }

  // Kuhn's simplices: from the lower corner to the upper, along the axes in every order.
  void march_cube(const Node& corner) {
    std::array<int, Dim> order{};
    std::iota(order.begin(), order.end(), 0);
    do {
      Corners corners{corner};
      for (int step = 0; step < Dim; ++step) {
        corners[step + 1] = corners[step];
        corners[step + 1][order[step]] += step_;
      }
      march_simplex(corners);
    } while (std::next_permutation(order.begin(), order.end()));
  }

  void march_simplex(const Corners& corners) {
    std::vector<Node> inside, outside;
    for (const Node& node : corners) (value(node) < 0 ? inside : outside).push_back(node);
    if (inside.empty() || outside.empty()) return;
    const Point<Dim> outwards = place(outside[0]) - place(inside[0]);
    std::vector<std::size_t> cuts;
    for (std::size_t i = 0; i < inside.size(); ++i)
      for (std::size_t o = 0; o < outside.size(); ++o)  // there and back, so that four of them go round
        cuts.push_back(vertex(inside[i], outside[i % 2 == 0 ? o : outside.size() - 1 - o]));
    for (std::size_t last = Dim - 1; last < cuts.size(); ++last) {
      std::array<std::size_t, Dim> facet{cuts[0]};
      for (int n = 1; n < Dim; ++n) facet[n] = cuts[last + n - (Dim - 1)];
      add(facet, outwards);
    }
  }

  void add(std::array<std::size_t, Dim> facet, const Point<Dim>& outwards) {
    const Point<Dim> edge = mesh.vertices[facet[1]] - mesh.vertices[facet[0]];
    double side = 0;
    if constexpr (Dim == 2)
      side = edge[1] * outwards[0] - edge[0] * outwards[1];
    else
      side = edge.cross(mesh.vertices[facet[2]] - mesh.vertices[facet[0]]).dot(outwards);
    if (side < 0) std::swap(facet[0], facet[1]);
    mesh.facets.push_back(facet);
  }

  // The vertex where the distance is zero between two nodes.
  std::size_t vertex(const Node& inside, const Node& outside) {
    const auto [entry, is_new] = cuts_.try_emplace({inside, outside}, mesh.vertices.size());
    if (is_new) {
      const double below = value(inside), above = value(outside);
      const Point<Dim> start = place(inside), end = place(outside);
      mesh.vertices.emplace_back(start + below / (below - above) * (end - start));
    }
    return entry->second;
  }

  const Grid<Dim>& grid_;
  Point<Dim> spacing_;
  PetscInt step_ = 1;  ///< between the nodes of the current cell
  const std::function<double(const Point<Dim>&)>& distance_;
  std::map<Node, double> values_;
  std::map<std::pair<Node, Node>, std::size_t> cuts_;
};

// All ranks' numbers on rank 0, the lowest first; none on others.
std::vector<long long> gathered(MPI_Comm comm, const std::vector<long long>& mine) {
  const auto ranks = static_cast<std::size_t>(ranks_of(comm));
  std::vector<int> counts(ranks), starts(ranks, 0);
  const int count = static_cast<int>(mine.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
  for (std::size_t r = 1; r < ranks; ++r) starts[r] = starts[r - 1] + counts[r - 1];
  std::vector<long long> all;
  if (rank_of(comm) == 0) all.resize(static_cast<std::size_t>(starts.back()) + static_cast<std::size_t>(counts.back()));
  MPI_Gatherv(mine.data(), count, MPI_LONG_LONG, all.data(), counts.data(), starts.data(), MPI_LONG_LONG, 0, comm);
  std::ranges::sort(all);
  return all;
}

// The number of nodes that a cell needs so that no thin part slips between them: the way through the body from the
// surface nearest to a place must be longer than their spacing.
template <int Dim>
PetscInt nodes_needed(const Point<Dim>& place, const Point<Dim>& spacing,
                      const std::function<double(const Point<Dim>&)>& distance) {
  const double step = 0.01 * spacing.minCoeff(), here = distance(place);
  if (std::abs(here) > 0.5 * spacing.maxCoeff()) return fewest_nodes;
  Point<Dim> normal;
  for (int d = 0; d < Dim; ++d)
    normal[d] = distance(place + step * Point<Dim>::Unit(d)) - distance(place - step * Point<Dim>::Unit(d));
  if (normal.isZero(0)) return fewest_nodes;
  normal.normalize();
  const double cell = 1 / normal.cwiseQuotient(spacing).norm();  // along the normal [m]
  if (std::abs(here) > 0.5 * cell) return fewest_nodes;
  PetscInt nodes = fewest_nodes;
  while (nodes < most_nodes && distance(place - (here + cell / static_cast<double>(nodes)) * normal) >= 0) nodes *= 2;
  return nodes;
}

// The number of nodes that the parts of a shape need.
template <int Dim>
PetscInt nodes_in(const Grid<Dim>& grid, const Index<Dim>& cell,
                  const std::function<double(const Point<Dim>&)>& distance) {
  PetscInt nodes = fewest_nodes;
  for (unsigned part = 0; part < 1U << Dim; ++part) {
    Point<Dim> place = grid.cell_center(cell);
    for (int d = 0; d < Dim; ++d) place[d] += ((part >> d & 1U) != 0 ? 0.26 : -0.24) * grid.spacing()[d];
    nodes = std::max(nodes, nodes_needed<Dim>(place, grid.spacing(), distance));
  }
  return nodes;
}

// The cells of the box in which a surface may lie, x fastest, and how many nodes each needs, packed in one integer: the
// cell's number times a factor above the most nodes, plus the nodes. On rank 0.
template <int Dim>
std::vector<long long> cells_of_surface(const Grid<Dim>& grid,
                                        const std::function<double(const Point<Dim>&)>& distance) {
  const double reach = 0.5 * grid.spacing().norm();
  std::vector<long long> numbers;
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    if (std::abs(distance(grid.cell_center(cell))) > reach) return;
    long long number = 0;
    for (int d = Dim; d-- > 0;) number = number * grid.cells()[d] + cell[d];
    numbers.push_back(number * (most_nodes + 1) + nodes_in<Dim>(grid, cell, distance));
  });
  return gathered(grid.comm(), numbers);
}

}  // namespace

template <int Dim>
SimplexMesh<Dim> zero_surface(const Grid<Dim>& grid, const std::function<double(const Point<Dim>&)>& distance) {
  Marcher<Dim> marcher(grid, distance);
  for (long long number : cells_of_surface(grid, distance)) {
    const PetscInt nodes = static_cast<PetscInt>(number % (most_nodes + 1));
    number /= most_nodes + 1;
    Index<Dim> cell;
    for (int d = 0; d < Dim; ++d) {
      cell[d] = static_cast<PetscInt>(number % grid.cells()[d]);
      number /= grid.cells()[d];
    }
    marcher.march(cell, nodes);
  }
  return std::move(marcher.mesh);
}

template SimplexMesh<2> zero_surface<2>(const Grid<2>&, const std::function<double(const Point<2>&)>&);
template SimplexMesh<3> zero_surface<3>(const Grid<3>&, const std::function<double(const Point<3>&)>&);

}  // namespace washfsi
