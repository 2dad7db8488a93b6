// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/momentum_advection.hpp"

#include <utility>

#include "washfsi/grid/field_slab.hpp"

namespace washfsi {

namespace {

constexpr double parabolas_part = 2.0 / 3;  // share of the parabola in advection from three steps

}  // namespace

template <int Dim>
MomentumAdvection<Dim>::MomentumAdvection(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                          const FluidOptions<Dim>& options)
    : grid_(grid),
      scheme_(make_advection_scheme<Dim>(options.advection, grid, options.limits_at_edges)),
      bend_(options.advection_steps > 2 ? parabolas_part : 0),
      velocity_dm_(scheme_->departs_from_central() || boundary.has_outflow() ? grid.wide_face_dm() : grid.face_dm()),
      now_(grid.face_vector()),
      before_(grid.face_vector()),
      earlier_(grid.face_vector()) {}

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
