// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_law/filtered_velocities.hpp"

#include <utility>

#include "washfsi/support/point_vectors.hpp"

namespace washfsi {

template <int Dim>
void FilteredVelocities<Dim>::take(std::size_t point, const Point<Dim>& at_near, const Point<Dim>& at_far,
                                   double distance, double dt) {
  const double rate = at_far.norm() / distance, weight = begun_ ? dt * rate / (1 + dt * rate) : 1;
  Point<Dim>* mean = &values_[of_each * point];
  mean[0] += weight * (at_far - mean[0]);
  mean[1] += weight * (at_near - mean[1]);
}

template <int Dim>
void FilteredVelocities<Dim>::register_state(StateList& state, std::size_t first, std::size_t count) {
  const Slab slab = row_slab(of_each * count, of_each * first, of_each * first + values_.size(), Dim);
  StateEntry& entry = state.add(points_entry<Dim>("/walls/filtered", slab, values_));
  entry.if_other = StateEntry::IfOther::begin_anew;
  entry.use = StateEntry::Use::restart;
  entry.set = [this, copy = entry.set](StateEntry::Values values) {
    copy(std::move(values));
    begun_ = true;
  };
}

template class FilteredVelocities<2>;
template class FilteredVelocities<3>;

}  // namespace washfsi
