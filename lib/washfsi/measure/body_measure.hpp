// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/mask/control_volume.hpp"
#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// The power of moving a body against its load [W; W/m in the plane]: positive if the body drives the water.
template <int Dim>
double power(const RigidMotion<Dim>& motion, const Load<Dim>& load, double time) {
  return -load.torque[rotation_components<Dim> - 1] * motion.angular_velocity(time) -
         load.force.dot(motion.velocity(motion.center_at(time), time));
}

/// Loads on bodies and their power.
template <int Dim>
class BodyMeasure : public Measure<Dim> {
 public:
  /// `balance`: whether to measure the loads also by the balance of momentum round each body.
  BodyMeasure(const System<Dim>& system, bool balance);

  void declare(QuantityList& quantities) override;
  void prepare() override;
  void observe(const Observation<Dim>& seen) override;
  void observe_start(const Observation<Dim>&) override { prepare(); }

 private:
  Loads<Dim> inner_momenta() const;
  Loads<Dim> inner_inertia(double dt);
  void observe_markers(const WallForces<Dim>& walls, double dt);

  const System<Dim>& system_;
  std::optional<ControlVolumes<Dim>> control_volumes_;
  Loads<Dim> loads_, balance_loads_;
  Loads<Dim> inner_momenta_;     ///< momenta of the water inside bodies in direct forcing, after the previous step
  std::vector<double> powers_;   ///< power of each body on the water [W; W/m in the plane]
  std::vector<double> slips_;    ///< rms slip of the water at each body's markers [m/s]
  double mask_dissipation_ = 0;  ///< [W; W/m in the plane]
};

extern template class BodyMeasure<2>;
extern template class BodyMeasure<3>;

}  // namespace washfsi
