// SPDX-License-Identifier: BSD-3-Clause
//
// What the markers' forces are to the bodies and to the sides of the box.
#include <algorithm>
#include <cmath>

#include "washfsi/forcing/surface_forcing.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

// What sides keep of each marker's force: the bodies' part of all sides, or what they leave open of one.
template <int Dim>
Points<Dim> SurfaceForcing<Dim>::kept_by_sides(const std::optional<SideName>& open) const {
  Points<Dim> kept = shared_out(forces_);
  const petsc::LocalVector local(grid_.wide_face_dm());
  boundary_.fill_from_sides(local, time_, transfer_.reached_sides(), open);
  const Points<Dim> parts = transfer_.interpolate_from_sides(local, open);
  for (std::size_t m = 0; m < kept.size(); ++m) kept[m] = kept[m].cwiseProduct(parts[m]);
  return kept;
}

// What a body's force leaves in a side that moves with it has never left the body.
template <int Dim>
Loads<Dim> SurfaceForcing<Dim>::loads() const {
  Loads<Dim> loads = law_ ? law_->loads_here() : Loads<Dim>(bodies_.size());
  const Points<Dim> given = shared_out(forces_);
  const Points<Dim> kept = kept_by_sides();
  const auto motions = motions_at(bodies_, time_);
  for_each_acting([&](std::size_t p, std::size_t m) {
    const std::size_t b = markers_.body_of(begin() + p);
    loads[b].add(states_[m].place - motions[b].center, kept[m] - given[m]);
  });
  return ordered_sum<Dim>(grid_.comm(), loads);
}

template <int Dim>
Loads<Dim> SurfaceForcing<Dim>::loads_on_sides(const std::vector<SideName>& sides) const {
  Loads<Dim> loads(sides.size());
  const Point<Dim> middle = 0.5 * (grid_.lower() + grid_.upper());
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const SideName side = sides[s];
    if (!any_rank(grid_.comm(), !boundary_.covered_wholly(side.axis, side.end))) continue;
    const Points<Dim> kept = kept_by_sides(side);
    for_each_acting([&](std::size_t, std::size_t m) {
      Point<Dim> place = states_[m].place;
      place[side.axis] = (side.end == End::lower ? grid_.lower() : grid_.upper())[side.axis];
      loads[s].add(place - middle, kept[m]);
    });
  }
  return ordered_sum<Dim>(grid_.comm(), loads);
}

template <int Dim>
Points<Dim> SurfaceForcing<Dim>::water_at_markers(Vec velocity, double time) const {
  const petsc::Version version(velocity);
  const bool is_known = seen_ && seen_->velocity == version && seen_->time == time && !boundary_.has_outflow();
  if (!is_known)
    seen_ = {version, time,
             transfer_.interpolate(GhostedVelocity<Dim>(boundary_, grid_.wide_face_dm(), velocity, time))};
  return seen_->water;
}

template <int Dim>
double SurfaceForcing<Dim>::lost_power(const Points<Dim>& before, const Points<Dim>& after, double dt) const {
  const Points<Dim> given = shared_out(forces_);
  const auto motions = motions_at(bodies_, time_ - 0.5 * dt);
  double lost = 0;
  for_each_acting([&](std::size_t p, std::size_t m) {
    const Point<Dim> own = motions[markers_.body_of(begin() + p)].velocity_at(states_[m].place);
    lost += given[m].dot(own - 0.5 * (before[m] + after[m]));
  });
  return ordered_sum(grid_.comm(), lost);
}

template <int Dim>
std::vector<double> SurfaceForcing<Dim>::slip_of_bodies(const Points<Dim>& water) const {
  std::vector<double> sums(2 * bodies_.size(), 0.0);
  for_each_acting([&](std::size_t p, std::size_t m) {
    const std::size_t b = markers_.body_of(begin() + p);
    sums[2 * b] += held(states_[m].velocity - water[m], p).squaredNorm();
    ++sums[2 * b + 1];
  });
  sums = ordered_sum(grid_.comm(), sums);
  std::vector<double> slips;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    slips.push_back(std::sqrt(sums[2 * b] / std::max(sums[2 * b + 1], 1.0)));
  return slips;
}

template Points<2> SurfaceForcing<2>::kept_by_sides(const std::optional<SideName>&) const;
template Points<3> SurfaceForcing<3>::kept_by_sides(const std::optional<SideName>&) const;
template Loads<2> SurfaceForcing<2>::loads() const;
template Loads<3> SurfaceForcing<3>::loads() const;
template Loads<2> SurfaceForcing<2>::loads_on_sides(const std::vector<SideName>&) const;
template Loads<3> SurfaceForcing<3>::loads_on_sides(const std::vector<SideName>&) const;
template Points<2> SurfaceForcing<2>::water_at_markers(Vec, double) const;
template Points<3> SurfaceForcing<3>::water_at_markers(Vec, double) const;
template double SurfaceForcing<2>::lost_power(const Points<2>&, const Points<2>&, double) const;
template double SurfaceForcing<3>::lost_power(const Points<3>&, const Points<3>&, double) const;
template std::vector<double> SurfaceForcing<2>::slip_of_bodies(const Points<2>&) const;
template std::vector<double> SurfaceForcing<3>::slip_of_bodies(const Points<3>&) const;

}  // namespace washfsi
