// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/body/mask.hpp"

#include <algorithm>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
Mask<Dim>::Mask(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, BodyMethod method)
    : grid_(grid),
      bodies_(bodies),
      method_(method),
      fraction_(grid.face_vector()),
      solid_velocity_(grid.face_vector()),
      body_(grid.face_vector()),
      resting_(grid.face_vector()) {
  place_bodies_at_rest();
  update(0);
}

template <int Dim>
void Mask<Dim>::place_bodies_at_rest() {
  const FaceView<Dim> holder(grid_.face_dm(), resting_);
  for (int c = 0; c < Dim; ++c)
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
      holder(face, c) = -1;
      const Point<Dim> place = grid_.face_center(face, c);
      for (std::size_t b = 0; b < bodies_.size() && holder(face, c) < 0; ++b)
        if (bodies_[b].motion.at_rest() && bodies_[b].distance(place, 0) <= 0) holder(face, c) = static_cast<double>(b);
    });
}

template <int Dim>
void Mask<Dim>::update(double time) {
  const petsc::LogPart part("bodies");
  const FaceView<Dim> fraction(grid_.face_dm(), fraction_), solid(grid_.face_dm(), solid_velocity_);
  const FaceView<Dim> holder(grid_.face_dm(), body_);
  const ConstFaceView<Dim> resting(grid_.face_dm(), resting_);
  std::vector<typename RigidMotion<Dim>::Pose> poses;
  for (const auto& body : bodies_) poses.push_back(body.motion.pose(time));
  const auto distance_to = [&](std::size_t b, const Point<Dim>& place) {
    return bodies_[b].shape->distance(poses[b].in_body_frame(place));
  };
  for (int c = 0; c < Dim; ++c)
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
      const Point<Dim> place = grid_.face_center(face, c);
      const bool at_rest = resting(face, c) >= 0;
      std::size_t b = at_rest ? static_cast<std::size_t>(resting(face, c)) : 0;
      while (!at_rest && b < bodies_.size() && (bodies_[b].motion.at_rest() || distance_to(b, place) > 0)) ++b;
      const bool fluid = b == bodies_.size();
      holder(face, c) = fluid ? -1 : static_cast<double>(b);
      fraction(face, c) = fluid ? 1 : 0;
      solid(face, c) = 0;
      if (fluid) return;
      if (distance_to(b, place) == 0) fraction(face, c) = 0.5;
      if (!at_rest) solid(face, c) = bodies_[b].motion.velocity(place, time)[c];
    });
  if (method_ == BodyMethod::cut_stencil) find_cuts(time);
}

template <int Dim>
Constraint<Dim> Mask<Dim>::constraint() const {
  if (empty()) return {};
  return {fraction_, solid_velocity_, method_ == BodyMethod::cut_stencil ? &cuts_ : nullptr};
}

template <int Dim>
void Mask<Dim>::find_cuts(double time) {
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fraction_);
  const FaceView<Dim> holder(grid_.face_dm(), body_);
  cuts_.clear();
  for (int c = 0; c < Dim; ++c)
    for_each<Dim>(grid_.inner_faces(c), [&](const Index<Dim>& face) {
      if (fraction(face, c) < 1) return;
      const double here = nearest_distance(bodies_, grid_.face_center(face, c), time);
      if (here > grid_.spacing().maxCoeff()) return;
      for (int axis = 0; axis < Dim; ++axis) {
        CutFace<Dim> cut{face, c, axis, {}, {}};
        int body = -1;
        cut.lower = arm_towards(face, c, axis, -1, time, here, body);
        cut.upper = arm_towards(face, c, axis, 1, time, here, body);
        if (body < 0) continue;
        cuts_.push_back(cut);
        holder(face, c) = body;  // what holds this face back is the body's load
      }
    });
}

// The arm of a stencil that starts `here` from the nearest body; `body` becomes the body that cuts it.
template <int Dim>
typename CutFace<Dim>::Arm Mask<Dim>::arm_towards(const Index<Dim>& face, int component, int axis, int step,
                                                  double time, double here, int& body) const {
  constexpr double shortest = 1e-3;
  Point<Dim> place = grid_.face_center(face, component);
  const Point<Dim> start = place;
  place[axis] += step * grid_.spacing()[axis];
  if (!grid_.contains(place)) return {};
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const double there = bodies_[b].distance(place, time);
    if (there > 0) continue;
    const double from = std::max(here, bodies_[b].distance(start, time));
    const double length = std::max(shortest, from / (from - there));
    const Point<Dim> wall = start + length * (place - start);
    body = static_cast<int>(b);
    return {true, length, bodies_[b].motion.velocity(wall, time)[component]};
  }
  return {};
}

