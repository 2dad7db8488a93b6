// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/measure/cloth_measure.hpp"

namespace washfsi {

/// The energy that cloth and coupling dissipate: the cloths' gain (from bodies that push them, weight, loads, and their
/// elastic energy) less what they give to the water.
template <int Dim>
class CouplingMeasure : public Measure<Dim> {
 public:
  /// `cloth` must have observed before. Collective.
  CouplingMeasure(const System<Dim>& system, const ClothMeasure<Dim>& cloth);

  void declare(QuantityList& quantities) override;
  void prepare() override;
  void observe(const Observation<Dim>& seen) override;
  void observe_start(const Observation<Dim>&) override;

 private:
  bool couples() const { return system_.model.has_fluid && !cloth_.groups().empty(); }

  const System<Dim>& system_;
  const ClothMeasure<Dim>& cloth_;
  bool is_loaded_ = false;  ///< whether weight or other constant forces act
  double load_power_ = 0;   ///< power of these [W; W/m in the plane]
  double dissipation_ = 0;  ///< dissipated power [W; W/m in the plane]
  double energy_ = 0;       ///< elastic and kinetic energy of all cloths before the step [J; J/m in the plane]
};

extern template class CouplingMeasure<2>;
extern template class CouplingMeasure<3>;

}  // namespace washfsi
