// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/momentum_advection.hpp"

#include <utility>

#include "washfsi/fluid/advection.hpp"
#include "washfsi/grid/beside_positive.hpp"
#include "washfsi/grid/field_slab.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr double parabolas_part = 2.0 / 3;  // share of the parabola in advection from three steps

}  // namespace

template <int Dim>
MomentumAdvection<Dim>::MomentumAdvection(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                          const FluidOptions<Dim>& options)
    : grid_(grid),
      scheme_(options.advection),
      limits_at_edges_(options.limits_at_edges),
      bend_(options.advection_steps > 2 ? parabolas_part : 0),
      velocity_dm_(departs_from_central() || boundary.has_outflow() ? grid.wide_face_dm() : grid.face_dm()),
      now_(grid.face_vector()),
      before_(grid.face_vector()),
      earlier_(grid.face_vector()) {}

template <int Dim>
void MomentumAdvection<Dim>::find(const AdvectedFields& fields) {
  {
    const ConstFaceView<Dim> u(velocity_dm_, fields.local_velocity);
    const FaceView<Dim> result(grid_.face_dm(), now_);
    const Spacing<Dim> h(grid_.spacing());
    grid_.for_each_inner_face(
        [&](const Index<Dim>& face, auto c) { result(face, c) = advection<Dim>(u, face, c, h, CentralFlux<Dim>{}); });
  }
  if (limits_at_edges_) {
    const petsc::LocalVector local(grid_.face_dm());
    WASH_PETSC(VecZeroEntries(local));  // beyond the box too
    WASH_PETSC(DMGlobalToLocal(grid_.face_dm(), fields.upwind_weight, INSERT_VALUES, local));
    const ConstFaceView<Dim> near(grid_.face_dm(), local);
    replace(beside_positive(grid_.owned(), near), fields, WallsideFlux<Dim, ConstFaceView<Dim>>(near));
  }
  if (scheme_ == Advection::upwind) replace(grid_.owned(), fields, UpwindFlux<Dim>{});
  if (scheme_ == Advection::wide_central) replace(grid_.owned(), fields, CentralFlux<Dim, WideMean>{});
}

// Replaces the term on this rank's faces of a box where the flux departs from the central one.
template <int Dim>
template <class Flux>
void MomentumAdvection<Dim>::replace(const Box<Dim>& where, const AdvectedFields& fields, const Flux& flux) {
  const ConstFaceView<Dim> u(velocity_dm_, fields.local_velocity), rho(grid_.face_dm(), fields.density);
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fields.fluid_fraction ? fields.fluid_fraction : fields.density);
  const FaceView<Dim> result(grid_.face_dm(), now_);
  const Spacing<Dim> h(grid_.spacing());
  double dissipated = 0;
  grid_.for_each_inner_face(where, [&](const Index<Dim>& face, auto c) {
    if (!flux.departs(face, c)) return;
    const double advected = flux.term(u, face, c, h);
    const double H = fields.fluid_fraction ? fraction(face, c) : 1;
    dissipated += H * rho(face, c) * u(face, c) * (advected - result(face, c));
    result(face, c) = advected;
  });
  numerical_dissipation_ = ordered_sum(grid_.comm(), dissipated * grid_.cell_volume());
}

template <int Dim>
void MomentumAdvection<Dim>::finish(double dt) {
  before_ = std::exchange(now_, std::exchange(earlier_, std::move(before_)));
  dt_earlier_ = std::exchange(dt_before_, dt);
}

template <int Dim>
void MomentumAdvection<Dim>::register_state(StateList& state) {
  state.add(vector_entry("/fluid/advection_before", field_slab(grid_, Dim), before_));
  state.add(vector_entry("/fluid/advection_earlier", field_slab(grid_, Dim), earlier_));
  state.add_number("/fluid/last_step", dt_before_);
  state.add_number("/fluid/step_before_last", dt_earlier_);
}

template class MomentumAdvection<2>;
template class MomentumAdvection<3>;

}  // namespace washfsi
