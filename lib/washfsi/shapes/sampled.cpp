// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/sampled.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
Lattice<Dim> Lattice<Dim>::around(const Point<Dim>& lower, const Point<Dim>& upper, double margin, double spacing) {
  Lattice lattice;
  lattice.spacing = spacing;
  for (int d = 0; d < Dim; ++d) {
    const double width = upper[d] - lower[d] + 2 * margin;
    const double intervals = std::min(std::max(std::ceil(width / spacing), 1.0), 1e9);
    lattice.count[d] = static_cast<PetscInt>(intervals) + 1;
    lattice.lower[d] = 0.5 * (lower[d] + upper[d] - intervals * spacing);  // the body in the middle
  }
  return lattice;
}

template <int Dim>
double Lattice<Dim>::size() const {
  double size = 1;
  for (const PetscInt n : count) size *= static_cast<double>(n);
  return size;
}

template <int Dim>
Point<Dim> Lattice<Dim>::place(const Index<Dim>& point) const {
  Point<Dim> place = lower;
  for (int d = 0; d < Dim; ++d) place[d] += spacing * static_cast<double>(point[d]);
  return place;
}

template <int Dim>
Sampled<Dim>::Sampled(const Lattice<Dim>& lattice, std::vector<double> values)
    : lattice_(lattice), values_(std::move(values)) {
  PetscInt stride = 1;
  Index<Dim> last = lattice.count;
  for (int d = 0; d < Dim; ++d) {
    stride_[d] = stride;
    stride *= lattice.count[d];
    --last[d];
  }
  upper_ = lattice.place(last);
}

template <int Dim>
double Sampled<Dim>::distance(const Point<Dim>& place) const {
  const Point<Dim> inside = place.cwiseMax(lattice_.lower).cwiseMin(upper_);
  const double there = interpolate(inside), beyond = (place - inside).norm();
  return beyond == 0 ? there : std::hypot(beyond, std::max(there, 0.0));
}

template <int Dim>
double Sampled<Dim>::interpolate(const Point<Dim>& place) const {
  std::array<double, Dim> part{};
  PetscInt base = 0;
  for (int d = 0; d < Dim; ++d) {
    const double position = (place[d] - lattice_.lower[d]) / lattice_.spacing;
    const PetscInt cell = std::clamp<PetscInt>(static_cast<PetscInt>(position), 0, lattice_.count[d] - 2);
    part[d] = position - static_cast<double>(cell);
    base += cell * stride_[d];
  }
  double sum = 0;
  for (unsigned corner = 0; corner < 1U << Dim; ++corner) {
    double weight = 1;
    PetscInt offset = base;
    for (int d = 0; d < Dim; ++d) {
      const bool upper = (corner >> d & 1U) != 0;
      weight *= upper ? part[d] : 1 - part[d];
      if (upper) offset += stride_[d];
    }
    sum += weight * values_[offset];
  }
  return sum;
}

template <int Dim>
std::unique_ptr<Sampled<Dim>> Sampled<Dim>::of(MPI_Comm comm, const Shape<Dim>& shape, const Lattice<Dim>& lattice) {
  const auto ranks = static_cast<std::size_t>(ranks_of(comm)), rank = static_cast<std::size_t>(rank_of(comm));
  std::vector<double> values(static_cast<std::size_t>(lattice.size()));
  std::vector<int> counts(ranks), starts(ranks);
  const auto first_of = [&](std::size_t r) { return static_cast<int>(values.size() * r / ranks); };
  for (std::size_t r = 0; r < ranks; ++r) {
    starts[r] = first_of(r);
    counts[r] = first_of(r + 1) - starts[r];
  }
  int number = 0;
  for_each<Dim>(lattice.points(), [&](const Index<Dim>& point) {
    if (number >= starts[rank] && number < starts[rank] + counts[rank])
      values[number] = shape.distance(lattice.place(point));
    ++number;
  });
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, values.data(), counts.data(), starts.data(), MPI_DOUBLE, comm);
  return std::make_unique<Sampled>(lattice, std::move(values));
}

template struct Lattice<2>;
template struct Lattice<3>;
template class Sampled<2>;
template class Sampled<3>;

}  // namespace washfsi
