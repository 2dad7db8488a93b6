// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/mask/mask.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "washfsi/grid/interpolate.hpp"
#include "washfsi/grid/subdivide.hpp"
#include "washfsi/mask/inner_water.hpp"
#include "washfsi/support/equal_parts.hpp"

namespace washfsi {

namespace {

constexpr double deep_inside = -std::numeric_limits<double>::max();
constexpr double rounding = 1e-9;  // [cells], so that a face on a surface counts as on it wherever the body is

double smoothing_of(const BodyTreatment& treatment, double cell) {
  if (treatment.method == BodyMethod::direct_forcing) return cell;
  return treatment.edge == MaskEdge::smooth ? 2 * cell : 0;
}

}  // namespace

template <int Dim>
Mask<Dim>::Mask(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const BodyTreatment& treatment)
    : grid_(grid),
      bodies_(bodies),
      treatment_(treatment),
      smoothing_(smoothing_of(treatment, grid.spacing().maxCoeff())),
      constrained_depths_(bodies.size(), 0.0),
      any_moves_(std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return !body.motion.at_rest(); })) {
  if (empty()) return;
  create_fields();
  const PosedBodies<Dim> posed(bodies_, 0);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (bodies_[b].motion.at_rest()) place(posed, b);
  if (any_moves_) {
    resting_fraction_ = petsc::copy_of(fraction_);
    if (share_) resting_share_ = petsc::copy_of(share_);
    resting_body_ = petsc::copy_of(body_);
  }
  if (treatment_.method == BodyMethod::cut_stencil) find_cuts(posed);
  update(0);
}

template <int Dim>
void Mask<Dim>::create_fields() {
  fraction_ = grid_.face_vector();
  WASH_PETSC(VecSet(fraction_, 1.0));
  solid_velocity_ = grid_.face_vector();
  if (extrapolates()) constraint_velocity_ = grid_.face_vector();
  body_ = grid_.face_vector();
  WASH_PETSC(VecSet(body_, -1.0));
  if (treatment_.method != BodyMethod::direct_forcing) return;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    constrained_depths_[b] = InnerWater::of(bodies_[b], grid_, treatment_.inner_water_slides).constrained_depth;
  share_ = petsc::copy_of(fraction_);
}

template <int Dim>
void Mask<Dim>::update(double time) {
  if (!any_moves_) return;
  const petsc::LogPart part("bodies");
  const PosedBodies<Dim> posed(bodies_, time);
  WASH_PETSC(VecCopy(resting_fraction_, fraction_));
  if (share_) WASH_PETSC(VecCopy(resting_share_, share_));
  WASH_PETSC(VecCopy(resting_body_, body_));
  WASH_PETSC(VecZeroEntries(solid_velocity_));
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (!bodies_[b].motion.at_rest()) place(posed, b);
  if (treatment_.method == BodyMethod::cut_stencil) find_cuts(posed);
}

template <int Dim>
void Mask<Dim>::count_as_water(Vec near) {
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fraction_), nearness(grid_.face_dm(), near);
  const FaceView<Dim> share(grid_.face_dm(), fluid_share());
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (fraction(face, c) == 1) share(face, c) = std::max(share(face, c), nearness(face, c));
  });
}

// H as a function of the signed distance (thesis 4.2).
template <int Dim>
double Mask<Dim>::fraction_at(double distance) const {
  const double on_surface = rounding * grid_.spacing().minCoeff();
  if (std::abs(distance) >= smoothing_) return distance > on_surface ? 1 : distance < -on_surface ? 0 : 0.5;
  const double x = distance / smoothing_;
  return 0.5 * (1 + x + std::sin(std::numbers::pi * x) / std::numbers::pi);
}

