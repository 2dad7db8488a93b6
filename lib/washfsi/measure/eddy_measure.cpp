// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/eddy_measure.hpp"

#include <algorithm>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
void EddyMeasure<Dim>::declare(QuantityList& quantities) {
  if (!system_.model.liquid.has_models()) return;
  quantities.add({"eddy_viscosity_mean", "Pa s", "mean over the box of what `-turbulence` added in the step",
                  [this] { return mean_; }});
  quantities.add({"eddy_viscosity_max", "Pa s", "the largest of a cell", [this] { return largest_; },
                  Accumulation::largest, "/max_eddy_viscosity"});
}

template <int Dim>
void EddyMeasure<Dim>::observe(const Observation<Dim>&) {
  const Model<Dim>& model = system_.model;
  if (!model.liquid.has_models()) return;
  double sum = 0;
  largest_ = 0;
  model.liquid.visit_added_viscosity([&](double viscosity) {
    sum += viscosity;
    largest_ = std::max(largest_, viscosity);
  });
  mean_ = ordered_sum(model.grid.comm(), sum) / model.grid.cell_count();
  largest_ = largest(model.grid.comm(), largest_);
}

template class EddyMeasure<2>;
template class EddyMeasure<3>;

}  // namespace washfsi
