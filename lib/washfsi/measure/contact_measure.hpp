// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/barrier.hpp"
#include "washfsi/measure/measure.hpp"
#include "washfsi/scheme/system.hpp"

namespace washfsi {

/// How hard cloths press each other, and the power of their friction, where the barrier keeps them apart.
template <int Dim>
class ContactMeasure : public Measure<Dim> {
 public:
  /// The system must outlive it.
  explicit ContactMeasure(const System<Dim>& system);

  void declare(QuantityList& quantities) override;
  void observe(const Observation<Dim>& seen) override;

 private:
  struct Group {
    double normal_force = 0, friction_power = 0;  ///< [N, W; per unit depth in the plane]
  };

  const System<Dim>& system_;
  const Barrier<Dim>* barrier_ = nullptr;  ///< null if there is none
  std::vector<Group> groups_;
};

extern template class ContactMeasure<2>;
extern template class ContactMeasure<3>;

}  // namespace washfsi
