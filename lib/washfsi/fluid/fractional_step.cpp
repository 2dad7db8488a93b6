// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/fractional_step.hpp"

#include <utility>

#include "washfsi/grid/field_slab.hpp"

namespace washfsi {

template <int Dim>
FractionalStep<Dim>::FractionalStep(const Grid<Dim>& grid, Boundary<Dim>& boundary, const FluidOptions<Dim>& options)
    : grid_(grid),
      boundary_(boundary),
      advection_(grid, boundary, options),
      momentum_(grid, boundary, options.momentum_tolerance),
      projection_(grid, boundary, options),
      driving_(grid, options.driving),
      velocity_(grid.face_vector()),
      velocity_before_(grid.face_vector()),
      intermediate_(grid.face_vector()),
      rhs_(grid.face_vector()) {
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
  if (boundary_.has_outflow()) boundary_.start_outflow(petsc::LocalVector(advection_.velocity_dm(), velocity_), 0.0);
  boundary_.set_boundary_faces(velocity_, 0.0);
}

template <int Dim>
void FractionalStep<Dim>::predict(const TimeStep& step, const StepFields<Dim>& fields) {
  const petsc::LogPart part("momentum");
  step_ = step;
  fields_ = fields;
  add_further_forces();
  explicit_terms();
  solve_momentum();
  projection_.begin(step, last_step(), fields.liquid, fields.constraint, intermediate_);
  driving_.keep_bulk(step.dt, fields.liquid.density,
                     fields.driven_share ? fields.driven_share : fields.constraint.fluid_fraction, intermediate_);
}

// All force density of a step is the given one, that of the force fields, and the reaction of what is not driven.
template <int Dim>
void FractionalStep<Dim>::add_further_forces() {
  if (fields_.force_fields.empty() && !fields_.driven_share) return;
  if (!force_) force_ = grid_.face_vector();
  WASH_PETSC(VecCopy(fields_.force, force_));
  fields_.force = force_;
  if (fields_.driven_share) driving_.add_reaction_of_undriven(fields_.driven_share, force_);
  for (const ForceField* field : fields_.force_fields) field->add_to(force_);
}

template <int Dim>
void FractionalStep<Dim>::explicit_terms() {
  const GhostedVelocity<Dim> local_u(boundary_, advection_.velocity_dm(), velocity_, step_.start);
  const petsc::LocalVector local_p(grid_.cell_dm(), projection_.pressure());
  boundary_.advance_outflow(local_u, step_.start, step_.dt);
  advection_.find({advection_.velocity_dm(), local_u, fields_.liquid.density, fields_.constraint.fluid_fraction,
                   fields_.upwind_weight});
  with_viscosity<Dim>(grid_, fields_.liquid.viscosity,
                      [&](const auto& viscosity) { sum_explicit_terms(viscosity, local_u, local_p); });
}

// All that the loop reads is a local copy, so that the compiler knows that no store changes it.
template <int Dim>
template <class Form>
void FractionalStep<Dim>::sum_explicit_terms(const Form& viscosity, Vec local_u, Vec local_p) {
  const double dt = step_.dt, half_viscosity = 0.5 * viscosity.scale;
  const AdvectionWeights weights = advection_.weights(dt);
  const Spacing<Dim> h(grid_.spacing());
  const ConstFaceView<Dim> u(advection_.velocity_dm(), local_u), f(grid_.face_dm(), fields_.force);
  const ConstFaceView<Dim> rho(grid_.face_dm(), fields_.liquid.density);
  const ConstFaceView<Dim> now(grid_.face_dm(), advection_.now()), before(grid_.face_dm(), advection_.before());
  const ConstFaceView<Dim> earlier(grid_.face_dm(), advection_.earlier());
  const ConstCellView<Dim> p(grid_.cell_dm(), local_p);
  const Point<Dim> mean_gradient = driving_.begin_trial();
  const FaceView<Dim> b(grid_.face_dm(), rhs_);
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    const double stress =
        half_viscosity * viscosity.force(u, face, c) - gradient<Dim>(p, face, c, h) - mean_gradient[c];
    const double advected =
        weights.now * now(face, c) + weights.before * before(face, c) + weights.earlier * earlier(face, c);
    b(face, c) = u(face, c) + dt * ((stress + f(face, c)) / rho(face, c) - advected);
  });
}

// Solves for u*, starting from the linear extrapolation of the two last velocities, and finds the force of solids.
template <int Dim>
void FractionalStep<Dim>::solve_momentum() {
  const double ratio = last_step() > 0 ? step_.dt / last_step() : 0;
  WASH_PETSC(VecAXPBYPCZ(intermediate_, 1 + ratio, -ratio, 0.0, velocity_, velocity_before_));
  momentum_.set_step(step_.dt, fields_.liquid, fields_.constraint);
  momentum_.solve(rhs_, step_.end(), intermediate_);
  if (!fields_.constraint.fluid_fraction) return;
  if (!constraint_force_) constraint_force_ = grid_.face_vector();
  momentum_.constraint_force(rhs_, step_.end(), intermediate_, constraint_force_);
  if (fields_.driven_share) driving_.add_reaction_of_undriven(fields_.driven_share, constraint_force_);
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
void FractionalStep<Dim>::finish() {
  velocity_before_ = std::exchange(velocity_, std::exchange(intermediate_, std::move(velocity_before_)));
  driving_.accept(last_step() == 0);
  advection_.finish(step_.dt);
  boundary_.accept_outflow();
}

template <int Dim>
void FractionalStep<Dim>::register_state(StateList& state) {
  state.add(vector_entry("/fluid/velocity", field_slab(grid_, Dim), velocity_));
  state.add(vector_entry("/fluid/velocity_before", field_slab(grid_, Dim), velocity_before_));
  momentum_.register_state(state);
  advection_.register_state(state);
  projection_.register_state(state);
  driving_.register_state(state);
}

template class FractionalStep<2>;
template class FractionalStep<3>;

}  // namespace washfsi