// Calls visit(face, component, place, distance) for this rank's faces of cells that are less than `reach` before the
// surface of a body or behind it, with a very small distance where they are farther behind it; a negative reach takes a
// surface so far behind. Ranks share the work: a body may lie in the cells of one. Collective.
template <int Dim>
template <class Visit>
void Mask<Dim>::for_each_inside(const PosedBodies<Dim>& posed, std::size_t body, double reach,
                                const Visit& visit) const {
  const double depth = std::max(0.0, -reach);
  std::vector<Index<Dim>> near;
  subdivide<Dim>(
      grid_, grid_.owned(), std::max(0.0, reach),
      [&](const Point<Dim>& place) { return posed.distance(body, place) + depth; },
      [&](const Box<Dim>& part, int sign) {
        if (sign < 0)
          for_each<Dim>(part, [&](const Index<Dim>& face) {
            for (int c = 0; c < Dim; ++c) visit(face, c, grid_.face_center(face, c), deep_inside);
          });
      },
      [&](const Index<Dim>& cell) { near.push_back(cell); });
  Points<Dim> places;
  for (const auto& face : near)
    for (int c = 0; c < Dim; ++c) places.push_back(grid_.face_center(face, c));
  const std::vector<double> distances =
      shared_values<Dim>(grid_.comm(), places, [&](const Point<Dim>& place) { return posed.distance(body, place); });
  for (std::size_t n = 0; n < places.size(); ++n)
    visit(near[n / Dim], static_cast<int>(n % Dim), places[n], distances[n]);
}

// Where bodies overlap, a face belongs to the one with the smallest fluid fraction; among equals, to the one named
// first.
template <int Dim>
void Mask<Dim>::place(const PosedBodies<Dim>& posed, std::size_t body) {
  const FaceView<Dim> share(grid_.face_dm(), fluid_share()), solid(grid_.face_dm(), solid_velocity_);
  const FaceView<Dim> holder(grid_.face_dm(), body_), fraction(grid_.face_dm(), fraction_);
  const bool moves = !bodies_[body].motion.at_rest();
  const auto number = static_cast<double>(body);
  const auto hold = [&](const Index<Dim>& face, int c, const Point<Dim>& place, double distance) {
    const double H = fraction_at(distance), before = share(face, c);
    if (H == 1 || H > before || (H == before && holder(face, c) < number)) return;
    share(face, c) = H;
    holder(face, c) = number;
    solid(face, c) = moves ? posed[body].velocity(place)[c] : 0;
  };
  for_each_inside(posed, body, smoothing_, hold);
  const double held = constrained_depths_[body];
  if (share_)
    for_each_inside(posed, body, -held, [&](const Index<Dim>& face, int c, const Point<Dim>&, double distance) {
      if (distance < -held) fraction(face, c) = 0;
    });
}

// The cover by bodies at rest and, if `by_moving`, by moving ones.
template <int Dim>
Covered<Dim> Mask<Dim>::covered(const Point<Dim>& place, const Point<Dim>& own, const PosedBodies<Dim>& posed,
                                bool by_moving) const {
  Point<Dim> velocity = own;
  double least = 1;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!by_moving && !bodies_[b].motion.at_rest()) continue;
    const double H = fraction_at(posed.distance(b, place));
    if (H >= least) continue;
    least = H;
    velocity = H * own + (1 - H) * posed[b].velocity(place);
    if (H == 0) break;
  }
  return {velocity, 1 - least};
}

template <int Dim>
typename SideCover<Dim>::Cover Mask<Dim>::cover(const PosedBodies<Dim>& posed) const {
  const auto by = [&](bool moving) {
    return [&, moving](const Point<Dim>& place, const Point<Dim>& own) { return covered(place, own, posed, moving); };
  };
  const auto to_moving = [&](const Point<Dim>& place) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      if (!bodies_[b].motion.at_rest()) least = std::min(least, posed.distance(b, place));
    return least;
  };
  return {by(true), by(false), to_moving, smoothing_};
}

