// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/eddy_measure.hpp"

#include <algorithm>

#include "washfsi/support/collective.hpp"

namespace washfsi {

// Whether y+ at walls is measured, as it is with eddies too.
template <int Dim>
bool EddyMeasure<Dim>::models_walls() const {
  const Liquid<Dim>& liquid = system_.model.liquid;
  return liquid.pure().viscosity > 0 && (liquid.has_models() || liquid.walls());
}

template <int Dim>
void EddyMeasure<Dim>::declare(QuantityList& quantities) {
  if (models_walls())
    quantities.add(
        {"wall_y_plus_max", "-",
         "largest y+ of the middle of a cell beside no-slip sides of the box, by Reichardt's law at the next",
         [this] { return y_plus_; }, Accumulation::largest, "/max_wall_y_plus"});
  body_y_plus_.assign(system_.model.bodies.wall_law() ? system_.model.body_list.size() : 0, 0.0);
  for (std::size_t b = 0; b < body_y_plus_.size(); ++b) {
    const std::string& name = system_.model.body_list[b].name;
    quantities.add({name + "_y_plus_max", "-",
                    "with `-wall_model`: largest y+ of half a cell before the body, by Reichardt's law for the "
                    "velocity three cells off",
                    [this, b] { return body_y_plus_[b]; }, Accumulation::largest, "/bodies/" + name + "/max_y_plus"});
  }
  if (!system_.model.liquid.has_models()) return;
  quantities.add({"eddy_viscosity_mean", "Pa s", "mean over the box of what `-turbulence` added in the step",
                  [this] { return mean_; }});
  quantities.add({"eddy_viscosity_max", "Pa s", "the largest of a cell", [this] { return largest_; },
                  Accumulation::largest, "/max_eddy_viscosity"});
}

template <int Dim>
void EddyMeasure<Dim>::observe(const Observation<Dim>& seen) {
  const Model<Dim>& model = system_.model;
  if (models_walls())
    y_plus_ =
        largest_y_plus<Dim>(model.grid, model.boundary, {model.grid.face_dm(), seen.velocity}, model.liquid.pure());
  if (model.bodies.wall_law()) body_y_plus_ = model.bodies.wall_law()->largest_y_plus();
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
