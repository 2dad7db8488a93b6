// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// The total forces on each group of held cloths, of the water and of the springs that hold it, both as means over the
/// step: drag and lift of a flag.
template <int Dim>
class ClothForceMeasure : public Measure<Dim> {
 public:
  explicit ClothForceMeasure(const System<Dim>& system);

  void declare(QuantityList& quantities) override;
  void observe(const Observation<Dim>& seen) override;

 private:
  Points<Dim> sums_of_groups(const Points<Dim>& forces) const;

  const System<Dim>& system_;
  const MarkerForce<Dim>* springs_ = nullptr;
  Points<Dim> by_water_, by_springs_;  ///< forces on each group [N; N/m in the plane]
};

extern template class ClothForceMeasure<2>;
extern template class ClothForceMeasure<3>;

}  // namespace washfsi
