// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_forces/closed_walls.hpp"

#include <algorithm>

#include "washfsi/motion/turned.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// The outward normal at a patch's middle; zero where the body is thinner than a cell.
template <int Dim>
Point<Dim> way_out(const Shape<Dim>& shape, const Point<Dim>& middle, const Point<Dim>& cell) {
  const Point<Dim> normal = distance_gradient<Dim>(shape, middle, 1e-3 * cell.minCoeff()).normalized();
  const double along = normal.cwiseProduct(cell).norm();
  return shape.distance(middle - along * normal) < -0.5 * along ? normal : Point<Dim>(Point<Dim>::Zero());
}

}  // namespace

template <int Dim>
ClosedWalls<Dim>::ClosedWalls(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies,
                              const BodyMarkers<Dim>& markers)
    : grid_(grid), bodies_(bodies), thin_patches_(bodies.size(), 0.0) {
  for (std::size_t p = markers.own().begin; p < markers.own().end; ++p) {
    const std::size_t b = markers.body_of(p);
    const Point<Dim> normal = way_out<Dim>(*bodies[b].shape, markers.middle(p), grid.spacing());
    if (normal.isZero(0)) thin_patches_[b] += 1;
    body_of_.push_back(b);
    sizes_.push_back(markers.start(p + 1) - markers.start(p));
    normals_.push_back(normal);
  }
  thin_patches_ = ordered_sum(grid.comm(), thin_patches_);
}

template <int Dim>
void ClosedWalls<Dim>::update(const std::vector<typename BodyMarkers<Dim>::State>& states, double time) {
  weighted_normals_ = turned<Dim>(normals_, bodies_, time, true, [this](std::size_t p) { return body_of_[p]; });
  std::vector<double> sums(2 * bodies_.size(), 0.0);  // for each body: squared counts; covered markers
  std::size_t m = 0;
  for (std::size_t p = 0; p < weighted_normals_.size(); ++p) {
    double acting = 0;
    for (const std::size_t end = m + sizes_[p]; m < end; ++m) {
      acting += states[m].acts ? 1 : 0;
      sums[2 * body_of_[p] + 1] += states[m].is_covered ? 1 : 0;
    }
    weighted_normals_[p] *= acting;
    sums[2 * body_of_[p]] += weighted_normals_[p].squaredNorm();
  }
  sums = ordered_sum(grid_.comm(), sums);
  squares_.clear();
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    squares_.push_back(thin_patches_[b] == 0 && sums[2 * b + 1] == 0 ? sums[2 * b] : 0);
}

template <int Dim>
void ClosedWalls<Dim>::remove_from(Points<Dim>& values) const {
  if (std::all_of(squares_.begin(), squares_.end(), [](double square) { return square == 0; })) return;
  std::vector<double> sums(bodies_.size(), 0.0);
  for (std::size_t p = 0; p < values.size(); ++p) sums[body_of_[p]] += values[p].dot(weighted_normals_[p]);
  sums = ordered_sum(grid_.comm(), sums);
  for (std::size_t p = 0; p < values.size(); ++p)
    if (const double square = squares_[body_of_[p]]; square > 0)
      values[p] -= sums[body_of_[p]] / square * weighted_normals_[p];
}

template class ClosedWalls<2>;
template class ClosedWalls<3>;

}  // namespace washfsi
