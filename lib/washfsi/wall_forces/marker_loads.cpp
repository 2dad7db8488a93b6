// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_forces/marker_loads.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// The part of each marker's force that sides take: where bodies cover them, of all sides; where none does, of one side.
template <int Dim>
Points<Dim> taken_by_sides(const WallForces<Dim>& walls, DM wide_face_dm, const std::optional<SideName>& open = {}) {
  const WallMarkers<Dim>& markers = walls.markers();
  const Transfer<Dim>& transfer = markers.transfer();
  Points<Dim> taken = markers.marker_forces(walls.forces());
  const petsc::LocalVector local(wide_face_dm);
  markers.boundary().fill_from_sides(local, markers.time(), transfer.reached_sides(), open);
  const Points<Dim> parts = transfer.interpolate_from_sides(local, open);
  for (std::size_t m = 0; m < taken.size(); ++m) taken[m] = taken[m].cwiseProduct(parts[m]);
  return taken;
}

}  // namespace

// The part of a body's force that acts on a side moving with the body is internal to the body.
template <int Dim>
Loads<Dim> marker_loads(const WallForces<Dim>& walls) {
  const WallMarkers<Dim>& markers = walls.markers();
  Loads<Dim> loads =
      markers.sliding().law() ? markers.sliding().law()->loads_here() : Loads<Dim>(markers.layout().bodies().size());
  const Points<Dim> given = markers.marker_forces(walls.forces());
  const Points<Dim> taken = taken_by_sides(walls, markers.grid().wide_face_dm());
  const auto motions = motions_at(markers.layout().bodies(), markers.time());
  markers.for_each_acting([&](std::size_t p, std::size_t m) {
    const std::size_t b = markers.body_of(p);
    loads[b].add(markers.states()[m].place - motions[b].center, taken[m] - given[m]);
  });
  return ordered_sum<Dim>(markers.grid().comm(), loads);
}

template <int Dim>
Loads<Dim> marker_loads_on_sides(const WallForces<Dim>& walls, const std::vector<SideName>& sides) {
  const WallMarkers<Dim>& markers = walls.markers();
  const Grid<Dim>& grid = markers.grid();
  Loads<Dim> loads(sides.size());
  const Point<Dim> middle = 0.5 * (grid.lower() + grid.upper());
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const SideName side = sides[s];
    if (!any_rank(grid.comm(), !markers.boundary().covers().cover_wholly(side.axis, side.end))) continue;
    const Points<Dim> taken = taken_by_sides(walls, grid.wide_face_dm(), side);
    markers.for_each_acting([&](std::size_t, std::size_t m) {
      Point<Dim> place = markers.states()[m].place;
      place[side.axis] = (side.end == End::lower ? grid.lower() : grid.upper())[side.axis];
      loads[s].add(place - middle, taken[m]);
    });
  }
  return ordered_sum<Dim>(grid.comm(), loads);
}

template <int Dim>
double lost_power(const WallForces<Dim>& walls, const Points<Dim>& before, const Points<Dim>& after, double dt) {
  const WallMarkers<Dim>& markers = walls.markers();
  const Points<Dim> given = markers.marker_forces(walls.forces());
  const auto motions = motions_at(markers.layout().bodies(), markers.time() - 0.5 * dt);
  double lost = 0;
  markers.for_each_acting([&](std::size_t p, std::size_t m) {
    const Point<Dim> own = motions[markers.body_of(p)].velocity_at(markers.states()[m].place);
    lost += given[m].dot(own - 0.5 * (before[m] + after[m]));
  });
  return ordered_sum(markers.grid().comm(), lost);
}

template <int Dim>
std::vector<double> slip_of_bodies(const WallMarkers<Dim>& markers, const Points<Dim>& water) {
  const std::size_t bodies = markers.layout().bodies().size();
  std::vector<double> sums(2 * bodies, 0.0);
  markers.for_each_acting([&](std::size_t p, std::size_t m) {
    const std::size_t b = markers.body_of(p);
    sums[2 * b] += markers.sliding().constrained(markers.states()[m].velocity - water[m], p).squaredNorm();
    ++sums[2 * b + 1];
  });
  sums = ordered_sum(markers.grid().comm(), sums);
  std::vector<double> slips;
  for (std::size_t b = 0; b < bodies; ++b) slips.push_back(std::sqrt(sums[2 * b] / std::max(sums[2 * b + 1], 1.0)));
  return slips;
}

template Loads<2> marker_loads(const WallForces<2>&);
template Loads<3> marker_loads(const WallForces<3>&);
template Loads<2> marker_loads_on_sides(const WallForces<2>&, const std::vector<SideName>&);
template Loads<3> marker_loads_on_sides(const WallForces<3>&, const std::vector<SideName>&);
template double lost_power(const WallForces<2>&, const Points<2>&, const Points<2>&, double);
template double lost_power(const WallForces<3>&, const Points<3>&, const Points<3>&, double);
template std::vector<double> slip_of_bodies(const WallMarkers<2>&, const Points<2>&);
template std::vector<double> slip_of_bodies(const WallMarkers<3>&, const Points<3>&);

}  // namespace washfsi
