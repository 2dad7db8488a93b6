// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/cloth/marker_force.hpp"

namespace washfsi {

/// The inertia of the cloth's own excess mass, as a force on the markers and, through them, on the water, whose density
/// is then that of pure water. With the mean velocity W = (X - X^n)/dt of a marker in a step, the excess mass m for
/// which it stands, and its acceleration in the coupling scheme, rate W - known,
///   F_inertia = -m (rate W - known),     stiffness  m rate/dt I,     energy  1/2 m rate/dt |X - X_0|^2
/// where X_0 = X^n + dt known/rate is where the force vanishes. There is none where markers do not move. All is divided
/// by the share w_0 of the forces at the end of a step in its mean force, since inertia acts over the step as a whole.
template <int Dim>
class Inertia : public MarkerForce<Dim> {
 public:
  /// The cloths must outlive it.
  explicit Inertia(const Cloths<Dim>& cloths) : cloths_(cloths) {}

  ForceKind kind() const override { return {.dependence = Dependence::potential}; }
  std::string origin() const override { return "-cloth_inertia"; }
  void begin_step(const StepStart<Dim>& start) override;
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
  void add_energy(const Points<Dim>& positions, std::span<double> of_groups) const override;
  void add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction, Points<Dim>& rates) const override;
  void visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                       const AddMarkerBlock<Dim>& add) const override;
  void add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const override;

 private:
  const Cloths<Dim>& cloths_;
  Points<Dim> unmoved_;            ///< X_0 [m]
  double stiffness_per_mass_ = 0;  ///< rate/(dt w_0) [1/s2]
};

extern template class Inertia<2>;
extern template class Inertia<3>;

}  // namespace washfsi
