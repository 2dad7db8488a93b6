// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/mask/control_volume.hpp"
#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// What moving a body against its load costs [W; W/m in the plane]: positive if the body drives the water.
template <int Dim>
double power(const RigidMotion<Dim>& motion, const Load<Dim>& load, double time) {
  return -load.torque[rotation_components<Dim> - 1] * motion.angular_velocity(time) -
         load.force.dot(motion.velocity(motion.center_at(time), time));
}

/// Loads on bodies and their power.
template <int Dim>
class BodyMeasure : public Measure<Dim> {
 public:
  /// `balance`: measures the loads by the balance of momentum round each body too.
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
  Loads<Dim> inner_momenta_;     ///< of the water inside bodies that markers hold, after the step before
  std::vector<double> powers_;   ///< that each body puts into the water [W; W/m in the plane]
  std::vector<double> slips_;    ///< of the water at markers [m/s]
  double mask_dissipation_ = 0;  ///< [W; W/m in the plane]
};

extern template class BodyMeasure<2>;
extern template class BodyMeasure<3>;

}  // namespace washfsi
