// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/mask/control_volume.hpp"

#include <algorithm>
#include <limits>

#include "washfsi/grid/subdivide.hpp"
#include "washfsi/grid/velocity_gradient.hpp"

namespace washfsi {

namespace {

constexpr double width_in_cells = 16, least_width_in_cells = 4;

/// Falls from 1 for x <= 1/4 to 0 for x >= 3/4, with two continuous derivatives.
double smooth_step(double x) {
  const double y = std::clamp(2 * x - 0.5, 0.0, 1.0);
  return 1 - y * y * y * (10 - y * (15 - 6 * y));
}

/// Central difference at a cell's centre, of values at cell centres.
template <int Dim, class Value>
auto central_difference(const Value& value, const Index<Dim>& cell, int axis, double spacing) {
  const auto above = value(shifted<Dim>(cell, axis, 1)), below = value(shifted<Dim>(cell, axis, -1));
  return decltype(above)((above - below) / (2 * spacing));
}

}  // namespace

template <int Dim>
ControlVolumes<Dim>::ControlVolumes(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                    const std::vector<Body<Dim>>& bodies)
    : grid_(grid),
      boundary_(boundary),
      bodies_(bodies),
      all_at_rest_(std::all_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.motion.at_rest(); })),
      weights_(bodies.size()),
      mean_velocity_(grid.face_vector()) {
  const PosedBodies<Dim> posed(bodies_, 0);
  const double cell = grid.spacing().maxCoeff();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    widths_.push_back(std::max(std::min(width_in_cells * cell, 0.5 * posed[b].gap()), least_width_in_cells * cell));
    WASH_PETSC(DMCreateLocalVector(grid.cell_dm(), weights_[b].put()));
    weigh(posed, b, weights_[b]);
  }
}

template <int Dim>
double ControlVolumes<Dim>::distance_to_sides(const Point<Dim>& place) const {
  double nearest = std::numeric_limits<double>::max();
  for (int d = 0; d < Dim; ++d)
    if (!grid_.periodic(d)) nearest = std::min({nearest, place[d] - grid_.lower()[d], grid_.upper()[d] - place[d]});
  return nearest;
}

// The weight, from the share of the way from the body to the next wall or to the end of the layer.
template <int Dim>
double ControlVolumes<Dim>::weight_at(const PosedBodies<Dim>& posed, std::size_t body, const Point<Dim>& place) const {
  const double own = posed.distance(body, place);
  double others = distance_to_sides(place);
  for (std::size_t b = 0; b < posed.size(); ++b)
    if (b < body || (b > body && own > 0)) others = std::min(others, posed.distance(b, place));
  const bool held_by_earlier = own <= 0 && body > 0 && others <= 0 && grid_.contains(place);
  if (own <= 0) return held_by_earlier ? 0 : 1;
  return others <= 0 ? 0 : smooth_step(own / std::min(own + others, widths_[body]));
}

template <int Dim>
void ControlVolumes<Dim>::weigh(const PosedBodies<Dim>& posed, std::size_t body, Vec weight) const {
  WASH_PETSC(VecZeroEntries(weight));
  const CellView<Dim> w(grid_.cell_dm(), weight);
  const auto weigh_cell = [&](const Index<Dim>& cell) { w(cell) = weight_at(posed, body, grid_.cell_center(cell)); };
  subdivide<Dim>(
      grid_, grid_.owned().widened(), widths_[body],
      [&](const Point<Dim>& place) { return posed.distance(body, place); },
      [&](const Box<Dim>& part, int sign) {
        if (sign < 0) for_each<Dim>(part, weigh_cell);
      },
      weigh_cell);
}

template <int Dim>
Loads<Dim> ControlVolumes<Dim>::loads(const Step& step) {
  WASH_PETSC(VecAXPBYPCZ(mean_velocity_, 0.5, 0.5, 0.0, step.velocity_before, step.velocity));
  const GhostedVelocity<Dim> local_velocity(boundary_, grid_.face_dm(), mean_velocity_, step.time);
  const double middle = step.time - 0.5 * step.dt;
  const PosedBodies<Dim> posed(bodies_, middle);
  Loads<Dim> loads(bodies_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!all_at_rest_) weigh(posed, b, weights_[b]);
    with_viscosity<Dim>(grid_, step.viscosity, [&](const auto& viscosity) {
      add_stress(step, viscosity, weights_[b], local_velocity, posed[b], loads[b]);
    });
    add_inertia(step, weights_[b], posed[b], loads[b]);
  }
  return ordered_sum<Dim>(grid_.comm(), loads);
}

template <int Dim>
template <class Form>
void ControlVolumes<Dim>::add_stress(const Step& step, const Form& viscosity, Vec weight, Vec local_velocity,
                                     const PosedBody<Dim>& body, Load<Dim>& load) const {
  const ConstCellView<Dim> w(grid_.cell_dm(), weight), p(grid_.cell_dm(), step.pressure);
  const ConstFaceView<Dim> u(grid_.face_dm(), local_velocity), rho(grid_.face_dm(), step.density);
  const Point<Dim> h = grid_.spacing();
  const Spacing<Dim> spacing(h);
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
    Point<Dim> slope;
    for (int d = 0; d < Dim; ++d) slope[d] = central_difference<Dim>(w, cell, d, h[d]);
    if (slope.isZero(0)) return;
    Point<Dim> velocity;
    for (int c = 0; c < Dim; ++c) velocity[c] = cell_velocity<Dim>(u, cell, c);
    const Gradient<Dim> rate = velocity_gradient<Dim>(u, cell, spacing);
    const Point<Dim> viscous = viscosity.scale * viscosity.in_cell(cell) * (rate + rate.transpose()) * slope;
    const Point<Dim> carried = rho(cell, 0) * velocity.dot(slope) * velocity;
    load.add(body.arm(grid_.cell_center(cell)), grid_.cell_volume() * (carried + p(cell) * slope - viscous));
  });
}

template <int Dim>
void ControlVolumes<Dim>::add_inertia(const Step& step, Vec weight, const PosedBody<Dim>& body, Load<Dim>& load) const {
  const ConstCellView<Dim> w(grid_.cell_dm(), weight);
  const ConstFaceView<Dim> before(grid_.face_dm(), step.velocity_before), after(grid_.face_dm(), step.velocity);
  const ConstFaceView<Dim> rho(grid_.face_dm(), step.density), f(grid_.face_dm(), step.force);
  const ConstFaceView<Dim> fraction(grid_.face_dm(), step.fluid_fraction);
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    const double share = 0.5 * (w(face) + w(shifted<Dim>(face, c, -1)));
    if (share == 0) return;
    const Point<Dim> place = grid_.face_center(face, c);
    double inertia = f(face, c) - step.mean_gradient[c] - rho(face, c) * (after(face, c) - before(face, c)) / step.dt;
    inertia *= share;
    if (share == 1 && fraction(face, c) < 1)
      inertia += (1 - fraction(face, c)) * rho(face, c) * body.acceleration(place)[c];
    Point<Dim> part = Point<Dim>::Zero();
    part[c] = grid_.cell_volume() * inertia;
    load.add(body.arm(place), part);
  });
}

template class ControlVolumes<2>;
template class ControlVolumes<3>;

}  // namespace washfsi
