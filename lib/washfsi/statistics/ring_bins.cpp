// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/ring_bins.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

std::vector<double> middles(double lowest, double width, std::size_t count) {
  std::vector<double> places(count);
  for (std::size_t n = 0; n < count; ++n) places[n] = lowest + (static_cast<double>(n) + 0.5) * width;
  return places;
}

/// Bins over a length from 0 on [m].
struct Layers {
  std::size_t count;
  double width;
};

// As many layers as requested; with 0, as wide as a cell.
Layers layers_of(PetscInt asked, double length, double cell) {
  constexpr double rounding = 1e-9;
  if (asked > 0) return {static_cast<std::size_t>(asked), length / static_cast<double>(asked)};
  return {static_cast<std::size_t>(std::ceil(length / cell - rounding)), cell};
}

// The bin that contains a place; a place between two bins is in the upper one, whatever the rounding.
std::size_t bin_of(double widths, std::size_t count) {
  constexpr double rounding = 1e-9;
  return std::min(static_cast<std::size_t>(std::max(0.0, widths + rounding)), count - 1);
}

}  // namespace

RingBins::RingBins(const Grid<3>& grid, int axis, const Point<3>& center, const std::array<PetscInt, 2>& counts)
    : axis_(axis), first_((axis + 1) % 3), second_((axis + 2) % 3), center_(center), lowest_(grid.lower()[axis]) {
  const Point<3> farthest = (grid.upper() - center).cwiseAbs().cwiseMax((grid.lower() - center).cwiseAbs());
  const double radius = std::hypot(farthest[first_], farthest[second_]);
  const double height = grid.upper()[axis] - grid.lower()[axis];
  const Layers across = layers_of(counts[0], radius, std::max(grid.spacing()[first_], grid.spacing()[second_]));
  const Layers up = layers_of(counts[1], height, grid.spacing()[axis]);
  width_ = across.width;
  depth_ = up.width;
  radii_ = middles(0, width_, across.count);
  heights_ = middles(lowest_, depth_, up.count);
  cells_.assign(count(), 0.0);
  for_each<3>(grid.owned(), [&](const Index<3>& cell) { ++cells_[at(grid.cell_center(cell)).bin]; });
  cells_ = ordered_sum(grid.comm(), cells_);
}

RingBins::Place RingBins::at(const Point<3>& place) const {
  const Point<3> arm = place - center_;
  const Point<2> across(arm[first_], arm[second_]);
  const double widths = across.norm() / width_;
  const std::size_t ring = bin_of(widths, radii_.size());
  const std::size_t layer = bin_of((place[axis_] - lowest_) / depth_, heights_.size());
  constexpr double nothing = 1e-9;  // tolerance in bins
  const Point<2> outwards = widths > nothing ? Point<2>(across.normalized()) : Point<2>::Zero();
  return {layer * radii_.size() + ring, widths - (static_cast<double>(ring) + 0.5), outwards};
}

Point<3> RingBins::along(const Place& place, const Point<3>& vector) const {
  const Point<2> across(vector[first_], vector[second_]);
  return {place.outwards.dot(across), place.outwards.dot(Point<2>(across[1], -across[0])), vector[axis_]};
}

}  // namespace washfsi
