// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/momentum.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/krylov.hpp"

namespace washfsi {

template <int Dim>
MomentumSolver<Dim>::MomentumSolver(const Grid<Dim>& grid, const Boundary<Dim>& boundary, double tolerance)
    : grid_(grid),
      boundary_(boundary),
      tolerance_(tolerance),
      residual_(grid.face_vector()),
      correction_(grid.face_vector()) {
  PetscInt size = 0;
  WASH_PETSC(VecGetLocalSize(residual_, &size));
  WASH_PETSC(MatCreateShell(grid.comm(), size, size, PETSC_DETERMINE, PETSC_DETERMINE, this, matrix_.put()));
  WASH_PETSC(MatShellSetOperation(matrix_, MATOP_MULT, reinterpret_cast<void (*)()>(&MomentumSolver::multiply)));
  WASH_PETSC(
      MatShellSetOperation(matrix_, MATOP_GET_DIAGONAL, reinterpret_cast<void (*)()>(&MomentumSolver::get_diagonal)));

  WASH_PETSC(KSPCreate(grid.comm(), solver_.put()));
  WASH_PETSC(KSPSetOptionsPrefix(solver_, "momentum_"));
  WASH_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
  WASH_PETSC(KSPSetType(solver_, KSPGMRES));
  constexpr PetscInt restart = 5;  // mostly 2 iterations; each direction is one more vector
  WASH_PETSC(KSPGMRESSetRestart(solver_, restart));
  PC pc = nullptr;
  WASH_PETSC(KSPGetPC(solver_, &pc));
  WASH_PETSC(PCSetType(pc, PCJACOBI));
  WASH_PETSC(KSPSetTolerances(solver_, 1e-50, PETSC_DEFAULT, PETSC_DEFAULT, 1000));
  const petsc::Vector unit_density = petsc::zeros_like(residual_);
  WASH_PETSC(VecSet(unit_density, 1.0));
  set_step(1.0, {unit_density, {}}, {});  // first coefficients, only to set the solver up
  user_sets_atol_ = set_up_from_options(solver_);
  liquid_ = {};
}

template <int Dim>
void MomentumSolver<Dim>::set_step(double dt, const LiquidFields& liquid, const Constraint<Dim>& constraint) {
  const std::array versions{petsc::Version(liquid.density), petsc::Version(constraint.fluid_fraction),
                            petsc::Version(liquid.viscosity.in_cells)};
  const bool same = dt == dt_ && versions == versions_ && liquid.viscosity.everywhere == liquid_.viscosity.everywhere;
  dt_ = dt;
  liquid_ = liquid;
  constraint_ = constraint;
  versions_ = versions;
  if (same) return;
  if (constraint.fluid_fraction && !diagonal_) diagonal_ = grid_.face_vector();
  if (diagonal_) find_diagonal(diagonal_);
  WASH_PETSC(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));  // tells the preconditioner of new entries
  WASH_PETSC(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
}

template <int Dim>
PetscErrorCode MomentumSolver<Dim>::multiply(Mat matrix, Vec x, Vec y) {
  return petsc::guarded([&] {
    void* self = nullptr;
    WASH_PETSC(MatShellGetContext(matrix, &self));
    static_cast<MomentumSolver*>(self)->apply(x, y);
  });
}

template <int Dim>
PetscErrorCode MomentumSolver<Dim>::get_diagonal(Mat matrix, Vec result) {
  return petsc::guarded([&] {
    void* context = nullptr;
    WASH_PETSC(MatShellGetContext(matrix, &context));
    const auto& self = *static_cast<const MomentumSolver*>(context);
    if (self.diagonal_)
      WASH_PETSC(VecCopy(self.diagonal_, result));
    else
      self.find_diagonal(result);
  });
}

// 1 - (dt / 2 rho) (diagonal of the viscous force)
template <int Dim>
void MomentumSolver<Dim>::find_diagonal(Vec result) const {
  WASH_PETSC(VecSet(result, 1.0));  // boundary faces: identity rows
  const FaceView<Dim> diagonal(grid_.face_dm(), result);
  const ConstFaceView<Dim> rho(grid_.face_dm(), liquid_.density);
  const Spacing<Dim> h(grid_.spacing());
  with_viscosity<Dim>(grid_, liquid_.viscosity, [&](const auto& viscosity) {
    const double half_impulse = 0.5 * viscosity.scale * dt_;
    grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
      const double part = viscous_diagonal<Dim>(grid_, boundary_, viscosity, h, face, c);
      diagonal(face, c) = 1 + half_impulse / rho(face, c) * part;
    });
    visit_cuts(viscosity, [&](const CutFace<Dim>& cut, double weight) {
      diagonal(cut.face, cut.component) += weight * (2 / (cut.lower.length * cut.upper.length) - 2);
    });
  });
}

