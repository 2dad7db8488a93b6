// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/step_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
std::vector<double> mobility_per_area(const Model<Dim>& model) {
  const std::vector<double>&areas = model.cloths.marker_areas(), &masses = model.cloths.marker_masses();
  if (model.has_fluid)
    return row_sum_mobility<Dim>(model.transfer, model.grid, model.boundary, model.liquid.density(), nullptr, areas);
  std::vector<double> mobility;
  for (std::size_t m = 0; m < masses.size(); ++m) mobility.push_back(areas[m] / masses[m]);
  return mobility;
}

template <int Dim>
double cloth_step_bound(const Model<Dim>& model) {
  if (model.cloths.marker_count() == 0) return std::numeric_limits<double>::infinity();
  const std::vector<double> mobility = mobility_per_area(model);
  std::vector<StiffnessBound> bounds(model.cloths.owned());
  for (const auto& force : model.forces.list()) force->add_bound(bounds);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < mobility.size(); ++m) {
    const double damping = bounds[m].damping, undamped2 = 1 / (mobility[m] * bounds[m].stiffness);  // (2/omega)^2
    shortest = std::min(shortest, std::sqrt(damping * damping + undamped2) - damping);
  }
  return -largest(model.grid.comm(), -shortest);
}

template <int Dim>
double flow_time(const Model<Dim>& model, const BodySpeeds<Dim>& bodies) {
  double speed = 0;
  WASH_PETSC(VecNorm(model.fluid.velocity(), NORM_INFINITY, &speed));
  speed = std::max(speed, model.boundary.largest_speed(0));
  for (std::size_t b = 0; b < model.body_list.size(); ++b)
    speed = std::max(speed, bodies.arm(b) > 0 ? model.body_list[b].motion.largest_speed(bodies.arm(b)) : 0.0);
  return speed > 0 ? model.grid.spacing().minCoeff() / speed : std::numeric_limits<double>::infinity();
}

// How far from its centre a body comes, of what reaches into the middles of cells or so near to them. Collective.
template <int Dim>
double arm_of(const Grid<Dim>& grid, const PosedBodies<Dim>& posed, std::size_t body, double near) {
  double arm = 0;
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    const Point<Dim> place = grid.cell_center(cell);
    if (posed.distance(body, place) <= near) arm = std::max(arm, posed[body].arm(place).norm());
  });
  return largest(grid.comm(), arm);
}

template <int Dim>
BodySpeeds<Dim>::BodySpeeds(const Model<Dim>& model) : model_(model) {
  const PosedBodies<Dim> posed(model.body_list, 0);
  for (std::size_t b = 0; b < model.body_list.size(); ++b) {
    const double arm = arm_of(model.grid, posed, b, 0);
    // a sheet may lie between the middles
    arms_.push_back(arm > 0 ? arm : arm_of(model.grid, posed, b, 0.5 * model.grid.spacing().norm()));
  }
}

template <int Dim>
double BodySpeeds<Dim>::longest_step(double time, double dt, double courant) const {
  constexpr double ahead = 1.5;  // a body that already moves counts with the flow
  constexpr int most_trials = 60;
  const double most = ahead * courant * model_.grid.spacing().maxCoeff();
  for (int n = 0; n < most_trials && at(time + dt) * dt > most; ++n) dt = std::max(0.5 * dt, most / at(time + dt));
  return dt;
}

template <int Dim>
double BodySpeeds<Dim>::at(double time) const {
  double speed = 0;
  for (std::size_t b = 0; b < arms_.size(); ++b) {
    const auto state = model_.body_list[b].motion.state(time);
    speed = std::max(speed, state.velocity.norm() + std::abs(state.angular_velocity) * arms_[b]);
  }
  return speed;
}

template class BodySpeeds<2>;
template class BodySpeeds<3>;
template std::vector<double> mobility_per_area<2>(const Model<2>&);
template std::vector<double> mobility_per_area<3>(const Model<3>&);
template double cloth_step_bound<2>(const Model<2>&);
template double cloth_step_bound<3>(const Model<3>&);
template double flow_time<2>(const Model<2>&, const BodySpeeds<2>&);
template double flow_time<3>(const Model<3>&, const BodySpeeds<3>&);

}  // namespace washfsi
