// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_forces/no_slip_solver.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/krylov.hpp"
#include "washfsi/support/point_vectors.hpp"

namespace washfsi {

namespace {

// The largest speed of a marker of any rank [m/s].
template <int Dim>
double largest_speed(const WallMarkers<Dim>& markers) {
  double speed = 0;
  for (const auto& state : markers.states()) speed = std::max(speed, state.velocity.norm());
  return largest(markers.grid().comm(), speed);
}

}  // namespace

template <int Dim>
NoSlipSolver<Dim>::NoSlipSolver(const WallMarkers<Dim>& markers, const BodyTreatment& treatment)
    : markers_(markers),
      slip_tolerance_(treatment.slip_tolerance),
      closed_(markers.grid(), markers.layout().bodies(), markers.layout()),
      overlap_(markers.layout().by_body(), wall_marker_layout(markers.grid(), treatment), markers.layout().own()) {
  create_solver();
}

template <int Dim>
void NoSlipSolver<Dim>::create_solver() {
  const auto size = static_cast<PetscInt>(Dim * markers_.layout().own().size());
  WASH_PETSC(MatCreateShell(grid().comm(), size, size, PETSC_DETERMINE, PETSC_DETERMINE, this, matrix_.put()));
  WASH_PETSC(MatShellSetOperation(matrix_, MATOP_MULT, reinterpret_cast<void (*)()>(&NoSlipSolver::multiply)));
  WASH_PETSC(MatCreateVecs(matrix_, solution_.put(), right_.put()));
  WASH_PETSC(KSPCreate(grid().comm(), solver_.put()));
  WASH_PETSC(KSPSetOptionsPrefix(solver_, "walls_"));
  WASH_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
  WASH_PETSC(KSPSetType(solver_, KSPGCR));
  WASH_PETSC(KSPSetNormType(solver_, KSP_NORM_UNPRECONDITIONED));
  WASH_PETSC(KSPSetConvergenceTest(solver_, &NoSlipSolver::judge, this, nullptr));
  PC pc = nullptr;
  WASH_PETSC(KSPGetPC(solver_, &pc));
  WASH_PETSC(PCSetType(pc, PCSHELL));
  WASH_PETSC(PCShellSetContext(pc, this));
  WASH_PETSC(PCShellSetApply(pc, &NoSlipSolver::precondition));
  WASH_PETSC(KSPSetTolerances(solver_, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, 1000));
  (void)set_up_from_options(solver_);
}

// Puts product(x) into y. If that diverges, `judge` ends the solver, and `solve` throws.
template <int Dim>
template <class Product>
PetscErrorCode NoSlipSolver<Dim>::put_product(Vec x, Vec y, const Product& product) {
  return petsc::guarded([&] {
    try {
      to_vector<Dim>(product(to_points<Dim>(x)), y);
    } catch (const DivergedError&) {
      solving_.failure = std::current_exception();
      WASH_PETSC(VecCopy(x, y));
    }
  });
}

template <int Dim>
PetscErrorCode NoSlipSolver<Dim>::multiply(Mat matrix, Vec x, Vec y) {
  void* context = nullptr;
  if (const PetscErrorCode error = MatShellGetContext(matrix, &context)) return error;
  auto& self = *static_cast<NoSlipSolver*>(context);
  return self.put_product(x, y, [&](const Points<Dim>& forces) { return self.response(forces); });
}

template <int Dim>
PetscErrorCode NoSlipSolver<Dim>::precondition(PC pc, Vec x, Vec y) {
  void* context = nullptr;
  if (const PetscErrorCode error = PCShellGetContext(pc, &context)) return error;
  auto& self = *static_cast<NoSlipSolver*>(context);
  return self.put_product(x, y, [&](const Points<Dim>& slips) { return self.approximate_forces(slips); });
}

template <int Dim>
PetscErrorCode NoSlipSolver<Dim>::judge(KSP solver, PetscInt, PetscReal norm, KSPConvergedReason* reason, void* self) {
  return petsc::guarded([&] {
    const auto& equations = *static_cast<const NoSlipSolver*>(self);
    Vec residual = nullptr;
    WASH_PETSC(KSPBuildResidual(solver, nullptr, nullptr, &residual));
    const std::vector<bool> within = equations.are_within(to_points<Dim>(residual), equations.solving_.slip_left);
    WASH_PETSC(VecDestroy(&residual));
    *reason = KSP_CONVERGED_ITERATING;
    if (std::ranges::all_of(within, std::identity())) *reason = KSP_CONVERGED_ATOL;
    if (!std::isfinite(norm) || equations.solving_.failure) *reason = KSP_DIVERGED_NANORINF;
  });
}

template <int Dim>
void NoSlipSolver<Dim>::place() {
  closed_.update(markers_.states(), markers_.time());
}

template <int Dim>
void NoSlipSolver<Dim>::begin(const TimeStep& step, Vec density) {
  step_ = step;
  density_ = density;
  if (const petsc::Version version(density); version != density_version_) {
    density_version_ = version;
    densities_ = range_of(density);
    local_densities_.assign(markers_.layout().own().size(), Point<Dim>::Constant(densities_.least));
  }
  if (!densities_.is_uniform()) find_local_densities();
}

// What a patch's force would move by its kernel alone: the part of its impulse over that of the velocity.
template <int Dim>
void NoSlipSolver<Dim>::find_local_densities() {
  const petsc::GlobalVector impulse(grid().face_dm()), velocity(grid().face_dm());
  WASH_PETSC(VecZeroEntries(impulse));
  markers_.spread(Points<Dim>(local_densities_.size(), Point<Dim>::Ones()), impulse);
  WASH_PETSC(VecPointwiseDivide(velocity, impulse, density_));
  const Points<Dim> of_impulse = markers_.means(interpolated(impulse)),
                    of_velocity = markers_.means(interpolated(velocity));
  for (std::size_t p = 0; p < local_densities_.size(); ++p)
    for (int c = 0; c < Dim; ++c)
      local_densities_[p][c] = of_velocity[p][c] != 0 ? of_impulse[p][c] / of_velocity[p][c] : densities_.least;
}

template <int Dim>
Points<Dim> NoSlipSolver<Dim>::without_unreachable(const Points<Dim>& of_markers) const {
  Points<Dim> result = markers_.means(of_markers);
  closed_.remove_from(result);
  return result;
}

template <int Dim>
Points<Dim> NoSlipSolver<Dim>::slips(Vec velocity) const {
  Points<Dim> result = markers_.water_velocities(velocity, markers_.time());
  for (std::size_t m = 0; m < result.size(); ++m) result[m] = markers_.states()[m].velocity - result[m];
  return without_unreachable(result);
}

template <int Dim>
Points<Dim> NoSlipSolver<Dim>::approximate_forces(const Points<Dim>& slips) const {
  Points<Dim> forces = overlap_(slips);
  const double volume_per_time = grid().cell_volume() / step_.dt;
  for (std::size_t p = 0; p < forces.size(); ++p) {
    const Point<Dim> scale = local_densities_[p] * volume_per_time;
    forces[p] =
        markers_.acts(p) ? markers_.sliding().constrained(scale.cwiseProduct(forces[p]), p) : Point<Dim>::Zero().eval();
  }
  closed_.remove_from(forces);
  return forces;
}

template <int Dim>
void NoSlipSolver<Dim>::accelerate(const Points<Dim>& forces, Vec velocity) const {
  const petsc::GlobalVector density_of_force(grid().face_dm());
  WASH_PETSC(VecZeroEntries(density_of_force));
  markers_.spread(forces, density_of_force);
  const FaceView<Dim> u(grid().face_dm(), velocity);
  const ConstFaceView<Dim> f(grid().face_dm(), density_of_force), rho(grid().face_dm(), density_);
  grid().for_each_inner_face(
      [&](const Index<Dim>& face, auto c) { u(face, c) += step_.dt * f(face, c) / rho(face, c); });
}

// Returns J P S F dt/rho.
template <int Dim>
Points<Dim> NoSlipSolver<Dim>::response(const Points<Dim>& forces) const {
  const petsc::GlobalVector increment(grid().face_dm());
  WASH_PETSC(VecZeroEntries(increment));
  accelerate(forces, increment);
  solving_.projection->project_increment(increment);
  return without_unreachable(interpolated(increment));
}

template <int Dim>
Points<Dim> NoSlipSolver<Dim>::interpolated(Vec increment) const {
  const petsc::LocalVector local(grid().wide_face_dm(), increment);
  markers_.boundary().fill_homogeneous(local);
  return markers_.transfer().interpolate(local);
}

template <int Dim>
double NoSlipSolver<Dim>::tolerance(Vec velocity) const {
  double speed = 0;
  WASH_PETSC(VecNorm(velocity, NORM_INFINITY, &speed));
  return slip_tolerance_ * std::max(speed, largest_speed(markers_));
}

template <int Dim>
std::vector<bool> NoSlipSolver<Dim>::are_within(const Points<Dim>& slips, double tolerance) const {
  const Points<Dim> filtered = overlap_.means_about(slips);
  const std::size_t bodies = markers_.layout().bodies().size();
  std::vector<double> sums(2 * bodies, 0.0);  // for each body: sum of squared slips; number of acting patches
  for (std::size_t p = 0; p < filtered.size(); ++p) {
    if (!markers_.acts(p)) continue;
    const std::size_t b = markers_.body_of(p);
    sums[2 * b] += filtered[p].squaredNorm();
    sums[2 * b + 1] += 1;
  }
  sums = ordered_sum(grid().comm(), sums);
  std::vector<bool> within;
  for (std::size_t b = 0; b < bodies; ++b) within.push_back(sums[2 * b] <= tolerance * tolerance * sums[2 * b + 1]);
  return within;
}

template <int Dim>
Points<Dim> NoSlipSolver<Dim>::solve(const Points<Dim>& slips, double tolerance, Projection& projection) {
  solving_ = {&projection, tolerance, nullptr};
  to_vector<Dim>(slips, right_);
  try {
    (void)solve_to(solver_, 0, right_, solution_, "walls");
  } catch (const DivergedError&) {
    if (solving_.failure) std::rethrow_exception(solving_.failure);
    throw;
  }
  return to_points<Dim>(solution_);
}

template class NoSlipSolver<2>;
template class NoSlipSolver<3>;

}  // namespace washfsi
