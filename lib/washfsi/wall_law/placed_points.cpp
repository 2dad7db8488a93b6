// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_law/placed_points.hpp"

#include "washfsi/motion/turned.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr DeltaOptions delta{DeltaKernel::yang, 2, 2};

}  // namespace

template <int Dim>
PlacedPoints<Dim>::PlacedPoints(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                const std::vector<Body<Dim>>& bodies, const std::vector<WallPoint<Dim>>& all)
    : grid_(grid),
      bodies_(bodies),
      count_(all.size()),
      transfer_(grid, boundary, delta),
      inner_(grid, boundary, delta) {
  const auto ranks = static_cast<std::size_t>(ranks_of(grid.comm()));
  const auto rank = static_cast<std::size_t>(rank_of(grid.comm()));
  begin_ = count_ * rank / ranks;
  const std::size_t end = count_ * (rank + 1) / ranks;
  points_.assign(all.begin() + static_cast<std::ptrdiff_t>(begin_), all.begin() + static_cast<std::ptrdiff_t>(end));
  for (std::size_t p = begin_; p < end; ++p)
    faces_.push_back(2 * all[p].patch + (p > 0 && all[p - 1].patch == all[p].patch ? 1 : 0));
}

template <int Dim>
bool PlacedPoints<Dim>::is_free(const PosedBodies<Dim>& posed, const WallPoint<Dim>& point,
                                const Point<Dim>& place) const {
  if (!grid_.contains(place)) return false;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if ((b != point.body || bodies_[b].repeats.any()) && posed.distance(b, place) < 0.5 * point.along) return false;
  return true;
}

template <int Dim>
void PlacedPoints<Dim>::place(double time) {
  time_ = time;
  motions_ = motions_at(bodies_, time_);
  const PosedBodies<Dim> posed(bodies_, time_);
  const Point<Dim> anywhere = 0.5 * (grid_.lower() + grid_.upper());
  places_.clear();
  normals_.clear();
  acts_.clear();
  covers_.clear();
  Points<Dim> inner;
  for (const WallPoint<Dim>& point : points_) {
    const Point<Dim> foot = posed.in_space(point.body, point.foot);
    normals_.push_back(posed.in_space(point.body, point.foot + point.normal) - foot);
    const Point<Dim> step = point.along * normals_.back(), acting = foot + acting_place * step;
    acts_.push_back(grid_.contains(acting) && is_free(posed, point, foot + matching_place * step));
    places_.push_back(acts_.back() ? acting : anywhere);
    inner.push_back(foot + inner_place * step);
    covers_.push_back(point.is_thick && grid_.contains(inner.back()) ? point.area * point.along : 0);
    if (covers_.back() == 0) inner.back() = anywhere;
  }
  transfer_.locate(places_);
  inner_.locate(inner);
}

template <int Dim>
Points<Dim> PlacedPoints<Dim>::speeds_along(Vec local_velocity, double distance) const {
  static_assert(acting_place <= Transfer<Dim>::sample_reach &&
                matching_place - acting_place <= Transfer<Dim>::sample_reach);
  Points<Dim> offsets;
  for (std::size_t p = 0; p < points_.size(); ++p)
    offsets.push_back((distance - acting_place) * points_[p].along * normals_[p]);
  Points<Dim> velocities = transfer_.sample(local_velocity, offsets);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    velocities[p] -= motions_[points_[p].body].velocity_at(places_[p] + offsets[p]);
    velocities[p] -= velocities[p].dot(normals_[p]) * normals_[p];
  }
  return turned(std::move(velocities), false);
}

template <int Dim>
Points<Dim> PlacedPoints<Dim>::turned(Points<Dim> values, bool into_space) const {
  return washfsi::turned<Dim>(std::move(values), bodies_, time_, into_space,
                              [this](std::size_t p) { return points_[p].body; });
}

template class PlacedPoints<2>;
template class PlacedPoints<3>;

}  // namespace washfsi
