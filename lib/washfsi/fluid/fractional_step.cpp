// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/fractional_step.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/fluid/adams_bashforth.hpp"
#include "washfsi/fluid/advection.hpp"
#include "washfsi/grid/beside_positive.hpp"
#include "washfsi/grid/field_slab.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr double parabolas_part = 2.0 / 3;  // share of the parabola in advection from three steps

}  // namespace

template <int Dim>
FractionalStep<Dim>::FractionalStep(const Grid<Dim>& grid, Boundary<Dim>& boundary, const FluidOptions<Dim>& options)
    : grid_(grid),
      boundary_(boundary),
      pressure_tolerance_(options.pressure_tolerance),
      projects_(options.projection),
      limits_at_edges_(options.limits_at_edges),
      advection_scheme_(options.advection),
      advection_bend_(options.advection_steps > 2 ? parabolas_part : 0),
      flow_dm_(departs_from_central() || boundary.has_outflow() ? grid.wide_face_dm() : grid.face_dm()),
      momentum_(grid, boundary, options.momentum_tolerance),
      poisson_(grid),
      driving_(grid, options.driving),
      velocity_(grid.face_vector()),
      velocity_before_(grid.face_vector()),
      intermediate_(grid.face_vector()),
      advection_(grid.face_vector()),
      advection_before_(grid.face_vector()),
      advection_earlier_(grid.face_vector()),
      rhs_(grid.face_vector()),
      pressure_(grid.cell_vector()),
      phi_(grid.cell_vector()),
      minus_divergence_(grid.cell_vector()) {
  start([](const Point<Dim>&, int) { return 0; });
}

template <int Dim>
void FractionalStep<Dim>::start(const VelocityAt<Dim>& velocity) {
  {
    const FaceView<Dim> u(grid_.face_dm(), velocity_);
    for (int c = 0; c < Dim; ++c)
      for_each<Dim>(grid_.owned(),
                    [&](const Index<Dim>& face) { u(face, c) = velocity(grid_.face_center(face, c), c); });
  }
  if (boundary_.has_outflow()) boundary_.start_outflow(petsc::LocalVector(flow_dm_, velocity_), 0.0);
  boundary_.set_boundary_faces(velocity_, 0.0);
}

template <int Dim>
void FractionalStep<Dim>::advance(const TimeStep& step, const StepFields<Dim>& fields) {
  predict(step, fields);
  project();
  finish();
}

template <int Dim>
void FractionalStep<Dim>::predict(const TimeStep& step, const StepFields<Dim>& fields) {
  const petsc::LogPart part("momentum");
  step_ = step;
  fields_ = fields;
  add_further_forces();
  explicit_terms();
  // the guesses: linear extrapolation of the two last velocities, and a pressure that changes at the same rate as
  // before
  const double ratio = dt_before_ > 0 ? step.dt / dt_before_ : 0;
  WASH_PETSC(VecAXPBYPCZ(intermediate_, 1 + ratio, -ratio, 0.0, velocity_, velocity_before_));
  if (ratio > 0 && ratio != 1) WASH_PETSC(VecScale(phi_, ratio * ratio));
  momentum_.set_step(step.dt, fields.liquid, fields.constraint);
  counts_.momentum += static_cast<double>(momentum_.solve(rhs_, step.end(), intermediate_));
  find_constraint_force();
  poisson_.set_density(fields.liquid.density,
                       fields.constraint.in_projection ? fields.constraint.fluid_fraction : nullptr);
  driving_.keep_bulk(step.dt, fields.liquid.density,
                     fields.driven_share ? fields.driven_share : fields.constraint.fluid_fraction, intermediate_);
}

template <int Dim>
void FractionalStep<Dim>::add_further_forces() {
  if (!fields_.further_force && !fields_.driven_share) return;
  if (!force_) force_ = grid_.face_vector();
  WASH_PETSC(VecCopy(fields_.force, force_));
  fields_.force = force_;
  if (fields_.driven_share) driving_.add_reaction_of_undriven(fields_.driven_share, force_);
  if (fields_.further_force) fields_.further_force->add_to(force_);
}

template <int Dim>
void FractionalStep<Dim>::find_constraint_force() {
  if (!fields_.constraint.fluid_fraction) return;
  if (!constraint_force_) constraint_force_ = grid_.face_vector();
  momentum_.constraint_force(rhs_, step_.end(), intermediate_, constraint_force_);
  if (fields_.driven_share) driving_.add_reaction_of_undriven(fields_.driven_share, constraint_force_);
}

