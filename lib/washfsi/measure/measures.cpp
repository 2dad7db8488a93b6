// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/measures.hpp"

#include <algorithm>
#include <utility>

#include "washfsi/measure/cloth_force_measure.hpp"
#include "washfsi/measure/contact_measure.hpp"
#include "washfsi/measure/driving_measure.hpp"
#include "washfsi/measure/eddy_measure.hpp"
#include "washfsi/measure/seepage_measure.hpp"

namespace washfsi {

namespace {

// All further measures. Their columns come last.
template <int Dim>
std::vector<std::unique_ptr<Measure<Dim>>> further_measures(const System<Dim>& system) {
  std::vector<std::unique_ptr<Measure<Dim>>> measures;
  measures.push_back(std::make_unique<ClothForceMeasure<Dim>>(system));
  measures.push_back(std::make_unique<ContactMeasure<Dim>>(system));
  measures.push_back(std::make_unique<SeepageMeasure<Dim>>(system));
  measures.push_back(std::make_unique<DrivingMeasure<Dim>>(system));
  measures.push_back(std::make_unique<EddyMeasure<Dim>>(system));
  return measures;
}

// The period of the first body that has one; 0 if none has.
template <int Dim>
double first_period(const std::vector<Body<Dim>>& bodies) {
  for (const auto& body : bodies)
    if (body.motion.period() > 0) return body.motion.period();
  return 0;
}

// The options, completed from the bodies where the user gives none.
PhaseOptions completed(PhaseOptions phases, double cycle_time, const Model<3>& model, const MachineAxis& machine) {
  if (phases.period == 0) phases.period = cycle_time;
  if (phases.center) return phases;
  const auto turns = [](const Body<3>& body) { return body.motion.only_turns() && !body.motion.at_rest(); };
  const auto turning = std::ranges::find_if(model.body_list, turns);
  if (turning != model.body_list.end())
    phases.center = turning->motion.center_at(0);
  else
    phases.center = Point<3>(machine.axis[0], machine.axis[1], 0.5 * (model.grid.lower()[2] + model.grid.upper()[2]));
  return phases;
}

}  // namespace

template <int Dim>
MeasureOptions MeasureOptions::from_options(Options& options, const Point<Dim>& lower, const Point<Dim>& upper) {
  MeasureOptions measure;
  options.block("", "Loads", [&](OptionBlock& block) {
    block.boolean("body_balance", measure.balance_loads,
                  "measure the loads on bodies by the balance of momentum round them too: a check");
  });
  options.block("", "Cycles", [&](OptionBlock& block) {
    block.real("cycle_time", measure.cycle_time, "s", non_negative,
               "of the cycles in cycles.csv; 0: the period of the first body that moves periodically");
  });
  measure.statistics = StatisticsOptions::from_options(options);
  measure.phases = PhaseOptions::from_options(options, measure.statistics, Dim);
  if constexpr (Dim == 3) measure.machine = MachineAxis::from_options(options, lower, upper);
  return measure;
}

template <int Dim>
Measures<Dim>::Measures(const System<Dim>& system, const MeasureOptions& options)
    : system_(system),
      flow_(system),
      bodies_(system, options.balance_loads),
      walls_(system),
      depths_(system.model.cloths, system.model.grid, system.model.body_list),
      cloth_(system, options.machine, depths_),
      coupling_(system, cloth_),
      intersections_(system, depths_),
      further_(further_measures(system)) {
  flow_.declare(quantities_);
  bodies_.declare(quantities_);
  walls_.declare(quantities_);
  coupling_.declare(quantities_);
  cloth_.declare(quantities_);
  intersections_.declare(quantities_);
  for (const auto& measure : further_) measure->declare(quantities_);
  quantities_.keep("unmeasured_time", {&unmeasured_time_, 1});
  if (options.statistics.take) {
    statistics_ = std::make_unique<FlowStatistics<Dim>>(system.model.grid, options.statistics);
    quantities_.keep("statistics", statistics_->kept(), QuantityList::IfOther::begin_anew);
  }
  const double cycle_time = options.cycle_time > 0 ? options.cycle_time : first_period(system.model.body_list);
  take_phases(options, cycle_time);
  cycles_.emplace(quantities_, cycle_time, "cycle");
  whole_run_.emplace(quantities_, Cycles::whole_run, "run");
}

template <int Dim>
void Measures<Dim>::take_phases(const MeasureOptions& options, double cycle_time) {
  if constexpr (Dim == 3) {
    if (options.phases.count == 0) return;
    const PhaseOptions phases = completed(options.phases, cycle_time, system_.model, options.machine);
    phases_ = std::make_unique<PhaseStatistics>(system_.model.grid, phases);
    quantities_.keep("phases", phases_->kept(), QuantityList::IfOther::begin_anew);
  }
}

template <int Dim>
ContactLoads<Dim> Measures<Dim>::contact() const {
  const Model<Dim>& model = system_.model;
  ContactLoads<Dim> loads = contact_loads<Dim>(model.forces, system_.step.evaluated_at, model.body_list.size());
  if (system_.step.end_share < 1) loads = weighed(system_.step.end_share, loads, system_.step.contact_at_start);
  loads.bodies = ordered_sum<Dim>(model.grid.comm(), loads.bodies);
  Loads<Dim> sides;
  for (const auto& ends : loads.sides) sides.insert(sides.end(), ends.begin(), ends.end());
  sides = ordered_sum<Dim>(model.grid.comm(), sides);
  for (std::size_t s = 0; s < sides.size(); ++s) loads.sides[s / 2][s % 2] = sides[s];
  return loads;
}

template <int Dim>
void Measures<Dim>::observe_start(double dt) {
  const Model<Dim>& model = system_.model;
  const GhostedVelocity<Dim> velocity(model.boundary, model.grid.face_dm(), model.fluid.velocity(),
                                      system_.state.clock.time);
  const Observation<Dim> seen{dt, 0, velocity, {Loads<Dim>(model.body_list.size()), {}}};
  flow_.observe_start(seen);
  bodies_.observe_start(seen);
  cloth_.observe_start(seen);
  coupling_.observe_start(seen);
  for (const auto& measure : further_) measure->observe_start(seen);
  if (system_.state.clock.step == 0) quantities_.accumulate();  // else restored from the checkpoint
  for (auto* cycles : {&cycles_, &whole_run_}) (*cycles)->begin(system_.state.clock.time);
  if (statistics_) statistics_->begin();
  if (phases_) phases_->begin();
}

template <int Dim>
std::vector<MarkerField> Measures<Dim>::marker_fields() const {
  std::vector<MarkerField> fields = cloth_.marker_fields();
  for (const auto& measure : further_)
    for (auto& field : measure->marker_fields()) fields.push_back(std::move(field));
  return fields;
}

template <int Dim>
void Measures<Dim>::prepare() {
  if (unmeasured_time_ == 0) return;
  bodies_.prepare();
  coupling_.prepare();
  for (const auto& measure : further_) measure->prepare();
}

template <int Dim>
void Measures<Dim>::observe(double dt, bool all) {
  const petsc::LogPart part("measures");
  const Model<Dim>& model = system_.model;
  const GhostedVelocity<Dim> velocity(model.boundary, model.grid.face_dm(), model.fluid.velocity(),
                                      system_.state.clock.time);
  Observation<Dim> seen{dt, 0, velocity, {}};
  unmeasured_time_ += dt;
  flow_.observe(seen);
  if (all) {
    seen.interval = std::exchange(unmeasured_time_, 0.0);
    seen.contact = contact();
    bodies_.observe(seen);
    walls_.observe(seen);
    cloth_.observe(seen);
    coupling_.observe(seen);
    for (const auto& measure : further_) measure->observe(seen);
  }
  if (statistics_) statistics_->observe(system_.state.clock.time, dt, {velocity, model.fluid.projection().pressure()});
  if (phases_)
    phases_->observe(system_.state.clock.time, dt,
                     {velocity, model.bodies.fluid_share(), model.liquid.pure().density, model.liquid.pure().viscosity,
                      model.liquid.viscosity()});
  quantities_.accumulate();
  for (auto* cycles : {&cycles_, &whole_run_}) (*cycles)->observe(system_.state.clock.time, seen.interval);
}

template MeasureOptions MeasureOptions::from_options<2>(Options&, const Point<2>&, const Point<2>&);
template MeasureOptions MeasureOptions::from_options<3>(Options&, const Point<3>&, const Point<3>&);
template <int Dim>
void Measures<Dim>::register_state(StateList& state) {
  cloth_.register_state(state);
  quantities_.register_state(state);
}

template class Measures<2>;
template class Measures<3>;

}  // namespace washfsi
