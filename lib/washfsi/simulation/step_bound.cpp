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
  const std::vector<double>&lengths = system.cloths.marker_lengths(), &masses = system.cloths.marker_masses();
  if (system.has_fluid)
    return row_sum_mobility<Dim>(system.transfer, system.grid, system.boundary, system.density, nullptr, lengths);
  std::vector<double> mobility;
  for (std::size_t m = 0; m < masses.size(); ++m) mobility.push_back(lengths[m] / masses[m]);
  return mobility;
}

}  // namespace

template <int Dim>
double cloth_step_bound(const System<Dim>& system) {
  const Cloths<Dim>& cloths = system.cloths;
  if (cloths.marker_count() == 0) return std::numeric_limits<double>::infinity();
  const std::vector<double> mobility = mobility_per_area(system);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < mobility.size(); ++m) {
    const Fibre& fibre = cloths.group_of(m).fibre;
    const double ds2 = fibre.spacing * fibre.spacing;
    const double held = cloths.group_of(m).held_markers().empty() ? 0 : cloths.group_of(m).hold_stiffness;
    const double stiffness = fibre.ke / ds2 + 4 * fibre.kb / (ds2 * ds2) + 0.25 * held / fibre.spacing;
    const double undamped2 = 1 / (mobility[m] * stiffness);  // (2/w)^2
    shortest = std::min(shortest, std::sqrt(fibre.damping * fibre.damping + undamped2) - fibre.damping);
  }
  return -largest(system.grid.comm(), -shortest);
}

template <int Dim>
double flow_time(const System<Dim>& system) {
  double speed = 0;
  WASH_PETSC(VecNorm(system.fluid.velocity(), NORM_INFINITY, &speed));
  speed = std::max(speed, system.boundary.largest_speed(0));
  for_each<Dim>(system.grid.owned(), [&](const Index<Dim>& cell) {
    const Point<Dim> place = system.grid.cell_center(cell);
    for (const auto& body : system.bodies)
      if (body.distance(place, 0) <= 0)
        speed = std::max(speed, body.motion.largest_speed((place - body.motion.center_at(0)).norm()));
  });
  speed = largest(system.grid.comm(), speed);
  return speed > 0 ? system.grid.spacing().minCoeff() / speed : std::numeric_limits<double>::infinity();
}

template double cloth_step_bound<2>(const System<2>&);
template double cloth_step_bound<3>(const System<3>&);
template double flow_time<2>(const System<2>&);
template double flow_time<3>(const System<3>&);

}  // namespace washfsi
