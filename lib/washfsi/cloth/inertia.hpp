// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/cloth/marker_force.hpp"

namespace washfsi {

/// The inertia of the cloth's own excess mass, as a force on the markers and, through them, on the water, whose density
/// then is its own: I = -m dV/dt with the velocity V that a marker has at the end of the step. With a step of length dt
/// that moves it by X - X^n,
///   V = V^n + ((X - X^n)/dt - V^n) / weight,
///   I = -m c (V - W)/dt,      energy  1/2 m c weight |V - W|^2,      stiffness  m c / (weight dt^2)
/// Backward Euler has c = 1, W = V^n; the second backward difference (BDF2), with r the ratio of this step to the last,
///   c = (1 + 2 r)/(1 + r),    W = ( (1 + r) V^n - r^2/(1 + r) V^(n-1) ) / c
/// Before a step, of length 0, it is what the last one ended with: -m (V^n - V^(n-1))/dt^(n-1).
template <int Dim>
class Inertia : public MarkerForce<Dim> {
 public:
  /// The cloths must outlive it.
  explicit Inertia(const Cloths<Dim>& cloths) : cloths_(cloths) {}

  Dependence dependence() const override { return Dependence::potential; }
  std::string origin() const override { return "-cloth_inertia"; }
  void begin_step(const StepStart<Dim>& start) override;
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
  void add_energy(const Points<Dim>& positions, std::span<double> of_groups) const override;
  void add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction, Points<Dim>& rates) const override;
  void visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                       const AddMarkerBlock<Dim>& add) const override;
  void add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const override;

 private:
  /// What a mass at a place multiplies with to the stiffness [1/s2].
  double stiffness_per_mass() const { return factor_ / (weight_ * dt_ * dt_); }

  const Cloths<Dim>& cloths_;
  Points<Dim> unmoved_;             ///< where a marker would feel no inertia [m]; for a step
  Points<Dim> last_accelerations_;  ///< before a step [m/s2]
  double dt_ = 0, factor_ = 1, weight_ = 1;
};

extern template class Inertia<2>;
extern template class Inertia<3>;

}  // namespace washfsi
