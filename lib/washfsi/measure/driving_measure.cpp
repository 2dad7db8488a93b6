// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/driving_measure.hpp"

namespace washfsi {

template <int Dim>
void DrivingMeasure<Dim>::declare(QuantityList& quantities) {
  const Driving<Dim>& driving = system_.model.fluid.driving();
  for (int d = 0; d < Dim; ++d) {
    if (!driving.drives(d)) continue;
    const std::string axis(1, "xyz"[d]);
    quantities.add({"pressure_gradient_" + axis, "Pa/m",
                    "of the mean pressure, whose force on the water is -gradient times the box's volume",
                    [&driving, d] { return driving.gradient()[d]; }, Accumulation::none,
                    "/driving/pressure_gradient_" + axis});
    quantities.add({"bulk_velocity_" + axis, "m/s", "mean over the box", [this, d] { return bulk_velocity_[d]; },
                    Accumulation::none, "/driving/bulk_velocity_" + axis});
  }
  if (driving.is_there())
    quantities.add(
        {"driving_power", Units<Dim>::power, "that the mean pressure gradient puts in", [this] { return power_; }},
        {{"driving_work", Units<Dim>::energy, OverCycle::integral, "that the mean pressure gradient puts in", 1}});
}

template <int Dim>
void DrivingMeasure<Dim>::observe_start(const Observation<Dim>&) {
  if (system_.model.fluid.driving().is_there())
    bulk_velocity_ = mean_velocity<Dim>(system_.model.grid, system_.model.fluid.velocity());
}

template <int Dim>
void DrivingMeasure<Dim>::observe(const Observation<Dim>& seen) {
  const Model<Dim>& model = system_.model;
  if (!model.fluid.driving().is_there()) return;
  observe_start(seen);
  const Vec share = model.bodies.driven_share();
  const Point<Dim> before = mean_velocity<Dim>(model.grid, model.fluid.velocity_before(), share);
  const Point<Dim> now = share ? mean_velocity<Dim>(model.grid, model.fluid.velocity(), share) : bulk_velocity_;
  const double volume = (model.grid.upper() - model.grid.lower()).prod();
  power_ = -volume * model.fluid.driving().gradient().dot(0.5 * (before + now));
}

template class DrivingMeasure<2>;
template class DrivingMeasure<3>;

}  // namespace washfsi
