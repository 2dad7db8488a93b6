// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/surface_forcing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "washfsi/body/turned.hpp"
#include "washfsi/coupling/marker_vectors.hpp"
#include "washfsi/fluid/krylov.hpp"
#include "washfsi/forcing/edge_nearness.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Narrow, and smooth for what moves over the grid.
constexpr DeltaOptions delta{DeltaKernel::yang, 2, 2};

// Where water slides along, what of a step's force markers hardly feel would pile up, as it acts on other water in the
// next: a quarter of a cell that the water passes by takes half of it.
constexpr double forgets = 4;  // [1/cell]

template <int Dim>
MarkerLayout<Dim> layout_for(const Grid<Dim>& grid, const BodyTreatment& treatment) {
  return {.cell = grid.spacing(),
          .spacing = treatment.marker_spacing,
          .moments = KernelMoments(delta.kernel, delta.spread_width),
          .inner_water_slides = treatment.inner_water_slides,
          .comm = grid.comm()};
}

}  // namespace

template <int Dim>
SurfaceForcing<Dim>::SurfaceForcing(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                    const std::vector<Body<Dim>>& bodies, const BodyTreatment& treatment,
                                    double density)
    : grid_(grid),
      boundary_(boundary),
      bodies_(bodies),
      slip_tolerance_(treatment.slip_tolerance),
      density_(density),
      transfer_(grid, boundary, delta),
      markers_(grid, bodies, layout_for(grid, treatment)),
      closed_(grid, bodies, markers_),
      overlap_(markers_.by_body(), layout_for(grid, treatment), markers_.own()),
      known_pushes_(grid.comm(), overlap_),
      limits_advection_(treatment.limits_advection) {
  forces_.assign(owned(), Point<Dim>::Zero());
  kept_ = forces_;
  create_solver();
  if ((limits_advection_ || treatment.inner_water_slides) && markers_.any_is_sharp()) nearness_ = grid.face_vector();
  update(0);
}

template <int Dim>
void SurfaceForcing<Dim>::create_solver() {
  const auto size = static_cast<PetscInt>(Dim * owned());
  WASH_PETSC(MatCreateShell(grid_.comm(), size, size, PETSC_DETERMINE, PETSC_DETERMINE, this, matrix_.put()));
  WASH_PETSC(MatShellSetOperation(matrix_, MATOP_MULT, reinterpret_cast<void (*)()>(&SurfaceForcing::multiply)));
  WASH_PETSC(MatCreateVecs(matrix_, solution_.put(), right_.put()));
  WASH_PETSC(KSPCreate(grid_.comm(), solver_.put()));
  WASH_PETSC(KSPSetOptionsPrefix(solver_, "walls_"));
  WASH_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
  WASH_PETSC(KSPSetType(solver_, KSPGCR));
  WASH_PETSC(KSPSetNormType(solver_, KSP_NORM_UNPRECONDITIONED));
  WASH_PETSC(KSPSetConvergenceTest(solver_, &SurfaceForcing::judge, this, nullptr));
  PC pc = nullptr;
  WASH_PETSC(KSPGetPC(solver_, &pc));
  WASH_PETSC(PCSetType(pc, PCSHELL));
  WASH_PETSC(PCShellSetContext(pc, this));
  WASH_PETSC(PCShellSetApply(pc, &SurfaceForcing::precondition));
  WASH_PETSC(KSPSetTolerances(solver_, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, 1000));
  (void)set_up_from_options(solver_);
}

template <int Dim>
PetscErrorCode SurfaceForcing<Dim>::multiply(Mat matrix, Vec x, Vec y) {
  return petsc::guarded([&] {
    void* self = nullptr;
    WASH_PETSC(MatShellGetContext(matrix, &self));
    to_vector<Dim>(static_cast<SurfaceForcing*>(self)->response(to_points<Dim>(x)), y);
  });
}

template <int Dim>
PetscErrorCode SurfaceForcing<Dim>::precondition(PC pc, Vec x, Vec y) {
  return petsc::guarded([&] {
    void* self = nullptr;
    WASH_PETSC(PCShellGetContext(pc, &self));
    const auto& forcing = *static_cast<const SurfaceForcing*>(self);
    to_vector<Dim>(forcing.approximate_forces(to_points<Dim>(x)), y);
  });
}

template <int Dim>
PetscErrorCode SurfaceForcing<Dim>::judge(KSP solver, PetscInt, PetscReal norm, KSPConvergedReason* reason,
                                          void* self) {
  return petsc::guarded([&] {
    const auto& forcing = *static_cast<const SurfaceForcing*>(self);
    Vec residual = nullptr;
    WASH_PETSC(KSPBuildResidual(solver, nullptr, nullptr, &residual));
    const std::vector<bool> held = forcing.are_held(to_points<Dim>(residual), forcing.slip_left_);
    WASH_PETSC(VecDestroy(&residual));
    *reason = KSP_CONVERGED_ITERATING;
    if (!std::isfinite(norm)) *reason = KSP_DIVERGED_NANORINF;
    if (std::ranges::all_of(held, std::identity())) *reason = KSP_CONVERGED_ATOL;
  });
}