/// The second difference of a component along a cut axis, times 1/h^2 of the stencil that ends at the walls, less that
/// of the regular stencil; `wall_factor` 0 takes the walls at rest.
template <int Dim, class Velocity>
double cut_correction(const Velocity& u, const CutFace<Dim>& cut, double wall_factor) {
  const double here = u(cut.face, cut.component);
  const double below = u(shifted<Dim>(cut.face, cut.axis, -1), cut.component);
  const double above = u(shifted<Dim>(cut.face, cut.axis, 1), cut.component);
  const double lower = cut.lower.cut ? wall_factor * cut.lower.wall_velocity : below;
  const double upper = cut.upper.cut ? wall_factor * cut.upper.wall_velocity : above;
  const double slopes = (upper - here) / cut.upper.length - (here - lower) / cut.lower.length;
  return 2 * slopes / (cut.lower.length + cut.upper.length) - (above - 2 * here + below);
}

// Calls visit(cut, mu dt / (rho h^2)) for each cut face.
template <int Dim>
template <class Form, class Visit>
void MomentumSolver<Dim>::visit_cuts(const Form& viscosity, Visit&& visit) const {
  if (!constraint_.cuts) return;
  const ConstFaceView<Dim> rho(grid_.face_dm(), liquid_.density);
  const Spacing<Dim> h(grid_.spacing());
  for (const CutFace<Dim>& cut : *constraint_.cuts)
    visit(cut, viscosity.scale * viscosity.on_face(cut.face, cut.component) * dt_ * h.inverse_square[cut.axis] /
                   rho(cut.face, cut.component));
}

template <int Dim>
void MomentumSolver<Dim>::apply(Vec x, Vec y) const {
  const petsc::LocalVector local(grid_.face_dm(), x);
  boundary_.fill_homogeneous(local);
  const ConstFaceView<Dim> global(grid_.face_dm(), x), u(grid_.face_dm(), local), rho(grid_.face_dm(), liquid_.density);
  const FaceView<Dim> result(grid_.face_dm(), y);
  grid_.for_each_lower_boundary_face([&](const Index<Dim>& face, int c) { result(face, c) = global(face, c); });
  with_viscosity<Dim>(grid_, liquid_.viscosity, [&](const auto& viscosity) {
    const double half_impulse = 0.5 * viscosity.scale * dt_;
    grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
      result(face, c) = u(face, c) - half_impulse / rho(face, c) * viscosity.force(u, face, c);
    });
    if (!constraint_.fluid_fraction) return;
    const ConstFaceView<Dim> fraction(grid_.face_dm(), constraint_.fluid_fraction),
        diagonal(grid_.face_dm(), diagonal_);
    grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
      const double H = fraction(face, c);
      if (H == 1) return;
      const double solid_row = diagonal(face, c) * u(face, c);
      result(face, c) = H * result(face, c) + (1 - H) * solid_row;
    });
    visit_cuts(viscosity, [&](const CutFace<Dim>& cut, double weight) {
      result(cut.face, cut.component) -= weight * cut_correction<Dim>(u, cut, 0);
    });
  });
}

