// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/mask/mask.hpp"

#include <algorithm>
#include <limits>

#include "washfsi/grid/interpolate.hpp"
#include "washfsi/grid/subdivide.hpp"
#include "washfsi/mask/cut_faces.hpp"
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

// The cover by bodies at rest and, if `by_moving`, by moving ones.
template <int Dim>
Covered<Dim> covered(const Point<Dim>& place, const Point<Dim>& own, const std::vector<Body<Dim>>& bodies,
                     const PosedBodies<Dim>& posed, const FluidFraction& fraction_at, bool by_moving) {
  Point<Dim> velocity = own;
  double least = 1;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!by_moving && !bodies[b].motion.at_rest()) continue;
    const double H = fraction_at(posed.distance(b, place));
    if (H >= least) continue;
    least = H;
    velocity = H * own + (1 - H) * posed[b].velocity(place);
    if (H == 0) break;
  }
  return {velocity, 1 - least};
}

}  // namespace

template <int Dim>
Mask<Dim>::Mask(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const BodyTreatment& treatment)
    : grid_(grid),
      bodies_(bodies),
      treatment_(treatment),
      fraction_at_{smoothing_of(treatment, grid.spacing().maxCoeff()), rounding * grid.spacing().minCoeff()},
      constrained_depths_(bodies.size(), 0.0),
      any_moves_(std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return !body.motion.at_rest(); })) {
  if (empty()) return;
  create_fields();
  const PosedBodies<Dim> posed(bodies_, 0);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (bodies_[b].motion.at_rest()) place(posed, b);
  if (any_moves_) copy(fields_, resting_);
  if (treatment_.method == BodyMethod::cut_stencil) cuts_ = find_cut_faces(grid_, posed, fields_.body);
  update(0);
}

template <int Dim>
void Mask<Dim>::copy(const Fields& from, Fields& to) {
  const auto copy_field = [](const petsc::Vector& source, petsc::Vector& target) {
    if (!source) return;
    if (target)
      WASH_PETSC(VecCopy(source, target));
    else
      target = petsc::copy_of(source);
  };
  copy_field(from.fraction, to.fraction);
  copy_field(from.share, to.share);
  copy_field(from.body, to.body);
}

template <int Dim>
void Mask<Dim>::create_fields() {
  fields_.fraction = grid_.face_vector();
  WASH_PETSC(VecSet(fields_.fraction, 1.0));
  solid_velocity_ = grid_.face_vector();
  if (extrapolates()) constraint_velocity_ = grid_.face_vector();
  fields_.body = grid_.face_vector();
  WASH_PETSC(VecSet(fields_.body, -1.0));
  if (treatment_.method != BodyMethod::direct_forcing) return;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    constrained_depths_[b] = InnerWater::of(bodies_[b], grid_, treatment_.inner_water_slides).constrained_depth;
  fields_.share = petsc::copy_of(fields_.fraction);
}

template <int Dim>
void Mask<Dim>::update(double time) {
  if (!any_moves_) return;
  const petsc::LogPart part("bodies");
  const PosedBodies<Dim> posed(bodies_, time);
  copy(resting_, fields_);
  WASH_PETSC(VecZeroEntries(solid_velocity_));
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (!bodies_[b].motion.at_rest()) place(posed, b);
  if (treatment_.method == BodyMethod::cut_stencil) cuts_ = find_cut_faces(grid_, posed, fields_.body);
}

template <int Dim>
void Mask<Dim>::count_as_water(Vec near) {
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fields_.fraction), nearness(grid_.face_dm(), near);
  const FaceView<Dim> share(grid_.face_dm(), fluid_share());
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (fraction(face, c) == 1) share(face, c) = std::max(share(face, c), nearness(face, c));
  });
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
  const FaceView<Dim> holder(grid_.face_dm(), fields_.body), fraction(grid_.face_dm(), fields_.fraction);
  const bool moves = !bodies_[body].motion.at_rest();
  const auto number = static_cast<double>(body);
  const auto hold = [&](const Index<Dim>& face, int c, const Point<Dim>& place, double distance) {
    const double H = fraction_at_(distance), before = share(face, c);
    if (H == 1 || H > before || (H == before && holder(face, c) < number)) return;
    share(face, c) = H;
    holder(face, c) = number;
    solid(face, c) = moves ? posed[body].velocity(place)[c] : 0;
  };
  for_each_inside(posed, body, fraction_at_.half_width, hold);
  const double held = constrained_depths_[body];
  if (fields_.share)
    for_each_inside(posed, body, -held, [&](const Index<Dim>& face, int c, const Point<Dim>&, double distance) {
      if (distance < -held) fraction(face, c) = 0;
    });
}

template <int Dim>
typename SideCover<Dim>::Cover Mask<Dim>::cover(const PosedBodies<Dim>& posed) const {
  const auto by = [&](bool moving) {
    return [&, moving](const Point<Dim>& place, const Point<Dim>& own) {
      return covered(place, own, bodies_, posed, fraction_at_, moving);
    };
  };
  const auto to_moving = [&](const Point<Dim>& place) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      if (!bodies_[b].motion.at_rest()) least = std::min(least, posed.distance(b, place));
    return least;
  };
  return {by(true), by(false), to_moving, fraction_at_.half_width};
}

template <int Dim>
Constraint<Dim> Mask<Dim>::constraint() const {
  if (empty()) return {};
  return {fluid_fraction(), slides_ || extrapolates() ? constraint_velocity_ : solid_velocity_,
          treatment_.method == BodyMethod::cut_stencil ? &cuts_ : nullptr,
          treatment_.method == BodyMethod::mapping_variable};
}

template <int Dim>
void Mask<Dim>::extrapolate(Vec local_velocity, double time) {
  if (!extrapolates()) return;
  WASH_PETSC(VecCopy(solid_velocity_, constraint_velocity_));
  const PosedBodies<Dim> posed(bodies_, time);
  const ConstFaceView<Dim> u(grid_.wide_face_dm(), local_velocity);
  const ConstFaceView<Dim> holder(grid_.face_dm(), fields_.body);
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
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fields_.fraction), solid(grid_.face_dm(), solid_velocity_);
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
    for (int c = 0; c < Dim; ++c)
      u(face, c) = fraction(face, c) * u(face, c) + (1 - fraction(face, c)) * solid(face, c);
  });
}

template class Mask<2>;
template class Mask<3>;

}  // namespace washfsi
