// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/carried_mass.hpp"

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
CarriedMass CarriedMass::of(const System<Dim>& system) {
  CarriedMass sum;
  if (system.model.has_fluid && system.model.cloth_treatment.mass_carrier == MassCarrier::water) return sum;
  const Point<Dim> middle = 0.5 * (system.model.grid.lower() + system.model.grid.upper());
  const std::vector<double>& masses = system.model.cloths.marker_masses();
  for (std::size_t m = 0; m < masses.size(); ++m) {
    const Point<Dim>&v = system.state.velocities[m], arm = system.state.positions[m] - middle;
    sum.kinetic_energy += 0.5 * masses[m] * v.squaredNorm();
    sum.angular_momentum += masses[m] * (arm[0] * v[1] - arm[1] * v[0]);
  }
  const std::vector<double> all =
      ordered_sum(system.model.grid.comm(), std::vector<double>{sum.kinetic_energy, sum.angular_momentum});
  return {all[0], all[1]};
}

template CarriedMass CarriedMass::of<2>(const System<2>&);
template CarriedMass CarriedMass::of<3>(const System<3>&);

}  // namespace washfsi
