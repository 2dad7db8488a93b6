// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// The pressure gradient that drives the water, its power and the bulk velocity, where anything drives it.
template <int Dim>
class DrivingMeasure : public Measure<Dim> {
 public:
  /// The system must outlive it.
  explicit DrivingMeasure(const System<Dim>& system) : system_(system) {}

  void declare(QuantityList& quantities) override;
  void observe(const Observation<Dim>&) override;
  void observe_start(const Observation<Dim>&) override;

 private:
  const System<Dim>& system_;
  Point<Dim> bulk_velocity_ = Point<Dim>::Zero();  ///< bulk velocity [m/s]
  double power_ = 0;                               ///< driving power [W; W/m in the plane]
};

extern template class DrivingMeasure<2>;
extern template class DrivingMeasure<3>;

}  // namespace washfsi
