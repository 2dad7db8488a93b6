// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/fluid/diagnostics.hpp"
#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// Time, CFL number, energy, divergence and dissipation of the flow.
template <int Dim>
class FlowMeasure : public Measure<Dim> {
 public:
  explicit FlowMeasure(const System<Dim>& system) : system_(system) {}

  void declare(QuantityList& quantities) override;
  void observe(const Observation<Dim>& seen) override;
  /// The divergence at the start does not count: it is not the solver's.
  void observe_start(const Observation<Dim>& seen) override;

  const FlowDiagnostics<Dim>& flow() const { return flow_; }

 private:
  const System<Dim>& system_;
  double dt_ = 0;
  FlowDiagnostics<Dim> flow_;
};

extern template class FlowMeasure<2>;
extern template class FlowMeasure<3>;

}  // namespace washfsi