template <int Dim>
void FractionalStep<Dim>::explicit_terms() {
  const GhostedVelocity<Dim> local_u(boundary_, flow_dm_, velocity_, step_.start);
  const petsc::LocalVector local_p(grid_.cell_dm(), pressure_);
  boundary_.advance_outflow(local_u, step_.start, step_.dt);
  advect(local_u, fields_.liquid.density);
  with_viscosity<Dim>(grid_, fields_.liquid.viscosity,
                      [&](const auto& viscosity) { sum_explicit_terms(viscosity, local_u, local_p); });
}

// All that the loop reads is a local copy, so that the compiler knows that no store changes it.
template <int Dim>
template <class Form>
void FractionalStep<Dim>::sum_explicit_terms(const Form& viscosity, Vec local_u, Vec local_p) {
  const double dt = step_.dt, half_viscosity = 0.5 * viscosity.scale;
  const AdvectionWeights weights = adams_bashforth(advection_bend_, dt, last_step(), dt_earlier_);
  const Spacing<Dim> h(grid_.spacing());
  const ConstFaceView<Dim> u(flow_dm_, local_u), f(grid_.face_dm(), fields_.force);
  const ConstFaceView<Dim> rho(grid_.face_dm(), fields_.liquid.density);
  const ConstFaceView<Dim> now(grid_.face_dm(), advection_), before(grid_.face_dm(), advection_before_);
  const ConstFaceView<Dim> earlier(grid_.face_dm(), advection_earlier_);
  const ConstCellView<Dim> p(grid_.cell_dm(), local_p);
  const Point<Dim> mean_gradient = driving_.begin();
  const FaceView<Dim> b(grid_.face_dm(), rhs_);
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    const double stress =
        half_viscosity * viscosity.force(u, face, c) - gradient<Dim>(p, face, c, h) - mean_gradient[c];
    const double advected =
        weights.now * now(face, c) + weights.before * before(face, c) + weights.earlier * earlier(face, c);
    b(face, c) = u(face, c) + dt * ((stress + f(face, c)) / rho(face, c) - advected);
  });
}

template <int Dim>
void FractionalStep<Dim>::advect(Vec local_velocity, Vec density) {
  const ConstFaceView<Dim> u(flow_dm_, local_velocity), rho(grid_.face_dm(), density);
  const Spacing<Dim> h(grid_.spacing());
  {
    const FaceView<Dim> result(grid_.face_dm(), advection_);
    grid_.for_each_inner_face(
        [&](const Index<Dim>& face, auto c) { result(face, c) = advection<Dim>(u, face, c, h, CentralFlux<Dim>{}); });
  }
  if (limits_at_edges_) {
    const petsc::LocalVector local(grid_.face_dm());
    WASH_PETSC(VecZeroEntries(local));  // beyond the box too
    WASH_PETSC(DMGlobalToLocal(grid_.face_dm(), fields_.upwind_weight, INSERT_VALUES, local));
    const ConstFaceView<Dim> near(grid_.face_dm(), local);
    replace_advection(beside_positive(grid_.owned(), near), u, rho, WallsideFlux<Dim, ConstFaceView<Dim>>(near));
  }
  if (advection_scheme_ == Advection::upwind) replace_advection(grid_.owned(), u, rho, UpwindFlux<Dim>{});
  if (advection_scheme_ == Advection::wide_central)
    replace_advection(grid_.owned(), u, rho, CentralFlux<Dim, WideMean>{});
}

// Replaces advection on this rank's faces of a box.
template <int Dim>
template <class Flux>
void FractionalStep<Dim>::replace_advection(const Box<Dim>& where, const ConstFaceView<Dim>& u,
                                            const ConstFaceView<Dim>& rho, const Flux& flux) {
  const FaceView<Dim> result(grid_.face_dm(), advection_);
  const Spacing<Dim> h(grid_.spacing());
  const Vec fluid_fraction = fields_.constraint.fluid_fraction;  // constrained water is not advected
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fluid_fraction ? fluid_fraction : fields_.liquid.density);
  double dissipated = 0;
  grid_.for_each_inner_face(where, [&](const Index<Dim>& face, auto c) {
    if (!flux.departs(face, c)) return;
    const double advected = advection<Dim>(u, face, c, h, flux);
    const double H = fluid_fraction ? fraction(face, c) : 1;
    dissipated += H * rho(face, c) * u(face, c) * (advected - result(face, c));
    result(face, c) = advected;
  });
  numerical_dissipation_ = ordered_sum(grid_.comm(), dissipated * grid_.cell_volume());
}

template <int Dim>
void FractionalStep<Dim>::project() {
  if (!projects_) return;
  const petsc::LogPart part("pressure");
  solve_pressure(phi_);
  add_viscous_pressure();
}

// Projects again after a further force. The guess is not the last solution, which a restart does not have.
template <int Dim>
void FractionalStep<Dim>::project_again() {
  if (!phi_of_force_) phi_of_force_ = grid_.cell_vector();
  WASH_PETSC(VecZeroEntries(phi_of_force_));
  solve_pressure(phi_of_force_);
}

