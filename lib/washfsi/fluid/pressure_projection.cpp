// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/pressure_projection.hpp"

#include <algorithm>

#include "washfsi/grid/field_slab.hpp"

namespace washfsi {

template <int Dim>
PressureProjection<Dim>::PressureProjection(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                            const FluidOptions<Dim>& options)
    : grid_(grid),
      boundary_(boundary),
      tolerance_(options.pressure_tolerance),
      is_on_(options.projection),
      poisson_(grid),
      pressure_(grid.cell_vector()),
      phi_(grid.cell_vector()),
      minus_divergence_(grid.cell_vector()) {}

template <int Dim>
void PressureProjection<Dim>::begin(const TimeStep& step, double dt_before, const LiquidFields& liquid,
                                    const Constraint<Dim>& constraint, Vec velocity) {
  step_ = step;
  viscosity_ = liquid.viscosity;
  velocity_ = velocity;
  poisson_.set_density(liquid.density, constraint.in_projection ? constraint.fluid_fraction : nullptr);
  // the guess: a pressure that changes at the same rate as before
  const double ratio = dt_before > 0 ? step.dt / dt_before : 0;
  if (ratio > 0 && ratio != 1) WASH_PETSC(VecScale(phi_, ratio * ratio));
}

template <int Dim>
void PressureProjection<Dim>::project() {
  if (!is_on_) return;
  const petsc::LogPart part("pressure");
  solve(phi_);
  add_viscous_pressure();
}

// The guess is not the last solution, which a restart does not have.
template <int Dim>
void PressureProjection<Dim>::project_again() {
  if (!phi_of_force_) phi_of_force_ = grid_.cell_vector();
  WASH_PETSC(VecZeroEntries(phi_of_force_));
  solve(phi_of_force_);
}

template <int Dim>
void PressureProjection<Dim>::project_increment(Vec increment) {
  constexpr double looser = 200;  // tolerance over that of the step's projection, which follows
  double speed = 0;
  WASH_PETSC(VecNorm(increment, NORM_INFINITY, &speed));
  {
    const petsc::LocalVector local(grid_.face_dm(), increment);
    boundary_.fill_homogeneous(local);
    find_minus_divergence(local);
  }
  const petsc::GlobalVector phi(grid_.cell_dm());
  WASH_PETSC(VecZeroEntries(phi));
  const double tolerance = looser * tolerance_ * speed / grid_.spacing().minCoeff();
  iterations_ += static_cast<double>(poisson_.solve(minus_divergence_, tolerance, phi));
  poisson_.correct(phi, increment);
}

// Solves for phi and the pressure that make the velocity divergence free; phi contains a guess. Leaves -div u* times
// the cell volume, which `add_viscous_pressure` needs.
template <int Dim>
void PressureProjection<Dim>::solve(Vec phi) {
  {
    const GhostedVelocity<Dim> local(boundary_, grid_.face_dm(), velocity_, step_.end());
    find_minus_divergence(local);
  }
  const double tolerance = poisson_.is_direct() ? 0 : tolerance_ * largest_speed() / grid_.spacing().minCoeff();
  iterations_ += static_cast<double>(poisson_.solve(minus_divergence_, tolerance, phi));
  poisson_.correct(phi, velocity_);
  WASH_PETSC(VecAXPY(pressure_, poisson_.reference_density() / step_.dt, phi));  // p += q
}

template <int Dim>
void PressureProjection<Dim>::find_minus_divergence(Vec local_velocity) {
  const ConstFaceView<Dim> u(grid_.face_dm(), local_velocity);
  const CellView<Dim> r(grid_.cell_dm(), minus_divergence_);
  const Spacing<Dim> h(grid_.spacing());
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) { r(cell) = -divergence<Dim>(u, cell, h); });
}

// Adds the pressure that balances the viscous force of the velocity's correction.
template <int Dim>
void PressureProjection<Dim>::add_viscous_pressure() {
  if (!viscosity_.in_cells) {
    WASH_PETSC(VecAXPY(pressure_, 0.5 * viscosity_.everywhere / grid_.cell_volume(), minus_divergence_));
    return;
  }
  const ConstCellView<Dim> mu(grid_.cell_dm(), viscosity_.in_cells), r(grid_.cell_dm(), minus_divergence_);
  const CellView<Dim> p(grid_.cell_dm(), pressure_);
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) { p(cell) += mu(cell) * r(cell) / grid_.cell_volume(); });
}

template <int Dim>
double PressureProjection<Dim>::largest_speed() const {
  double speed = 0;
  WASH_PETSC(VecNorm(velocity_, NORM_INFINITY, &speed));
  return std::max(speed, boundary_.largest_speed(step_.end()));
}

template <int Dim>
void PressureProjection<Dim>::save_pressure() {
  if (!saved_pressure_) saved_pressure_ = grid_.cell_vector();
  WASH_PETSC(VecCopy(pressure_, saved_pressure_));
}

template <int Dim>
void PressureProjection<Dim>::restore_pressure() {
  WASH_PETSC(VecCopy(saved_pressure_, pressure_));
}

template <int Dim>
void PressureProjection<Dim>::register_state(StateList& state) {
  state.add(vector_entry("/fluid/pressure", field_slab(grid_, 1), pressure_));
  state.add(vector_entry("/fluid/phi", field_slab(grid_, 1), phi_));
  state.add_number("/fluid/pressure_iterations", iterations_);
}

template class PressureProjection<2>;
template class PressureProjection<3>;

}  // namespace washfsi
