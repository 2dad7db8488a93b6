// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/fractional_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "washfsi/fluid/stencils.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
FractionalStep<Dim>::FractionalStep(const Grid<Dim>& grid, Boundary<Dim>& boundary, const FluidOptions<Dim>& options)
    : grid_(grid),
      boundary_(boundary),
      density_(options.density),
      viscosity_(options.viscosity),
      pressure_tolerance_(options.pressure_tolerance),
      projects_(options.projection),
      advection_scheme_(options.advection),
      flow_dm_(departs_from_central() || boundary.has_outflow() ? grid.wide_face_dm() : grid.face_dm()),
      momentum_(grid, boundary, options.viscosity, options.momentum_tolerance),
      poisson_(grid, options.density),
      velocity_(grid.face_vector()),
      velocity_before_(grid.face_vector()),
      intermediate_(grid.face_vector()),
      advection_(grid.face_vector()),
      advection_before_(grid.face_vector()),
      rhs_(grid.face_vector()),
      constraint_force_(grid.face_vector()),
      pressure_(grid.cell_vector()),
      phi_(grid.cell_vector()),
      minus_divergence_(grid.cell_vector()) {
  set_initial_velocity(options);
}

template <int Dim>
void FractionalStep<Dim>::set_initial_velocity(const FluidOptions<Dim>& options) {
  const bool vortices = options.initial == "taylor_green", uniform = options.initial == "uniform";
  const Point<Dim> wave = 2 * std::numbers::pi * (grid_.upper() - grid_.lower()).cwiseInverse();
  {
    const FaceView<Dim> u(grid_.face_dm(), velocity_);
    for (int c = 0; c < Dim; ++c)
      for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
        const Point<Dim> angle = wave.cwiseProduct(grid_.face_center(face, c) - grid_.lower());
        // u = (-cos kx sin ly, (k/l) sin kx cos ly): one wave in the x,y plane, divergence free
        if (vortices && c == 0) u(face, c) = -std::cos(angle[0]) * std::sin(angle[1]);
        if (vortices && c == 1) u(face, c) = wave[0] / wave[1] * std::sin(angle[0]) * std::cos(angle[1]);
        if (uniform) u(face, c) = options.initial_velocity[c];
      });
  }
  if (boundary_.has_outflow()) boundary_.start_outflow(petsc::LocalVector(flow_dm_, velocity_), 0.0);
  boundary_.set_boundary_faces(velocity_, 0.0);
}

template <int Dim>
void FractionalStep<Dim>::set_time(double time) {
  time_ = time;
  boundary_.set_outflow_time(time);
}

template <int Dim>
void FractionalStep<Dim>::advance(double dt, const StepFields<Dim>& fields) {
  predict(dt, fields);
  project();
  finish();
}

template <int Dim>
void FractionalStep<Dim>::predict(double dt, const StepFields<Dim>& fields) {
  const petsc::LogPart part("momentum");
  dt_ = dt;
  fields_ = fields;
  explicit_terms(dt, fields);
  // the guesses: linear extrapolation of the two last velocities, and a pressure that changes at the same rate as
  // before
  const double ratio = has_history_ ? dt / dt_before_ : 0;
  WASH_PETSC(VecAXPBYPCZ(intermediate_, 1 + ratio, -ratio, 0.0, velocity_, velocity_before_));
  if (has_history_ && ratio != 1) WASH_PETSC(VecScale(phi_, ratio * ratio));
  momentum_.set_step(dt, fields.density, fields.constraint);
  counts_.momentum += static_cast<double>(momentum_.solve(rhs_, time_ + dt, intermediate_));
  if (fields.constraint.fluid_fraction) momentum_.constraint_force(rhs_, time_ + dt, intermediate_, constraint_force_);
  poisson_.set_density(fields.density, fields.constraint.in_projection ? fields.constraint.fluid_fraction : nullptr);
}

template <int Dim>
void FractionalStep<Dim>::explicit_terms(double dt, const StepFields<Dim>& fields) {
  const GhostedVelocity<Dim> local_u(boundary_, flow_dm_, velocity_, time_);
  const petsc::LocalVector local_p(grid_.cell_dm(), pressure_);
  boundary_.advance_outflow(local_u, time_, dt);
  advect(local_u, fields.density);
  // Adams-Bashforth for steps of different length: 3/2 and -1/2 when they are equal
  const double weight_before = has_history_ ? -0.5 * dt / dt_before_ : 0, weight = 1 - weight_before;
  const Spacing<Dim> h(grid_.spacing());
  const ConstFaceView<Dim> u(flow_dm_, local_u), f(grid_.face_dm(), fields.force);
  const ConstFaceView<Dim> rho(grid_.face_dm(), fields.density);
  const ConstFaceView<Dim> now(grid_.face_dm(), advection_), before(grid_.face_dm(), advection_before_);
  const ConstCellView<Dim> p(grid_.cell_dm(), local_p);
  const FaceView<Dim> b(grid_.face_dm(), rhs_);
  const double half_viscosity = 0.5 * viscosity_;
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    const double stress = half_viscosity * laplacian<Dim>(u, face, c, h) - gradient<Dim>(p, face, c, h);
    const double advected = weight * now(face, c) + weight_before * before(face, c);
    b(face, c) = u(face, c) + dt * ((stress + f(face, c)) / rho(face, c) - advected);
  });
}