template <int Dim>
void SurfaceForcing<Dim>::update(double time) {
  const PosedBodies<Dim> posed(bodies_, time);
  time_ = time;
  states_.clear();
  shares_.assign(owned(), 0.0);
  Points<Dim> places;
  for (std::size_t p = begin(); p < own().end; ++p) {
    bool acts = false;
    for (std::size_t m = markers_.start(p); m < markers_.start(p + 1); ++m) {
      states_.push_back(markers_.at(posed, p, m));
      places.push_back(states_.back().place);
      acts = acts || states_.back().acts;
    }
    // that of a whole patch, so that a part of one does not respond more than its overlap foresees
    if (acts) shares_[p - begin()] = 1.0 / static_cast<double>(markers_.start(p + 1) - markers_.start(p));
  }
  transfer_.locate(places);
  seen_.reset();
  closed_.update(states_, time);
  if (!nearness_) return;
  std::vector<bool> at_edges(states_.size(), false);
  for_each_acting([&](std::size_t, std::size_t m) { at_edges[m] = markers_.is_sharp(markers_.start(begin()) + m); });
  find_edge_nearness<Dim>(grid_, transfer_, at_edges, nearness_);
}

template <int Dim>
void SurfaceForcing<Dim>::let_slide(const BodyWallLaw<Dim>& law) {
  if (law_ == &law) return;
  law_ = &law;
  const auto first = law.patch_normals().begin();
  slide_normals_.assign(first + static_cast<std::ptrdiff_t>(begin()), first + static_cast<std::ptrdiff_t>(own().end));
}

// What of a patch's velocity or force is not free to slide.
template <int Dim>
Point<Dim> SurfaceForcing<Dim>::held(const Point<Dim>& value, std::size_t patch) const {
  const double part = law_ ? law_->patch_slides()[begin() + patch].part : 0;
  if (part == 0 || normals_.empty()) return value;
  return value - part * (value - value.dot(normals_[patch]) * normals_[patch]);
}

// From patches to their markers that act.
template <int Dim>
Points<Dim> SurfaceForcing<Dim>::shared_out(const Points<Dim>& of_patches) const {
  Points<Dim> result(states_.size(), Point<Dim>::Zero());
  for_each_acting([&](std::size_t p, std::size_t m) { result[m] = shares_[p] * held(of_patches[p], p); });
  return result;
}

// Over the markers of each patch that act: the adjoint of `shared_out`.
template <int Dim>
Points<Dim> SurfaceForcing<Dim>::means(const Points<Dim>& of_markers) const {
  Points<Dim> result(owned(), Point<Dim>::Zero());
  for_each_acting([&](std::size_t p, std::size_t m) { result[p] += shares_[p] * of_markers[m]; });
  for (std::size_t p = 0; p < result.size(); ++p) result[p] = held(result[p], p);
  return result;
}

// Without what no force can change.
template <int Dim>
Points<Dim> SurfaceForcing<Dim>::felt_means(const Points<Dim>& of_markers) const {
  Points<Dim> result = means(of_markers);
  closed_.remove_from(result);
  return result;
}

template <int Dim>
Points<Dim> SurfaceForcing<Dim>::turned(const Points<Dim>& values, bool into_space) const {
  return washfsi::turned<Dim>(values, bodies_, time_, into_space,
                              [this](std::size_t p) { return markers_.body_of(begin() + p); });
}

template <int Dim>
void SurfaceForcing<Dim>::begin_trial(const TimeStep& step, Vec density) {
  step_ = step;
  fluid_density_ = density;
  pushed_.reset();
  forces_ = turned(kept_, true);
  if (law_) normals_ = turned(slide_normals_, true);
}

template <int Dim>
void SurfaceForcing<Dim>::accept() {
  Points<Dim> acting = forces_;  // what is not passed on must not return when it is
  for (std::size_t p = 0; p < acting.size(); ++p)
    acting[p] = held(acting[p], p) / (1 + (law_ ? forgets * law_->patch_slides()[begin() + p].passes : 0));
  kept_ = turned(acting, false);
}

template <int Dim>
void SurfaceForcing<Dim>::add_held(Vec force) {
  transfer_.spread(shared_out(forces_), force);
  if (law_) law_->add_friction(force);
}

// u += dt S F / rho
template <int Dim>
void SurfaceForcing<Dim>::accelerate(const Points<Dim>& forces, Vec velocity) const {
  const petsc::GlobalVector pushed(grid_.face_dm());
  WASH_PETSC(VecZeroEntries(pushed));
  transfer_.spread(shared_out(forces), pushed);
  const FaceView<Dim> u(grid_.face_dm(), velocity);
  const ConstFaceView<Dim> f(grid_.face_dm(), pushed), rho(grid_.face_dm(), fluid_density_);
  grid_.for_each_inner_face(
      [&](const Index<Dim>& face, auto c) { u(face, c) += step_.dt * f(face, c) / rho(face, c); });
}

