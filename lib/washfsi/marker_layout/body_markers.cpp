// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/marker_layout/body_markers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Times at which a motion is sampled.
template <int Dim>
std::vector<double> sample_times(const RigidMotion<Dim>& motion, double size) {
  constexpr int count = 200;
  if (motion.only_turns()) return {0};
  double end = motion.period();
  if (motion.table) end = motion.table->end();
  if (end == 0) end = 2 * size / motion.translation.norm();  // by when it has left the box
  std::vector<double> times;
  for (int n = 0; n <= count; ++n) times.push_back(end * n / count);
  return times;
}

// Whether no ball of a radius of two cells fits into the shape where a marker is: at edges, and in thin parts.
template <int Dim>
bool fits_no_ball(const Shape<Dim>& shape, const Point<Dim>& marker, double cell) {
  const double radius = 2 * cell, depth = -shape.distance(marker);
  const Point<Dim> out = distance_gradient<Dim>(shape, marker, 0.5 * cell);
  const Point<Dim> middle = marker - (radius - depth) * out.normalized();
  return out.norm() < 0.5 || shape.distance(middle) > -0.9 * radius;
}

}  // namespace

template <int Dim>
BodyMarkers<Dim>::BodyMarkers(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, MarkerLayout<Dim> layout)
    : grid_(grid),
      bodies_(bodies),
      depth_(layout.cell.minCoeff() * layout.moments.retraction(std::numeric_limits<double>::max())) {
  std::vector<Surface<Dim>> surfaces;
  for (const Body<Dim>& body : bodies) {
    layout.inside = InnerWater::of(body, grid, layout.inner_water_slides);
    for (int d = 0; d < Dim; ++d) layout.period[d] = body.repeats.spans(d) ? body.repeats.period[d] : 0;
    surfaces.push_back({body.shape.get(), region(body), layout});
  }
  by_body_ = surface_markers<Dim>(surfaces);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const MarkerPatches<Dim>& patches = by_body_[b];
    firsts_.push_back(body_of_.size());
    for (std::size_t p = 0; p < patches.size(); ++p) starts_.push_back(arms_.size() + patches.starts[p]);
    arms_.insert(arms_.end(), patches.markers.begin(), patches.markers.end());
    body_of_.insert(body_of_.end(), patches.size(), b);
  }
  starts_.push_back(arms_.size());
  follow_own(layout);
}

template <int Dim>
void BodyMarkers<Dim>::follow_own(const MarkerLayout<Dim>& layout) {
  const auto rank = static_cast<std::size_t>(rank_of(grid_.comm())),
             ranks = static_cast<std::size_t>(ranks_of(grid_.comm()));
  own_ = {patches() * rank / ranks, patches() * (rank + 1) / ranks};
  for (std::size_t p = own_.begin; p < own_.end; ++p)
    for (std::size_t m = start(p); m < start(p + 1); ++m)
      sharp_.push_back(fits_no_ball<Dim>(*bodies_[body_of_[p]].shape, arms_[m], layout.cell.maxCoeff()));
  any_is_sharp_ = any_rank(grid_.comm(), std::find(sharp_.begin(), sharp_.end(), true) != sharp_.end());
  seen_.assign(sharp_.size() * bodies_.size(), {Point<Dim>::Zero(), -depth_});
}

// Along axes of periodicity all of the body is in the box; if it spans the box, one period of it.
template <int Dim>
Bounds<Dim> BodyMarkers<Dim>::region(const Body<Dim>& body) const {
  Bounds<Dim> region = region_of_one(body);
  const Repeats<Dim>& repeats = body.repeats;
  const Bounds<Dim>& own = repeats.extent.bounds;
  const auto take_all = [&](int axis) {
    if (!repeats.extent.is_finite(axis)) return;
    region.lower[axis] = own.lower[axis] - 2 * grid_.spacing().maxCoeff();  // with room for seeds
    region.upper[axis] = own.upper[axis] + 2 * grid_.spacing().maxCoeff();
  };
  const auto repeats_along = [&](int axis) { return repeats.period[axis] > 0 && !repeats.spans(axis); };
  const auto pose = body.motion.pose(0);
  const bool turned = body.motion.turns() || pose.sine != 0 || pose.cosine != 1;
  for (int d = 0; d < Dim; ++d) {
    const bool with_other = d < 2 && turned && (repeats_along(0) || repeats_along(1));
    if (repeats_along(d) || with_other) take_all(d);
    if (!repeats.spans(d)) continue;
    region.lower[d] = -0.5 * repeats.period[d];
    region.upper[d] = 0.5 * repeats.period[d];
  }
  return region;
}

