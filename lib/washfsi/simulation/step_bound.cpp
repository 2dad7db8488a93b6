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
