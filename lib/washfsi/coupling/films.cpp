// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/films.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi {

namespace {

// l_film^2 for the area in which two cloths are near.
template <int Dim>
double mean_square_of(double area) {
  return Dim == 3 ? area / (8 * std::numbers::pi) : area * area / 12;
}

}  // namespace

double film_ease(const PureLiquid& liquid, double gap, double mean_square, double inertia, double pressure) {
  const double a = 12 * liquid.viscosity * mean_square / (gap * gap * gap);
  const double c = inertia * liquid.density * mean_square / (gap * gap);
  return 2 / (a + std::sqrt(a * a + 4 * c * pressure));
}

template <int Dim>
Films<Dim>::Films(const Grid<Dim>& grid, const Cloths<Dim>& cloths, const Liquid<Dim>& liquid)
    : cloths_(cloths), liquid_(liquid), cell_(grid.spacing().minCoeff()), search_(cloths, periods_of<Dim>(grid)) {}

// The nearest pair of each of this rank's markers with each other cloth.
template <int Dim>
typename Films<Dim>::Pairs Films<Dim>::nearest_pairs(const Points<Dim>& positions) {
  std::map<std::pair<std::size_t, std::size_t>, FacetPair<Dim>> nearest;
  search_.find_near(positions, std::vector<double>(positions.size(), 0.0), cell_);
  for (const auto& pair : search_.pairs([this](std::size_t, std::size_t) { return cell_; }, cell_)) {
    const NearMarkers<Dim>& known = search_.known();
    const std::size_t other = known.piece_of(pair.markers.back());
    if (pair.kind != PairKind::point_facet || !known.owns(pair.markers[0])) continue;
    if (other == known.piece_of(pair.markers[0]) || pair.start == 0) continue;
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
  const std::vector<double>& areas = search_.facets().marker_areas;
  Film film{pair.markers, {}, gap.distance, 0, 0.5 * areas[pair.markers[0]]};
  for (std::size_t i = 0; i < film.weights.size(); ++i)
    film.weights[i] = 0.5 * gap.shares[i] / areas[pair.markers[i]] * gap.normal;
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
  return (1 - film.gap / cell_) * film_ease(liquid_.pure(), film.gap, film.mean_square, inertia, std::abs(pressure));
}

template <int Dim>
void Films<Dim>::begin_step(const Points<Dim>& positions, const Points<Dim>& forces) {
  const petsc::LogPart part("films");
  const Pairs pairs = nearest_pairs(positions);
  const Points<Dim> all = search_.known().values(positions), given = search_.known().values(forces);
  films_.clear();
  for (const auto& pair : pairs) films_.push_back(film(pair, all));
  find_mean_squares();
  for (Film& film : films_) film.ease = ease(film, pressure(film, given));
}

// Finds l_film^2 from the area in which two cloths are near: half the area of each marker, on both, over all ranks.
template <int Dim>
void Films<Dim>::find_mean_squares() {
  using Cloths = std::pair<std::size_t, std::size_t>;
  const NearMarkers<Dim>& known = search_.known();
  const auto cloths_of = [&](const Film& film) -> Cloths {
    return std::minmax({known.piece_of(film.markers.front()), known.piece_of(film.markers.back())});
  };
  std::vector<std::pair<Cloths, double>> areas;
  for (const Film& film : films_) areas.emplace_back(cloths_of(film), film.area);
  std::map<Cloths, double> sums;
  for (const auto& [cloths, area] : of_all_ranks(cloths_.comm(), areas)) sums[cloths] += area;
  for (Film& film : films_) film.mean_square = mean_square_of<Dim>(sums[cloths_of(film)]);
}

template <int Dim>
void Films<Dim>::add_velocities(const Points<Dim>& forces, Points<Dim>& velocities) const {
  const Points<Dim> all = search_.known().values(forces);
  Points<Dim> moved(all.size(), Point<Dim>::Zero());
  for (const Film& film : films_) {
    const double speed = film.area * film.ease * pressure(film, all);
    for (std::size_t i = 0; i < film.markers.size(); ++i) moved[film.markers[i]] += speed * film.weights[i];
  }
  velocities += search_.known().sums(moved);
}

template <int Dim>
petsc::Matrix Films<Dim>::matrix(double factor) const {
  std::vector<PetscInt> rows, columns;
  std::vector<double> values;
  const auto add_block = [&](std::size_t row, std::size_t column, const StiffnessBlock<Dim>& block) {
    for (int a = 0; a < Dim; ++a)
      for (int b = 0; b < Dim; ++b) {
        rows.push_back(static_cast<PetscInt>(row) * Dim + a);
        columns.push_back(static_cast<PetscInt>(column) * Dim + b);
        values.push_back(block(a, b));
      }
  };
  const std::vector<std::size_t>& numbers = search_.known().numbers();
  for (const Film& film : films_)
    for (std::size_t i = 0; i < film.markers.size(); ++i)
      for (std::size_t j = 0; j < film.markers.size(); ++j)
        add_block(numbers[film.markers[i]], numbers[film.markers[j]],
                  factor * film.area * film.ease * film.weights[i] * film.weights[j].transpose());
  petsc::Matrix matrix;
  const auto size = static_cast<PetscInt>(Dim * cloths_.owned());
  WASH_PETSC(MatCreate(cloths_.comm(), matrix.put()));
  WASH_PETSC(MatSetSizes(matrix, size, size, PETSC_DETERMINE, PETSC_DETERMINE));
  WASH_PETSC(MatSetType(matrix, MATAIJ));
  WASH_PETSC(MatSetPreallocationCOO(matrix, static_cast<PetscCount>(rows.size()), rows.data(), columns.data()));
  WASH_PETSC(MatSetValuesCOO(matrix, values.data(), INSERT_VALUES));
  return matrix;
}

template class Films<2>;
template class Films<3>;

}  // namespace washfsi
