// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_forces/wall_markers.hpp"

#include "washfsi/immersed_boundary/edge_nearness.hpp"
#include "washfsi/motion/turned.hpp"

namespace washfsi {

namespace {

constexpr DeltaOptions kernel{DeltaKernel::yang, 2, 2};

}  // namespace

template <int Dim>
MarkerLayout<Dim> wall_marker_layout(const Grid<Dim>& grid, const BodyTreatment& treatment) {
  return {.cell = grid.spacing(),
          .spacing = treatment.marker_spacing,
          .moments = KernelMoments(kernel.kernel, kernel.spread_width),
          .inner_water_slides = treatment.inner_water_slides,
          .comm = grid.comm()};
}

template <int Dim>
WallMarkers<Dim>::WallMarkers(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                              const std::vector<Body<Dim>>& bodies, const BodyTreatment& treatment, bool finds_edges)
    : grid_(grid),
      boundary_(boundary),
      bodies_(bodies),
      transfer_(grid, boundary, kernel),
      layout_(grid, bodies, wall_marker_layout(grid, treatment)),
      sliding_(layout_.own()) {
  if (finds_edges && layout_.any_is_sharp()) nearness_ = grid.face_vector();
}

template <int Dim>
void WallMarkers<Dim>::place(double time) {
  const PosedBodies<Dim> posed(bodies_, time);
  time_ = time;
  states_.clear();
  shares_.assign(layout_.own().size(), 0.0);
  Points<Dim> places;
  for (std::size_t p = layout_.own().begin; p < layout_.own().end; ++p) {
    bool acts = false;
    for (std::size_t m = layout_.start(p); m < layout_.start(p + 1); ++m) {
      states_.push_back(layout_.at(posed, p, m));
      places.push_back(states_.back().place);
      acts = acts || states_.back().acts;
    }
    // the share in a whole patch, so that a partly acting patch does not respond more than its overlap predicts
    if (acts) shares_[p - layout_.own().begin] = 1.0 / static_cast<double>(layout_.start(p + 1) - layout_.start(p));
  }
  transfer_.locate(places);
  interpolated_.reset();
  if (!nearness_) return;
  std::vector<bool> at_edges(states_.size(), false);
  const std::size_t first = layout_.start(layout_.own().begin);
  for_each_acting([&](std::size_t, std::size_t m) { at_edges[m] = layout_.is_sharp(first + m); });
  find_edge_nearness<Dim>(grid_, transfer_, at_edges, nearness_);
}

template <int Dim>
Points<Dim> WallMarkers<Dim>::turned(const Points<Dim>& values, bool into_space) const {
  return washfsi::turned<Dim>(values, bodies_, time_, into_space, [this](std::size_t p) { return body_of(p); });
}

template <int Dim>
Points<Dim> WallMarkers<Dim>::marker_forces(const Points<Dim>& of_patches) const {
  Points<Dim> result(states_.size(), Point<Dim>::Zero());
  for_each_acting(
      [&](std::size_t p, std::size_t m) { result[m] = shares_[p] * sliding_.constrained(of_patches[p], p); });
  return result;
}

template <int Dim>
Points<Dim> WallMarkers<Dim>::means(const Points<Dim>& of_markers) const {
  Points<Dim> result(layout_.own().size(), Point<Dim>::Zero());
  for_each_acting([&](std::size_t p, std::size_t m) { result[p] += shares_[p] * of_markers[m]; });
  for (std::size_t p = 0; p < result.size(); ++p) result[p] = sliding_.constrained(result[p], p);
  return result;
}

template <int Dim>
Points<Dim> WallMarkers<Dim>::water_velocities(Vec velocity, double time) const {
  const petsc::Version version(velocity);
  const bool is_known =
      interpolated_ && interpolated_->velocity == version && interpolated_->time == time && !boundary_.has_outflow();
  if (!is_known)
    interpolated_ = {version, time,
                     transfer_.interpolate(GhostedVelocity<Dim>(boundary_, grid_.wide_face_dm(), velocity, time))};
  return interpolated_->values;
}

template MarkerLayout<2> wall_marker_layout(const Grid<2>&, const BodyTreatment&);
template MarkerLayout<3> wall_marker_layout(const Grid<3>&, const BodyTreatment&);
template class WallMarkers<2>;
template class WallMarkers<3>;

}  // namespace washfsi
