// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/surface_forcing.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/coupling/marker_vectors.hpp"
#include "washfsi/fluid/krylov.hpp"
#include "washfsi/forcing/edge_nearness.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Narrow, and smooth for what moves over the grid.
constexpr DeltaOptions delta{DeltaKernel::yang, 2, 2};

template <int Dim>
MarkerLayout<Dim> layout_for(const Grid<Dim>& grid, const BodyTreatment& treatment) {
  return {grid.spacing(), treatment.marker_spacing, KernelMoments(delta.kernel, delta.spread_width),
          treatment.inner_water_slides};
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
      markers_(grid, bodies, layout_for(grid, treatment)) {
  const MarkerLayout<Dim> layout = layout_for(grid, treatment);
  for (std::size_t b = 0; b < bodies.size(); ++b) inverses_.emplace_back(markers_.of_body(b), layout);
  const auto ranks = static_cast<std::size_t>(ranks_of(grid.comm()));
  for (std::size_t rank = 0; rank <= ranks; ++rank)
    starts_.push_back(static_cast<int>(Dim * (markers_.patches() * rank / ranks)));
  for (std::size_t rank = 0; rank < ranks; ++rank) counts_.push_back(starts_[rank + 1] - starts_[rank]);
  const auto rank = static_cast<std::size_t>(rank_of(grid.comm()));
  begin_ = static_cast<std::size_t>(starts_[rank] / Dim);
  end_ = static_cast<std::size_t>(starts_[rank + 1] / Dim);
  forces_.assign(owned(), Point<Dim>::Zero());
  kept_ = forces_;
  create_solver();
  if (treatment.limits_advection && markers_.any_is_sharp()) nearness_ = grid.face_vector();
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
  WASH_PETSC(KSPSetType(solver_, KSPCG));
  WASH_PETSC(KSPSetNormType(solver_, KSP_NORM_UNPRECONDITIONED));
  PC pc = nullptr;
  WASH_PETSC(KSPGetPC(solver_, &pc));
  WASH_PETSC(PCSetType(pc, PCSHELL));
  WASH_PETSC(PCShellSetContext(pc, this));
  WASH_PETSC(PCShellSetApply(pc, &SurfaceForcing::precondition));
  WASH_PETSC(KSPSetTolerances(solver_, 1e-50, PETSC_DEFAULT, PETSC_DEFAULT, 1000));
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
    to_vector<Dim>(static_cast<SurfaceForcing*>(self)->approximate_forces(to_points<Dim>(x)), y);
  });
}

template <int Dim>
void SurfaceForcing<Dim>::update(double time) {
  const PosedBodies<Dim> posed(bodies_, time);
  time_ = time;
  states_.clear();
  shares_.assign(owned(), 0.0);
  Points<Dim> places;
  for (std::size_t p = begin_; p < end_; ++p) {
    bool acts = false;
    for (std::size_t m = markers_.start(p); m < markers_.start(p + 1); ++m) {
      states_.push_back(markers_.at(posed, p, m, time));
      places.push_back(states_.back().place);
      acts = acts || states_.back().acts;
    }
    // that of a whole patch, so that a part of one does not respond more than its overlap foresees
    if (acts) shares_[p - begin_] = 1.0 / static_cast<double>(markers_.start(p + 1) - markers_.start(p));
  }
  transfer_.locate(places);
  if (!nearness_) return;
  std::vector<bool> at_edges(states_.size(), false);
  for_each_acting([&](std::size_t, std::size_t m) { at_edges[m] = markers_.is_sharp(markers_.start(begin_) + m); });
  find_edge_nearness<Dim>(grid_, transfer_, at_edges, nearness_);
}

// Calls visit(patch, marker) for all markers that act, both counted from this rank's first.
template <int Dim>
template <class Visit>
void SurfaceForcing<Dim>::for_each_acting(Visit&& visit) const {
  const std::size_t first = markers_.start(begin_);
  for (std::size_t p = begin_; p < end_; ++p)
    for (std::size_t m = markers_.start(p) - first; m < markers_.start(p + 1) - first; ++m)
      if (states_[m].acts) visit(p - begin_, m);
}

template <int Dim>
void SurfaceForcing<Dim>::let_slide(const BodyWallLaw<Dim>& law) {
  law_ = &law;
  slides_ = law.part();
  const auto first = law.patch_normals().begin();
  slide_normals_.assign(first + static_cast<std::ptrdiff_t>(begin_), first + static_cast<std::ptrdiff_t>(end_));
}