template <int Dim>
Constraint<Dim> Mask<Dim>::constraint() const {
  if (empty()) return {};
  return {fraction_, slides_ || extrapolates() ? constraint_velocity_ : solid_velocity_,
          treatment_.method == BodyMethod::cut_stencil ? &cuts_ : nullptr,
          treatment_.method == BodyMethod::mapping_variable};
}

template <int Dim>
void Mask<Dim>::find_cuts(const PosedBodies<Dim>& posed) {
  constexpr double shortest = 1e-3;
  const petsc::LocalVector local_body(grid_.face_dm(), body_);
  const ConstFaceView<Dim> near_body(grid_.face_dm(), local_body);
  const FaceView<Dim> holder(grid_.face_dm(), body_);
  cuts_.clear();
  const auto arm_towards = [&](const CutFace<Dim>& cut, PetscInt step) -> typename CutFace<Dim>::Arm {
    const Index<Dim> neighbour = shifted<Dim>(cut.face, cut.axis, step);
    if (near_body(neighbour, cut.component) < 0) return {};
    if (!grid_.periodic(cut.axis) && grid_.inside(neighbour) != neighbour) return {};  // beyond the box
    const auto body = static_cast<std::size_t>(near_body(neighbour, cut.component));
    const Point<Dim> from = grid_.face_center(cut.face, cut.component);
    const Point<Dim> to = grid_.face_center(neighbour, cut.component);
    const double here = posed.distance(body, from), there = posed.distance(body, to);
    const double length = std::max(shortest, here / (here - there));
    holder(cut.face, cut.component) = static_cast<double>(body);  // its constraint force loads the body
    return {true, length, posed[body].velocity(from + length * (to - from))[cut.component]};
  };
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (near_body(face, c) >= 0) return;
    for (int axis = 0; axis < Dim; ++axis) {
      if (near_body(shifted<Dim>(face, axis, -1), c) < 0 && near_body(shifted<Dim>(face, axis, 1), c) < 0) continue;
      CutFace<Dim> cut{face, c, axis, {}, {}};
      cut.lower = arm_towards(cut, -1);
      cut.upper = arm_towards(cut, 1);
      if (cut.lower.cut || cut.upper.cut) cuts_.push_back(cut);
    }
  });
}

template <int Dim>
void Mask<Dim>::extrapolate(Vec local_velocity, double time) {
  if (!extrapolates()) return;
  WASH_PETSC(VecCopy(solid_velocity_, constraint_velocity_));
  const PosedBodies<Dim> posed(bodies_, time);
  const ConstFaceView<Dim> u(grid_.wide_face_dm(), local_velocity);
  const ConstFaceView<Dim> holder(grid_.face_dm(), body_);
  const FaceView<Dim> held(grid_.face_dm(), constraint_velocity_);
  const double reach = grid_.spacing().minCoeff();  // from the wall to where the water's velocity is taken
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (holder(face, c) < 0) return;
    const auto body = static_cast<std::size_t>(holder(face, c));
    const Point<Dim> place = grid_.face_center(face, c);
    const double depth = -posed.distance(body, place);
    if (depth > reach) return;
    const Point<Dim> normal = posed.normal(body, place, 1e-3 * reach);
    const Point<Dim> wall = place + depth * normal, probe = wall + reach * normal;
    const double wall_velocity = posed[body].velocity(wall)[c];
    held(face, c) = wall_velocity + depth / reach * (wall_velocity - interpolate_face<Dim>(grid_, u, probe, c));
  });
}

template <int Dim>
void Mask<Dim>::apply(Vec velocity) const {
  if (empty()) return;
  const FaceView<Dim> u(grid_.face_dm(), velocity);
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fraction_), solid(grid_.face_dm(), solid_velocity_);
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
    for (int c = 0; c < Dim; ++c)
      u(face, c) = fraction(face, c) * u(face, c) + (1 - fraction(face, c)) * solid(face, c);
  });
}

template class Mask<2>;
template class Mask<3>;

}  // namespace washfsi
