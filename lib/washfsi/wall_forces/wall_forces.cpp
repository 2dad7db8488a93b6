// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_forces/wall_forces.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace washfsi {

namespace {

// A slip correction takes no account of the pressure: walls respond with 0.2 to 1 of what it asks for, the least for
// loads that vary slowly along them. Two corrections in a row have the relaxations of Chebyshev's method of second
// degree over this interval, 1/(0.6 -+ 0.4/sqrt(2)): the larger first, since what responds well has been corrected
// already.
constexpr double middle_response = 0.6;
constexpr std::array<double, 2> relaxations{3.153, 1.133};

// Rounds of these two before the solver is called. Usually one or none is enough, and the solver makes loads jump in
// time.
constexpr int most_rounds = 3;

// Where water slides along walls, the part of the forces to which markers hardly respond would accumulate, since it
// acts on other water in the next step: forces are halved when the water has passed a quarter of a cell.
constexpr double decay_per_cell = 4;  // [1/cell]

}  // namespace

template <int Dim>
WallForces<Dim>::WallForces(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
                            const BodyTreatment& treatment)
    : markers_(grid, boundary, bodies, treatment, treatment.limits_advection || treatment.inner_water_slides),
      solver_(markers_, treatment),
      limits_advection_(treatment.limits_advection),
      forces_(markers_.layout().own().size(), Point<Dim>::Zero()),
      previous_(forces_) {
  place(0);
}

template <int Dim>
void WallForces<Dim>::place(double time) {
  markers_.place(time);
  solver_.place();
}

template <int Dim>
void WallForces<Dim>::begin_trial(const TimeStep& step, Vec density) {
  solver_.begin(step, density);
  forces_ = markers_.turned(previous_, true);
  markers_.sliding().turn([this](const Points<Dim>& normals) { return markers_.turned(normals, true); });
}

template <int Dim>
void WallForces<Dim>::add_to(Vec force) const {
  markers_.spread(forces_, force);
  if (const auto* law = markers_.sliding().law()) law->add_friction(force);
}

template <int Dim>
void WallForces<Dim>::accept() {
  Points<Dim> next = forces_;  // without the sliding part, lest it return when the patch no longer slides
  for (std::size_t p = 0; p < next.size(); ++p)
    next[p] = markers_.sliding().constrained(next[p], p) / (1 + decay_per_cell * markers_.sliding().slide(p).passes);
  previous_ = markers_.turned(next, false);
}

template <int Dim>
void WallForces<Dim>::add_forces(const Points<Dim>& more, Vec velocity) {
  solver_.accelerate(more, velocity);
  forces_ += more;
}

// A projected velocity is projected again only for this force, so that walls respond with the middle of the range. The
// projection of a predicted one changes the slip in any case, and the correction is taken as it is.
template <int Dim>
void WallForces<Dim>::reduce_slip(Vec velocity, Stage stage) {
  const double relaxation = stage == Stage::projected ? 1 / middle_response : 1;
  add_forces(relaxation * solver_.approximate_forces(solver_.slips(velocity)), velocity);
}

template <int Dim>
Points<Dim> WallForces<Dim>::without(const std::vector<bool>& bodies, Points<Dim> values) const {
  for (std::size_t p = 0; p < values.size(); ++p)
    if (bodies[markers_.body_of(p)]) values[p].setZero();
  return values;
}

template <int Dim>
bool WallForces<Dim>::reduce_slip_beyond_tolerance(Vec velocity, double relaxation) {
  const Points<Dim> slips = solver_.slips(velocity);
  const std::vector<bool> within = solver_.are_within(slips, solver_.tolerance(velocity));
  if (std::ranges::all_of(within, std::identity())) return false;
  add_forces(relaxation * solver_.approximate_forces(without(within, slips)), velocity);
  return true;
}

template <int Dim>
void WallForces<Dim>::enforce_no_slip(Vec velocity, Projection& projection) {
  for (int round = 0; round < most_rounds; ++round)
    for (const double relaxation : relaxations) {
      if (!reduce_slip_beyond_tolerance(velocity, relaxation)) return;
      projection.project_again();
    }
  const Points<Dim> slips = solver_.slips(velocity);
  const double tolerance = solver_.tolerance(velocity);
  if (std::ranges::all_of(solver_.are_within(slips, tolerance), std::identity())) return;
  add_forces(solver_.solve(slips, tolerance, projection), velocity);
  projection.project_again();
}

template <int Dim>
void WallForces<Dim>::register_state(StateList& state) {
  const PatchRange own = markers_.layout().own();
  const std::size_t patches = markers_.layout().patches();
  state.add(points_entry<Dim>("/walls/force", row_slab(patches, own.begin, own.end, Dim), previous_)).if_other =
      StateEntry::IfOther::begin_anew;
}

template class WallForces<2>;
template class WallForces<3>;

}  // namespace washfsi