// What of a patch's velocity or force is not free to slide.
template <int Dim>
Point<Dim> SurfaceForcing<Dim>::held(const Point<Dim>& value, std::size_t patch) const {
  if (slides_ == 0 || normals_[patch].isZero(0)) return value;
  return value - slides_ * (value - value.dot(normals_[patch]) * normals_[patch]);
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

template <int Dim>
Points<Dim> SurfaceForcing<Dim>::turned(const Points<Dim>& values, bool into_space) const {
  std::vector<Pose<Dim>> turns;
  for (const auto& body : bodies_) turns.push_back(Pose<Dim>::at(Point<Dim>::Zero(), body.motion.angle(time_)));
  Points<Dim> result(values.size());
  for (std::size_t p = 0; p < values.size(); ++p) {
    const Pose<Dim>& turn = turns[markers_.body_of(begin_ + p)];
    result[p] = into_space ? turn.in_space(values[p]) : turn.in_body_frame(values[p]);
  }
  return result;
}

template <int Dim>
void SurfaceForcing<Dim>::begin_trial(const TimeStep& step, Vec density) {
  step_ = step;
  fluid_density_ = density;
  forces_ = turned(kept_, true);
  if (slides_ > 0) normals_ = turned(slide_normals_, true);
}

template <int Dim>
void SurfaceForcing<Dim>::accept() {
  Points<Dim> acting = forces_;  // what is not passed on must not return when it is
  for (std::size_t p = 0; p < acting.size(); ++p) acting[p] = held(acting[p], p);
  kept_ = turned(acting, false);
}

template <int Dim>
void SurfaceForcing<Dim>::add_held(Vec force) {
  (void)transfer_.spread(shared_out(forces_), force);
  if (law_) law_->add_friction(force);
}

// u += dt S F / rho
template <int Dim>
void SurfaceForcing<Dim>::accelerate(const Points<Dim>& forces, Vec velocity) const {
  const petsc::GlobalVector pushed(grid_.face_dm());
  WASH_PETSC(VecZeroEntries(pushed));
  (void)transfer_.spread(shared_out(forces), pushed);
  WASH_PETSC(VecPointwiseDivide(pushed, pushed, fluid_density_));
  WASH_PETSC(VecAXPY(velocity, step_.dt, pushed));
}

// U - J u
template <int Dim>
Points<Dim> SurfaceForcing<Dim>::slips(Vec velocity) const {
  const GhostedVelocity<Dim> local(boundary_, grid_.wide_face_dm(), velocity, time_);
  Points<Dim> result = transfer_.interpolate(local);
  for (std::size_t m = 0; m < result.size(); ++m) result[m] = states_[m].velocity - result[m];
  return means(result);
}

template <int Dim>
double SurfaceForcing<Dim>::rms(const Points<Dim>& values) const {
  std::vector<double> sums{0, 0};
  for (std::size_t p = 0; p < values.size(); ++p) {
    sums[0] += values[p].squaredNorm();
    sums[1] += shares_[p] > 0 ? 1 : 0;
  }
  sums = ordered_sum(grid_.comm(), sums);
  return std::sqrt(sums[0] / std::max(sums[1], 1.0));
}

template <int Dim>
double SurfaceForcing<Dim>::lost_power(Vec velocity_before, Vec velocity, double dt) const {
  const GhostedVelocity<Dim> mean(boundary_, grid_.wide_face_dm(), velocity_before, time_ - dt),
      now(boundary_, grid_.wide_face_dm(), velocity, time_);
  WASH_PETSC(VecAXPBY(mean, 0.5, 0.5, now));
  const Points<Dim> given = shared_out(forces_), of_water = transfer_.interpolate(mean);
  double lost = 0;
  for_each_acting([&](std::size_t p, std::size_t m) {
    const RigidMotion<Dim>& motion = bodies_[markers_.body_of(begin_ + p)].motion;
    const Point<Dim> own = motion.velocity(states_[m].place, time_ - 0.5 * dt);
    lost += given[m].dot(own - of_water[m]);
  });
  return ordered_sum(grid_.comm(), lost);
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
  return means(transfer_.interpolate(local));
}

template <int Dim>
Points<Dim> SurfaceForcing<Dim>::approximate_forces(const Points<Dim>& velocities) const {
  Points<Dim> all(markers_.patches());
  MPI_Allgatherv(velocities.data(), static_cast<int>(Dim * velocities.size()), MPI_DOUBLE, all.data(), counts_.data(),
                 starts_.data(), MPI_DOUBLE, grid_.comm());
  const double scale = density_ * grid_.cell_volume() / step_.dt;
  Points<Dim> forces;
  std::size_t first = 0;
  for (std::size_t b = 0; b < inverses_.size(); ++b) {
    const std::size_t count = markers_.of_body(b).size();
    const auto start = all.begin() + static_cast<std::ptrdiff_t>(first);
    if (first < end_ && first + count > begin_) {
      const Points<Dim> of_body = inverses_[b](Points<Dim>(start, start + static_cast<std::ptrdiff_t>(count)));
      for (std::size_t m = std::max(first, begin_); m < std::min(first + count, end_); ++m)
        forces.push_back(scale * of_body[m - first]);
    }
    first += count;
  }
  for (std::size_t p = 0; p < forces.size(); ++p)
    forces[p] = shares_[p] == 0 ? Point<Dim>(Point<Dim>::Zero()) : held(forces[p], p);
  return forces;
}

template <int Dim>
void SurfaceForcing<Dim>::push(Vec velocity) {
  const Points<Dim> more = approximate_forces(slips(velocity));
  accelerate(more, velocity);
  forces_ += more;
}

template <int Dim>
bool SurfaceForcing<Dim>::holds(Vec velocity) const {
  return rms(slips(velocity)) <= tolerance(velocity);
}

template <int Dim>
void SurfaceForcing<Dim>::hold(const Project& project, Vec velocity) {
  project_ = &project;
  to_vector<Dim>(slips(velocity), right_);
  const double to_norm = std::sqrt(static_cast<double>(markers_.patches()));
  (void)solve_to(solver_, 0.5 * tolerance(velocity) * to_norm, right_, solution_, "walls");
  project_ = nullptr;
  const Points<Dim> more = to_points<Dim>(solution_);
  accelerate(more, velocity);
  forces_ += more;
}

// What sides keep of each marker's force, of which a share is asked for.
template <int Dim>
Points<Dim> SurfaceForcing<Dim>::kept_by_sides(const typename Boundary<Dim>::OnSides& shares,
                                               const std::optional<SideName>& only) const {
  Points<Dim> kept = shared_out(forces_);
  const petsc::LocalVector local(grid_.wide_face_dm());
  boundary_.fill_from_rest(local, shares, only);
  const Points<Dim> parts = transfer_.interpolate_from_sides(local);
  for (std::size_t m = 0; m < kept.size(); ++m) kept[m] = kept[m].cwiseProduct(parts[m]);
  return kept;
}

// What a body's force leaves in a side that moves with it has never left the body.
template <int Dim>
Loads<Dim> SurfaceForcing<Dim>::loads() const {
  Loads<Dim> loads = law_ ? law_->loads_here() : Loads<Dim>(bodies_.size());
  const Points<Dim> given = shared_out(forces_);
  const Points<Dim> kept = kept_by_sides([&](auto... place) { return boundary_.covered_share(place..., time_); });
  for_each_acting([&](std::size_t p, std::size_t m) {
    const std::size_t b = markers_.body_of(begin_ + p);
    loads[b].add(states_[m].place - bodies_[b].motion.center_at(time_), kept[m] - given[m]);
  });
  return ordered_sum<Dim>(grid_.comm(), loads);
}

template <int Dim>
Loads<Dim> SurfaceForcing<Dim>::loads_on_sides(const std::vector<SideName>& sides) const {
  Loads<Dim> loads(sides.size());
  const Point<Dim> middle = 0.5 * (grid_.lower() + grid_.upper());
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const SideName side = sides[s];
    if (!any_rank(grid_.comm(), !boundary_.covered_wholly(side.axis, side.end))) continue;
    const Points<Dim> kept =
        kept_by_sides([&](auto... place) { return 1 - boundary_.covered_share(place..., time_); }, side);
    for_each_acting([&](std::size_t, std::size_t m) {
      Point<Dim> place = states_[m].place;
      place[side.axis] = (side.end == End::lower ? grid_.lower() : grid_.upper())[side.axis];
      loads[s].add(place - middle, kept[m]);
    });
  }
  return ordered_sum<Dim>(grid_.comm(), loads);
}

template class SurfaceForcing<2>;
template class SurfaceForcing<3>;

}  // namespace washfsi
