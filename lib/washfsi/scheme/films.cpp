// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/scheme/films.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace washfsi {

namespace {

// l^2 of the area in which two cloths are near.
template <int Dim>
double mean_square_of(double area) {
  return Dim == 3 ? area / (8 * std::numbers::pi) : area * area / 12;
}

// Symmetric.
template <int Dim>
void add_block(Mat matrix, std::size_t row, std::size_t column, const StiffnessBlock<Dim>& block) {
  std::array<PetscInt, Dim> rows, columns;
  for (int a = 0; a < Dim; ++a) {
    rows[a] = static_cast<PetscInt>(row) * Dim + a;
    columns[a] = static_cast<PetscInt>(column) * Dim + a;
  }
  WASH_PETSC(MatSetValues(matrix, Dim, rows.data(), Dim, columns.data(), block.data(), ADD_VALUES));
}

}  // namespace

double film_ease(PureLiquid liquid, double gap, double mean_square, double inertia, double pressure) {
  const double a = 12 * liquid.viscosity * mean_square / (gap * gap * gap);
  const double c = inertia * liquid.density * mean_square / (gap * gap);
  return 2 / (a + std::sqrt(a * a + 4 * c * pressure));
}

template <int Dim>
Films<Dim>::Films(const Grid<Dim>& grid, const Cloths<Dim>& cloths, PureLiquid liquid)
    : cloths_(cloths),
      liquid_(liquid),
      facets_(cloths),
      cell_(grid.spacing().minCoeff()),
      search_(facets_, periods_of<Dim>(grid), 0, static_cast<std::size_t>(cloths.marker_count())) {
  for (std::size_t p = 0; p < cloths.pieces().size(); ++p)
    cloth_of_.insert(cloth_of_.end(), static_cast<std::size_t>(cloths.pieces()[p].count), p);
}

template <int Dim>
bool Films<Dim>::owns(std::size_t marker) const {
  const auto number = static_cast<PetscInt>(marker);
  return number >= cloths_.begin() && number < cloths_.end();
}

// Of each marker with each other cloth, the nearest.
template <int Dim>
typename Films<Dim>::Pairs Films<Dim>::nearest_pairs(const Points<Dim>& all) const {
  std::map<std::pair<std::size_t, std::size_t>, FacetPair<Dim>> nearest;
  for (const auto& pair : search_.find(all, std::vector<double>(all.size(), 0.0), cell_)) {
    const std::size_t other = cloth_of_[pair.markers.back()];
    if (pair.kind != PairKind::point_facet || other == cloth_of_[pair.markers[0]] || pair.start == 0) continue;
    const auto [place, is_new] = nearest.try_emplace({pair.markers[0], other}, pair);
    if (!is_new && pair.start < place->second.start) place->second = pair;
  }
  Pairs pairs;
  for (const auto& [key, pair] : nearest) pairs.push_back(pair);
  return pairs;
}

template <int Dim>
typename Films<Dim>::Film Films<Dim>::film(const FacetPair<Dim>& pair, const Points<Dim>& all) const {
  const Gap<Dim> gap = gap_of<Dim>(pair.kind, pair.at(all));
  Film film{pair.markers, {}, gap.distance, 0, 0.5 * facets_.marker_areas[pair.markers[0]]};
  for (std::size_t i = 0; i < film.weights.size(); ++i)
    film.weights[i] = 0.5 * gap.shares[i] / facets_.marker_areas[pair.markers[i]] * gap.normal;
  return film;
}

template <int Dim>
double Films<Dim>::pressure(const Film& film, const Points<Dim>& all_forces) const {
  double sum = 0;
  for (std::size_t i = 0; i < film.markers.size(); ++i) sum += film.weights[i].dot(all_forces[film.markers[i]]);
  return sum;
}

template <int Dim>
double Films<Dim>::ease(const Film& film, double pressure) const {
  constexpr double inertia = Dim == 3 ? 1.8 : 2.4;
  return (1 - film.gap / cell_) * film_ease(liquid_, film.gap, film.mean_square, inertia, std::abs(pressure));
}

template <int Dim>
void Films<Dim>::begin_step(const Points<Dim>& positions, const Points<Dim>& forces) {
  const petsc::LogPart part("films");
  const Points<Dim> all = cloths_.of_all_ranks(positions), given = cloths_.of_all_ranks(forces);
  const auto cloths_of = [&](const Film& film) {
    return std::minmax({cloth_of_[film.markers.front()], cloth_of_[film.markers.back()]});
  };
  films_.clear();
  std::map<std::pair<std::size_t, std::size_t>, double> areas;  // half of each marker's, from either side
  for (const auto& pair : nearest_pairs(all)) {
    films_.push_back(film(pair, all));
    areas[cloths_of(films_.back())] += films_.back().area;
  }
  for (Film& film : films_) {
    film.mean_square = mean_square_of<Dim>(areas[cloths_of(film)]);
    film.ease = ease(film, pressure(film, given));
  }
}

template <int Dim>
void Films<Dim>::add_velocities(const Points<Dim>& forces, Points<Dim>& velocities) const {
  const Points<Dim> all = cloths_.of_all_ranks(forces);
  for (const Film& film : films_) {
    const double speed = film.area * film.ease * pressure(film, all);
    for (std::size_t i = 0; i < film.markers.size(); ++i)
      if (owns(film.markers[i]))
        velocities[film.markers[i] - static_cast<std::size_t>(cloths_.begin())] += speed * film.weights[i];
  }
}

template <int Dim>
double Films<Dim>::power(const Points<Dim>& forces) const {
  const Points<Dim> all = cloths_.of_all_ranks(forces);
  double sum = 0;
  for (const Film& film : films_) sum += film.area * film.ease * std::pow(pressure(film, all), 2);
  return sum;
}

// Each rank the rows of its own markers.
template <int Dim>
petsc::Matrix Films<Dim>::matrix(double factor) const {
  std::vector<PetscInt> entries(Dim * cloths_.owned(), Dim);
  for (const Film& film : films_)
    for (const std::size_t marker : film.markers)
      if (owns(marker))
        for (std::size_t a = 0; a < Dim; ++a)
          entries[Dim * (marker - static_cast<std::size_t>(cloths_.begin())) + a] += Dim * pair_markers<Dim>;
  const auto rows = static_cast<PetscInt>(entries.size());
  std::vector<PetscInt> others = entries;
  for (PetscInt& count : entries) count = std::min(count, rows);
  for (PetscInt& count : others) count = std::min(count, Dim * cloths_.marker_count() - rows);
  petsc::Matrix own;
  WASH_PETSC(MatCreateAIJ(cloths_.comm(), rows, rows, PETSC_DETERMINE, PETSC_DETERMINE, 0, entries.data(), 0,
                          others.data(), own.put()));
  for (const Film& film : films_)
    for (std::size_t i = 0; i < film.markers.size(); ++i) {
      if (!owns(film.markers[i])) continue;
      for (std::size_t j = 0; j < film.markers.size(); ++j) {
        const StiffnessBlock<Dim> block =
            factor * film.area * film.ease * film.weights[i] * film.weights[j].transpose();
        add_block<Dim>(own, film.markers[i], film.markers[j], block);
      }
    }
  WASH_PETSC(MatAssemblyBegin(own, MAT_FINAL_ASSEMBLY));
  WASH_PETSC(MatAssemblyEnd(own, MAT_FINAL_ASSEMBLY));
  return own;
}

template class Films<2>;
template class Films<3>;

}  // namespace washfsi