template <int Dim>
void FractionalStep<Dim>::project_increment(Vec increment) {
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
  const double tolerance = looser * pressure_tolerance_ * speed / grid_.spacing().minCoeff();
  counts_.pressure += static_cast<double>(poisson_.solve(minus_divergence_, tolerance, phi));
  poisson_.correct(phi, increment);
}

template <int Dim>
void FractionalStep<Dim>::find_minus_divergence(Vec local_velocity) {
  const ConstFaceView<Dim> u(grid_.face_dm(), local_velocity);
  const CellView<Dim> r(grid_.cell_dm(), minus_divergence_);
  const Spacing<Dim> h(grid_.spacing());
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) { r(cell) = -divergence<Dim>(u, cell, h); });
}

// Adds the pressure that balances the viscous force of the velocity's correction.
template <int Dim>
void FractionalStep<Dim>::add_viscous_pressure() {
  const Viscosity& viscosity = fields_.liquid.viscosity;
  if (!viscosity.in_cells) {
    WASH_PETSC(VecAXPY(pressure_, 0.5 * viscosity.everywhere / grid_.cell_volume(), minus_divergence_));
    return;
  }
  const ConstCellView<Dim> mu(grid_.cell_dm(), viscosity.in_cells), r(grid_.cell_dm(), minus_divergence_);
  const CellView<Dim> p(grid_.cell_dm(), pressure_);
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) { p(cell) += mu(cell) * r(cell) / grid_.cell_volume(); });
}

// Solves for phi and the pressure that make the intermediate velocity divergence free; phi contains a guess. Leaves
// -div u* times the cell volume, which `add_viscous_pressure` needs.
template <int Dim>
void FractionalStep<Dim>::solve_pressure(Vec phi) {
  {
    const GhostedVelocity<Dim> local(boundary_, grid_.face_dm(), intermediate_, step_.end());
    find_minus_divergence(local);
  }
  const double tolerance =
      poisson_.is_direct() ? 0 : pressure_tolerance_ * largest_speed() / grid_.spacing().minCoeff();
  counts_.pressure += static_cast<double>(poisson_.solve(minus_divergence_, tolerance, phi));
  poisson_.correct(phi, intermediate_);
  WASH_PETSC(VecAXPY(pressure_, poisson_.reference_density() / step_.dt, phi));  // p += q
}

template <int Dim>
double FractionalStep<Dim>::largest_speed() const {
  double speed = 0;
  WASH_PETSC(VecNorm(intermediate_, NORM_INFINITY, &speed));
  return std::max(speed, boundary_.largest_speed(step_.end()));
}

template <int Dim>
void FractionalStep<Dim>::add_force(Vec force) {
  const Vec fluid_fraction = fields_.constraint.fluid_fraction;
  const FaceView<Dim> u(grid_.face_dm(), intermediate_),
      solid(grid_.face_dm(), fluid_fraction ? constraint_force_ : intermediate_);
  const ConstFaceView<Dim> f(grid_.face_dm(), force), rho(grid_.face_dm(), fields_.liquid.density),
      fraction(grid_.face_dm(), fluid_fraction ? fluid_fraction : force);
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    const double H = fluid_fraction ? fraction(face, c) : 1;
    u(face, c) += step_.dt * H * f(face, c) / rho(face, c);
    if (fluid_fraction) solid(face, c) -= (1 - H) * f(face, c);
  });
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
void FractionalStep<Dim>::finish() {
  velocity_before_ = std::exchange(velocity_, std::exchange(intermediate_, std::move(velocity_before_)));
  advection_before_ = std::exchange(advection_, std::exchange(advection_earlier_, std::move(advection_before_)));
  driving_.accept(dt_before_ == 0);
  dt_earlier_ = dt_before_;
  dt_before_ = step_.dt;
  boundary_.accept_outflow();
}

template <int Dim>
void FractionalStep<Dim>::register_state(StateList& state) {
  const auto field = [&](const std::string& name, int components, const petsc::Vector& vector) {
    state.add(vector_entry("/fluid/" + name, field_slab(grid_, components), vector));
  };
  field("velocity", Dim, velocity_);
  field("velocity_before", Dim, velocity_before_);
  field("advection_before", Dim, advection_before_);
  field("advection_earlier", Dim, advection_earlier_);
  field("pressure", 1, pressure_);
  field("phi", 1, phi_);
  state.add_number("/fluid/last_step", dt_before_);
  state.add_number("/fluid/step_before_last", dt_earlier_);
  state.add_number("/fluid/momentum_iterations", counts_.momentum);
  state.add_number("/fluid/pressure_iterations", counts_.pressure);
  driving_.register_state(state);
}

template class FractionalStep<2>;
template class FractionalStep<3>;

}  // namespace washfsi