template <int Dim>
void FractionalStep<Dim>::advect(Vec local_velocity, Vec density) {
  const ConstFaceView<Dim> u(flow_dm_, local_velocity), rho(grid_.face_dm(), density);
  const FaceView<Dim> result(grid_.face_dm(), advection_);
  const Spacing<Dim> h(grid_.spacing());
  grid_.for_each_inner_face(
      [&](const Index<Dim>& face, auto c) { result(face, c) = advection<Dim>(u, face, c, h, CentralFlux<Dim>{}); });
  const auto replace_by = [&](const auto& flux) {
    double dissipated = 0;
    grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
      const double advected = advection<Dim>(u, face, c, h, flux);
      dissipated += rho(face, c) * u(face, c) * (advected - result(face, c));
      result(face, c) = advected;
    });
    numerical_dissipation_ = ordered_sum(grid_.comm(), dissipated * grid_.cell_volume());
  };
  if (advection_scheme_ == "upwind") replace_by(UpwindFlux<Dim>{});
  if (advection_scheme_ == "wide_central") replace_by(CentralFlux<Dim, WideMean>{});
}

template <int Dim>
void FractionalStep<Dim>::project() {
  if (!projects_) return;
  const petsc::LogPart part("pressure");
  solve_pressure(phi_);
  WASH_PETSC(VecAXPY(pressure_, 0.5 * viscosity_ / grid_.cell_volume(), minus_divergence_));
}

// phi and the pressure that make the intermediate velocity divergence free; phi holds a guess. Leaves minus the
// divergence, times the cell volume, that there was.
template <int Dim>
void FractionalStep<Dim>::solve_pressure(Vec phi) {
  {
    const GhostedVelocity<Dim> local(boundary_, grid_.face_dm(), intermediate_, time_ + dt_);
    const ConstFaceView<Dim> u(grid_.face_dm(), local);
    const CellView<Dim> r(grid_.cell_dm(), minus_divergence_);
    const Spacing<Dim> h(grid_.spacing());
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) { r(cell) = -divergence<Dim>(u, cell, h); });
  }
  const double tolerance = pressure_tolerance_ * largest_speed() / grid_.spacing().minCoeff();
  counts_.pressure += static_cast<double>(poisson_.solve(minus_divergence_, tolerance, phi));
  poisson_.correct(phi, intermediate_);
  WASH_PETSC(VecAXPY(pressure_, density_ / dt_, phi));  // p += q
}

template <int Dim>
double FractionalStep<Dim>::largest_speed() const {
  double speed = 0;
  WASH_PETSC(VecNorm(intermediate_, NORM_INFINITY, &speed));
  return std::max(speed, boundary_.largest_speed(time_ + dt_));
}

template <int Dim>
void FractionalStep<Dim>::add_force(Vec force) {
  const petsc::LogPart part("pressure");
  {
    const Vec fraction = fields_.constraint.fluid_fraction;
    const FaceView<Dim> u(grid_.face_dm(), intermediate_), held(grid_.face_dm(), constraint_force_);
    const ConstFaceView<Dim> f(grid_.face_dm(), force), rho(grid_.face_dm(), fields_.density),
        share(grid_.face_dm(), fraction ? fraction : force);
    grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
      const double in_water = fraction ? share(face, c) : 1;
      u(face, c) += dt_ * in_water * f(face, c) / rho(face, c);
      if (fraction) held(face, c) -= (1 - in_water) * f(face, c);
    });
  }
  if (!projects_) return;
  if (!phi_of_force_) phi_of_force_ = grid_.cell_vector();
  WASH_PETSC(VecZeroEntries(phi_of_force_));  // not the last one: a restart does not know it
  solve_pressure(phi_of_force_);
}

template <int Dim>
void FractionalStep<Dim>::keep_pressure() {
  if (!kept_pressure_) kept_pressure_ = grid_.cell_vector();
  WASH_PETSC(VecCopy(pressure_, kept_pressure_));
}

template <int Dim>
void FractionalStep<Dim>::restore_pressure() {
  WASH_PETSC(VecCopy(kept_pressure_, pressure_));
}

template <int Dim>
void FractionalStep<Dim>::pass(double dt) {
  dt_before_ = dt_ = dt;
  set_time(time_ + dt);
  ++counts_.steps;
}

template <int Dim>
void FractionalStep<Dim>::finish() {
  velocity_before_ = std::exchange(velocity_, std::exchange(intermediate_, std::move(velocity_before_)));
  std::swap(advection_before_, advection_);
  has_history_ = true;
  dt_before_ = dt_;
  time_ += dt_;
  boundary_.accept_outflow();
  ++counts_.steps;
}

template <int Dim>
std::vector<std::pair<std::string, Vec>> FractionalStep<Dim>::face_state() const {
  return {{"velocity", velocity_}, {"velocity_before", velocity_before_}, {"advection_before", advection_before_}};
}

template <int Dim>
std::vector<std::pair<std::string, Vec>> FractionalStep<Dim>::cell_state() const {
  return {{"pressure", pressure_}, {"phi", phi_}};
}

template class FractionalStep<2>;
template class FractionalStep<3>;

}  // namespace washfsi
