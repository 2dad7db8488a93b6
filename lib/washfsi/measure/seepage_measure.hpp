// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// The power that seepage dissipates in permeable cloth, where there is such cloth.
template <int Dim>
class SeepageMeasure : public Measure<Dim> {
 public:
  /// The system must outlive it.
  explicit SeepageMeasure(const System<Dim>& system) : system_(system) {}

  void declare(QuantityList& quantities) override;
  void observe(const Observation<Dim>&) override {}

 private:
  const System<Dim>& system_;
};

extern template class SeepageMeasure<2>;
extern template class SeepageMeasure<3>;

}  // namespace washfsi
