// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/barrier_options.hpp"
#include "washfsi/contact/barrier_touches.hpp"
#include "washfsi/contact/pair_friction.hpp"

namespace washfsi {

/// The friction of what touches when a step begins, and the damping of its motion along the normal. The normal forces
/// are those of the barrier at that time.
template <int Dim>
class TouchFriction : public PairFriction<Dim> {
 public:
  /// The cloths must outlive it.
  TouchFriction(const BarrierOptions& options, const Cloths<Dim>& cloths)
      : coefficient_(options.friction), damping_(options.damping), cloths_(cloths) {}

  /// Begins a step at these places of all known markers. With dt = 0 nothing slides, unless an explicit step follows:
  /// in this, pairs slide as they do at its start, and are not damped. Collective.
  void begin_step(const StepStart<Dim>& start, const BarrierTouches<Dim>& near, const Points<Dim>& all);

 private:
  using Pair = typename PairFriction<Dim>::Pair;
  std::vector<Pair> pairs(const BarrierTouches<Dim>& near, const Points<Dim>& all, double damping) const;
  double mass_of(const Touch<Dim>& touch, const NearMarkers<Dim>& known) const;

  double coefficient_, damping_;
  const Cloths<Dim>& cloths_;
};

extern template class TouchFriction<2>;
extern template class TouchFriction<3>;

}  // namespace washfsi
