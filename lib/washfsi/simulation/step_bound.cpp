// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/step_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Velocity of each marker per force on unit areas of all cloths and time [m2/kg].
template <int Dim>
std::vector<double> mobility_per_area(const System<Dim>& system) {
  const std::vector<double>&areas = system.cloths.marker_areas(), &masses = system.cloths.marker_masses();
  if (system.has_fluid)
    return row_sum_mobility<Dim>(system.transfer, system.grid, system.boundary, system.density, nullptr, areas);
  std::vector<double> mobility;
  for (std::size_t m = 0; m < masses.size(); ++m) mobility.push_back(areas[m] / masses[m]);
  return mobility;
}

// A quarter of the largest eigenvalue of the stiffness per area: of stretching and shear, and of bending and twist
// [N/m3].
double largest_stiffness(const Sheet& sheet) {
  const double per_s = 1 / (sheet.ds * sheet.ds), per_r = 1 / (sheet.dr * sheet.dr);
  const double bending_s = 4 * sheet.kb_s * per_s * per_s;
  if (sheet.width == 1) return sheet.ke_s * per_s + bending_s;
  const double poisson = std::abs(sheet.poisson);
  const double along_s = (1 + poisson) * sheet.ke_s * per_s + sheet.ks * per_r;
  const double along_r = (1 + poisson) * sheet.ke_r * per_r + sheet.ks * per_s;
  const double mixed = 8 * (poisson * std::sqrt(sheet.kb_s * sheet.kb_r) + sheet.kt) * per_s * per_r;
  return std::max(along_s, along_r) + bending_s + 4 * sheet.kb_r * per_r * per_r + mixed;
}

}  // namespace

template <int Dim>
double cloth_step_bound(const System<Dim>& system) {
  const Cloths<Dim>& cloths = system.cloths;
  if (cloths.marker_count() == 0) return std::numeric_limits<double>::infinity();
  const std::vector<double> mobility = mobility_per_area(system);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < mobility.size(); ++m) {
    const ClothGroup<Dim>& group = cloths.group_of(m);
    const double held = group.held_markers().empty() ? 0 : group.hold_stiffness;
    const double stiffness = largest_stiffness(group.sheet) + 0.25 * held / group.sheet.marker_area();
    const double damping = group.sheet.damping;
    const double undamped2 = 1 / (mobility[m] * stiffness);  // (2/w)^2
    shortest = std::min(shortest, std::sqrt(damping * damping + undamped2) - damping);
  }
  return -largest(system.grid.comm(), -shortest);
}

template <int Dim>
double flow_time(const System<Dim>& system, const BodySpeeds<Dim>& bodies) {
  double speed = 0;
  WASH_PETSC(VecNorm(system.fluid.velocity(), NORM_INFINITY, &speed));
  speed = std::max(speed, system.boundary.largest_speed(0));
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    speed = std::max(speed, bodies.arm(b) > 0 ? system.bodies[b].motion.largest_speed(bodies.arm(b)) : 0.0);
  return speed > 0 ? system.grid.spacing().minCoeff() / speed : std::numeric_limits<double>::infinity();
}

template <int Dim>
BodySpeeds<Dim>::BodySpeeds(const System<Dim>& system) : system_(system), arms_(system.bodies.size(), 0.0) {
  const PosedBodies<Dim> posed(system.bodies, 0);
  for_each<Dim>(system.grid.owned(), [&](const Index<Dim>& cell) {
    const Point<Dim> place = system.grid.cell_center(cell);
    for (std::size_t b = 0; b < arms_.size(); ++b)
      if (posed.distance(b, place) <= 0)
        arms_[b] = std::max(arms_[b], (place - system.bodies[b].motion.center_at(0)).norm());
  });
  for (double& arm : arms_) arm = largest(system.grid.comm(), arm);
}

template <int Dim>
double BodySpeeds<Dim>::longest_step(double time, double dt, double courant) const {
  constexpr double ahead = 1.5;  // a body that already moves counts with the flow
  constexpr int most_trials = 60;
  const double most = ahead * courant * system_.grid.spacing().maxCoeff();
  for (int n = 0; n < most_trials && at(time + dt) * dt > most; ++n) dt = std::max(0.5 * dt, most / at(time + dt));
  return dt;
}

template <int Dim>
double BodySpeeds<Dim>::at(double time) const {
  double speed = 0;
  for (std::size_t b = 0; b < arms_.size(); ++b) {
    const auto state = system_.bodies[b].motion.state(time);
    speed = std::max(speed, state.velocity.norm() + std::abs(state.angular_velocity) * arms_[b]);
  }
  return speed;
}

template class BodySpeeds<2>;
template class BodySpeeds<3>;
template double cloth_step_bound<2>(const System<2>&);
template double cloth_step_bound<3>(const System<3>&);
template double flow_time<2>(const System<2>&, const BodySpeeds<2>&);
template double flow_time<3>(const System<3>&, const BodySpeeds<3>&);

}  // namespace washfsi