// U - J u
template <int Dim>
Points<Dim> SurfaceForcing<Dim>::slips(Vec velocity) const {
  Points<Dim> result = water_at_markers(velocity, time_);
  for (std::size_t m = 0; m < result.size(); ++m) result[m] = states_[m].velocity - result[m];
  return felt_means(result);
}

template <int Dim>
std::vector<bool> SurfaceForcing<Dim>::are_held(const Points<Dim>& slips, double most) const {
  const Points<Dim> felt = overlap_.means_about(slips);
  std::vector<double> sums(2 * bodies_.size(), 0.0);  // of the squares; of patches that act
  for (std::size_t p = 0; p < felt.size(); ++p) {
    if (shares_[p] == 0) continue;
    const std::size_t b = markers_.body_of(begin() + p);
    sums[2 * b] += felt[p].squaredNorm();
    sums[2 * b + 1] += 1;
  }
  sums = ordered_sum(grid_.comm(), sums);
  std::vector<bool> held;
  for (std::size_t b = 0; b < bodies_.size(); ++b) held.push_back(sums[2 * b] <= most * most * sums[2 * b + 1]);
  return held;
}

template <int Dim>
double SurfaceForcing<Dim>::tolerance(Vec velocity) const {
  double speed = 0, of_markers = 0;
  WASH_PETSC(VecNorm(velocity, NORM_INFINITY, &speed));
  for (const auto& state : states_) of_markers = std::max(of_markers, state.velocity.norm());
  return slip_tolerance_ * std::max(speed, largest(grid_.comm(), of_markers));
}

// J P S F dt/rho
template <int Dim>
Points<Dim> SurfaceForcing<Dim>::response(const Points<Dim>& forces) const {
  const petsc::GlobalVector increment(grid_.face_dm());
  WASH_PETSC(VecZeroEntries(increment));
  accelerate(forces, increment);
  (*project_)(increment);
  const petsc::LocalVector local(grid_.wide_face_dm(), increment);
  boundary_.fill_homogeneous(local);
  return felt_means(transfer_.interpolate(local));
}

template <int Dim>
Points<Dim> SurfaceForcing<Dim>::approximate_forces(const Points<Dim>& velocities) const {
  Points<Dim> forces = overlap_(velocities);
  const double scale = density_ * grid_.cell_volume() / step_.dt;
  for (std::size_t p = 0; p < forces.size(); ++p)
    forces[p] = shares_[p] == 0 ? Point<Dim>(Point<Dim>::Zero()) : held(scale * forces[p], p);
  closed_.remove_from(forces);
  return forces;
}

template <int Dim>
Points<Dim> SurfaceForcing<Dim>::without(const std::vector<bool>& bodies, Points<Dim> values) const {
  for (std::size_t p = 0; p < values.size(); ++p)
    if (bodies[markers_.body_of(begin() + p)]) values[p].setZero();
  return values;
}

template <int Dim>
void SurfaceForcing<Dim>::add_forces(const Points<Dim>& more, Vec velocity) {
  accelerate(more, velocity);
  forces_ += more;
}

template <int Dim>
void SurfaceForcing<Dim>::push(Vec velocity, double relaxation) {
  add_forces(relaxation * approximate_forces(slips(velocity)), velocity);
}

// As pushes before have shown to help, and by the overlap against the rest. Where a law lets water slide, what is held
// differs from step to step, and so do answers.
template <int Dim>
Points<Dim> SurfaceForcing<Dim>::push_against(const Points<Dim>& slips, double relaxation) const {
  if (law_) return relaxation * approximate_forces(slips);
  const auto known = known_pushes_.best_for(turned(slips, false));
  const Points<Dim> rest = slips - turned(known.answers, true);
  return (1 / step_.dt) * turned(known.impulses, true) + relaxation * approximate_forces(rest);
}

template <int Dim>
void SurfaceForcing<Dim>::learn_from_last_push(const Points<Dim>& slips_after) {
  if (!pushed_ || law_) return;
  known_pushes_.add({turned(step_.dt * pushed_->forces, false), turned(pushed_->slips - slips_after, false)});
  pushed_.reset();
}

template <int Dim>
bool SurfaceForcing<Dim>::push_unheld(Vec velocity, double relaxation) {
  const Points<Dim> left = slips(velocity);
  learn_from_last_push(left);
  const std::vector<bool> held = are_held(left, tolerance(velocity));
  if (std::ranges::all_of(held, std::identity())) return false;
  pushed_ = {without(held, push_against(without(held, left), relaxation)), left};
  add_forces(pushed_->forces, velocity);
  return true;
}

template <int Dim>
bool SurfaceForcing<Dim>::hold(const Project& project, Vec velocity) {
  const Points<Dim> left = slips(velocity);
  learn_from_last_push(left);
  slip_left_ = tolerance(velocity);
  if (std::ranges::all_of(are_held(left, slip_left_), std::identity())) return false;
  project_ = &project;
  to_vector<Dim>(left, right_);
  (void)solve_to(solver_, 0, right_, solution_, "walls");
  project_ = nullptr;
  add_forces(to_points<Dim>(solution_), velocity);
  return true;
}

template class SurfaceForcing<2>;
template class SurfaceForcing<3>;

}  // namespace washfsi
