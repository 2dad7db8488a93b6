// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/step_error.hpp"

#include <cmath>

#include "washfsi/coupling/coupling_operations.hpp"

namespace washfsi {

template <int Dim>
double step_error(const System<Dim>& system) {
  const State<Dim>& state = system.state;
  const auto markers = static_cast<double>(system.model.cloths.marker_count());
  if (markers == 0) return 0;
  const Points<Dim> apart = state.mean_velocities - 0.5 * (state.velocities + state.velocities_before);
  return norm(system.model.grid.comm(), apart) / std::sqrt(markers);
}

template double step_error<2>(const System<2>&);
template double step_error<3>(const System<3>&);

}  // namespace washfsi