template <int Dim>
void MomentumSolver<Dim>::residual(Vec rhs, double time, Vec velocity, Vec result) const {
  const GhostedVelocity<Dim> local(boundary_, grid_.face_dm(), velocity, time);
  const ConstFaceView<Dim> u(grid_.face_dm(), local), rho(grid_.face_dm(), liquid_.density), b(grid_.face_dm(), rhs);
  const FaceView<Dim> r(grid_.face_dm(), result);
  grid_.for_each_lower_boundary_face([&](const Index<Dim>& face, int c) { r(face, c) = 0; });
  with_viscosity<Dim>(grid_, liquid_.viscosity, [&](const auto& viscosity) {
    const double half_impulse = 0.5 * viscosity.scale * dt_;
    grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
      r(face, c) = b(face, c) - u(face, c) + half_impulse / rho(face, c) * viscosity.force(u, face, c);
    });
    if (!constraint_.fluid_fraction) return;
    const ConstFaceView<Dim> fraction(grid_.face_dm(), constraint_.fluid_fraction);
    const ConstFaceView<Dim> solid(grid_.face_dm(), constraint_.solid_velocity), diagonal(grid_.face_dm(), diagonal_);
    grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
      const double H = fraction(face, c);
      if (H == 1) return;
      const double solid_row = diagonal(face, c) * (solid(face, c) - u(face, c));
      r(face, c) = H * r(face, c) + (1 - H) * solid_row;
    });
    visit_cuts(viscosity, [&](const CutFace<Dim>& cut, double weight) {
      r(cut.face, cut.component) += weight * cut_correction<Dim>(u, cut, 1);
    });
  });
}

// The scale of the tolerance: the largest speed present or prescribed by solids.
template <int Dim>
double MomentumSolver<Dim>::largest_speed(Vec rhs) const {
  double speed = 0, solid = 0;
  WASH_PETSC(VecNorm(rhs, NORM_INFINITY, &speed));
  if (constraint_.solid_velocity) WASH_PETSC(VecNorm(constraint_.solid_velocity, NORM_INFINITY, &solid));
  return std::max(speed, solid);
}

// Solves for the correction of the guess: homogeneous boundaries, and a residual that is small from the start.
template <int Dim>
void MomentumSolver<Dim>::solve(Vec rhs, double time, Vec velocity) {
  boundary_.set_boundary_faces(velocity, time);
  residual(rhs, time, velocity, residual_);
  const double scale = std::max(largest_speed(rhs), boundary_.largest_speed(time));
  const double rms_to_norm = std::sqrt(Dim * grid_.cell_count());
  const double tolerance = user_sets_atol_ ? 0 : std::max(tolerance_ * scale * rms_to_norm, 1e-300);
  iterations_ += static_cast<double>(solve_to(solver_, tolerance, residual_, correction_, "momentum"));
  WASH_PETSC(VecAXPY(velocity, 1.0, correction_));
}

template <int Dim>
void MomentumSolver<Dim>::constraint_force(Vec rhs, double time, Vec velocity, Vec force) const {
  WASH_PETSC(VecZeroEntries(force));
  const GhostedVelocity<Dim> local(boundary_, grid_.face_dm(), velocity, time);
  const ConstFaceView<Dim> u(grid_.face_dm(), local), rho(grid_.face_dm(), liquid_.density), b(grid_.face_dm(), rhs);
  const ConstFaceView<Dim> fraction(grid_.face_dm(), constraint_.fluid_fraction);
  const FaceView<Dim> f(grid_.face_dm(), force);
  with_viscosity<Dim>(grid_, liquid_.viscosity, [&](const auto& viscosity) {
    const auto held = [&](const Index<Dim>& face, auto c) {
      const double viscous = 0.5 * viscosity.scale * viscosity.force(u, face, c);
      f(face, c) = rho(face, c) * (u(face, c) - b(face, c)) / dt_ - viscous;
    };
    grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
      if (fraction(face, c) != 1) held(face, c);
    });
    visit_cuts(viscosity, [&](const CutFace<Dim>& cut, double) { held(cut.face, cut.component); });
  });
}

template class MomentumSolver<2>;
template class MomentumSolver<3>;

}  // namespace washfsi
