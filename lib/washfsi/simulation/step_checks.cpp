// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/step_checks.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/contact/contact_force.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/format_text.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

template <int Dim>
void check_markers(const System<Dim>& system) {
  const Points<Dim>& positions = system.state.positions;
  if (system.model.has_fluid) return system.model.transfer.check_inside(positions);
  const bool finite =
      std::all_of(positions.begin(), positions.end(), [](const Point<Dim>& place) { return place.allFinite(); });
  if (any_rank(system.model.grid.comm(), !finite)) throw DivergedError("cloth: a marker's place is not finite");
}

void check_velocity(const Located& courant, const RunOptions& run) {
  if (courant.value <= run.max_courant) return;
  const std::string advice = run.time_cfl == 0 ? " (-time_cfl 0.5 would shorten the steps in time)"
                                               : " (smaller -time_cfl, or a -time_step that none exceeds)";
  const std::string what = std::isfinite(courant.value)
                               ? format_text("velocity: CFL number %.3g exceeds -time_max_cfl %.3g%s", courant.value,
                                             run.max_courant, advice.c_str())
                               : std::string("velocity: not finite");
  throw DivergedError(what);
}

template <int Dim>
std::string where_it_failed(const Model<Dim>& model, const Located& courant) {
  const std::string contact = tightest_contact(model.forces);
  const std::string touches = contact.empty() ? "" : "the tightest contact: " + contact;
  if (!model.has_fluid) return touches.empty() ? "nothing touches" : touches;
  return (touches.empty() ? "" : touches + "; ") + "the velocity was last seen largest at (" +
         list_text<Dim>(Point<Dim>(courant.place)) + ") m" + format_text(", CFL number %.3g", courant.value);
}

template void check_markers<2>(const System<2>&);
template void check_markers<3>(const System<3>&);
template std::string where_it_failed<2>(const Model<2>&, const Located&);
template std::string where_it_failed<3>(const Model<3>&, const Located&);

}  // namespace washfsi