template <int Dim>
void Mask<Dim>::hold(Vec velocity) const {
  if (empty()) return;
  const FaceView<Dim> u(grid_.face_dm(), velocity);
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fraction_), solid(grid_.face_dm(), solid_velocity_);
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
    for (int c = 0; c < Dim; ++c)
      u(face, c) = fraction(face, c) * u(face, c) + (1 - fraction(face, c)) * solid(face, c);
  });
}

/// Force and torque of each body, one after another in a flat list.
template <int Dim>
struct Mask<Dim>::Sums {
  static constexpr std::size_t width = Dim + rotation_components<Dim>;
  std::vector<double> values;

  void add(std::size_t body, const Point<Dim>& arm, const Point<Dim>& force) {
    const Rotation<Dim> torque = cross<Dim>(arm, force);
    for (std::size_t c = 0; c < Dim; ++c) values[width * body + c] += force[static_cast<int>(c)];
    for (std::size_t r = Dim; r < width; ++r) values[width * body + r] += torque[static_cast<int>(r - Dim)];
  }
};

template <int Dim>
void Mask<Dim>::add_constraint_force(Vec constraint_force, Vec density, double time, Sums& sums) const {
  const ConstFaceView<Dim> f(grid_.face_dm(), constraint_force), rho(grid_.face_dm(), density);
  const ConstFaceView<Dim> holder(grid_.face_dm(), body_), fraction(grid_.face_dm(), fraction_);
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (holder(face, c) < 0) return;
    const auto b = static_cast<std::size_t>(holder(face, c));
    const Point<Dim> place = grid_.face_center(face, c);
    const RigidMotion<Dim>& motion = bodies_[b].motion;
    const double inertia = (1 - fraction(face, c)) * rho(face, c) * motion.acceleration(place, time)[c];
    Point<Dim> force = Point<Dim>::Zero();
    force[c] = grid_.cell_volume() * (inertia - f(face, c));
    sums.add(b, place - motion.center_at(time), force);
  });
}

// A drum reaches to the box, whose walls take a part of what the water does to it: the pressure of their cells.
template <int Dim>
void Mask<Dim>::add_wall_pressure(Vec pressure, double time, Sums& sums) const {
  const ConstCellView<Dim> p(grid_.cell_dm(), pressure);
  for (int d = 0; d < Dim; ++d) {
    if (grid_.periodic(d)) continue;
    const auto axis = static_cast<std::size_t>(d);
    const double area = grid_.cell_volume() / grid_.spacing()[d];
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
      const bool at_lower = cell[axis] == 0, at_upper = cell[axis] == grid_.cells()[axis] - 1;
      if (!at_lower && !at_upper) return;
      const Point<Dim> place = grid_.cell_center(cell);
      for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (bodies_[b].distance(place, time) > 0) continue;
        Point<Dim> force = Point<Dim>::Zero();
        force[d] = (at_upper ? area : 0) * p(cell) - (at_lower ? area : 0) * p(cell);
        sums.add(b, place - bodies_[b].motion.center_at(time), force);
        break;
      }
    });
  }
}

template <int Dim>
std::vector<Load<Dim>> Mask<Dim>::loads(Vec constraint_force, Vec density, Vec pressure, double time) const {
  Sums sums{std::vector<double>(Sums::width * bodies_.size(), 0.0)};
  add_constraint_force(constraint_force, density, time, sums);
  add_wall_pressure(pressure, time, sums);
  sums.values = ordered_sum(grid_.comm(), sums.values);
  std::vector<Load<Dim>> loads(bodies_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const double* values = &sums.values[Sums::width * b];
    loads[b].force = Point<Dim>(values);
    loads[b].torque = Eigen::Map<const Rotation<Dim>>(values + Dim);
  }
  return loads;
}

template class Mask<2>;
template class Mask<3>;

}  // namespace washfsi