// The region for one body without images; a body at rest keeps its angle.
template <int Dim>
Bounds<Dim> BodyMarkers<Dim>::region_of_one(const Body<Dim>& body) const {
  const RigidMotion<Dim>& motion = body.motion;
  const Point<Dim> low = grid_.lower(), high = grid_.upper();
  if (motion.at_rest()) {
    const auto pose = motion.pose(0);
    if (pose.sine == 0 && pose.cosine == 1) return {low - pose.center, high - pose.center};
  }
  double arm = 0;
  Bounds<Dim> region = Bounds<Dim>::round(Point<Dim>::Zero(), Point<Dim>::Zero());
  for (const double time : sample_times(motion, (high - low).norm())) {
    const Point<Dim> center = motion.center_at(time);
    region.include({low - center, high - center});
    arm = std::max(arm, (low - center).cwiseAbs().cwiseMax((high - center).cwiseAbs()).template head<2>().norm());
  }
  region.lower.template head<2>().setConstant(-arm);
  region.upper.template head<2>().setConstant(arm);
  return region;
}

// A distance changes at most by the way moved, so it is not recomputed before its sign could have changed.
template <int Dim>
bool BodyMarkers<Dim>::is_covered(const PosedBodies<Dim>& posed, std::size_t body, std::size_t marker,
                                  const Point<Dim>& place) {
  for (std::size_t other = 0; other < posed.size(); ++other) {
    if (other == body) continue;
    if (bodies_[other].repeats.any()) {  // images do not turn about the body's centre with its frame
      if (posed.distance(other, place) < -depth_) return true;
      continue;
    }
    const Point<Dim> now = posed.in_body_frame(other, place);
    auto& [then, distance] = seen_[(marker - start(own_.begin)) * posed.size() + other];
    if ((now - then).norm() >= std::abs(distance + depth_)) {
      then = now;
      distance = bodies_[other].shape->distance(now);
    }
    if (distance < -depth_) return true;
  }
  return false;
}

// A marker that moves along a side at rest, nearer than the faces beside the side, could not impose its velocity.
template <int Dim>
bool BodyMarkers<Dim>::touches_a_side(const Body<Dim>& body, const Point<Dim>& place) const {
  if (body.motion.at_rest()) return false;
  for (int d = 0; d < Dim; ++d) {
    const double near = 0.5 * grid_.spacing()[d];
    if (!grid_.periodic(d) && (place[d] < grid_.lower()[d] + near || place[d] > grid_.upper()[d] - near)) return true;
  }
  return false;
}

template <int Dim>
typename BodyMarkers<Dim>::State BodyMarkers<Dim>::at(const PosedBodies<Dim>& posed, std::size_t patch,
                                                      std::size_t marker) {
  const std::size_t b = body_of_[patch];
  const Point<Dim> place = posed.in_space(b, arms_[marker]);
  const bool is_within = grid_.contains(place), covered = is_within && is_covered(posed, b, marker, place);
  if (!is_within || covered || touches_a_side(bodies_[b], place))
    return {0.5 * (grid_.lower() + grid_.upper()), Point<Dim>::Zero(), false, covered};
  return {place, posed.motion(b).velocity_at(place), true};
}

template class BodyMarkers<2>;
template class BodyMarkers<3>;

}  // namespace washfsi
