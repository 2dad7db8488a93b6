// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "washfsi/measure/body_measure.hpp"
#include "washfsi/measure/cloth_measure.hpp"
#include "washfsi/measure/coupling_measure.hpp"
#include "washfsi/measure/cycles.hpp"
#include "washfsi/measure/flow_measure.hpp"
#include "washfsi/measure/intersection_measure.hpp"
#include "washfsi/measure/wall_measure.hpp"
#include "washfsi/statistics/flow_statistics.hpp"
#include "washfsi/statistics/phase_statistics.hpp"

namespace washfsi {

/// The options of measures.
struct MeasureOptions {
  bool balance_loads = false;  ///< whether to measure loads on bodies by the balance of momentum too
  double cycle_time = 0;       ///< length of a cycle [s]; 0: the period of the first body that moves periodically
  MachineAxis machine;         ///< in space
  StatisticsOptions statistics;
  PhaseOptions phases;  ///< in space

  /// Reads them for a box with these corners [m].
  template <int Dim>
  static MeasureOptions from_options(Options& options, const Point<Dim>& lower, const Point<Dim>& upper);
};

/// All measures, taken after each step or after some.
template <int Dim>
class Measures {
 public:
  /// Collective. The system must outlive it.
  Measures(const System<Dim>& system, const MeasureOptions& options);
  Measures(const Measures&) = delete;
  Measures& operator=(const Measures&) = delete;

  /// Counts the intersections of cloths: before the first step, and after each before it is observed. Collective.
  /// Errors: InputError, DivergedError if one is forbidden.
  void verify_start() { intersections_.verify_start(); }
  void verify(double dt) { intersections_.verify(dt); }
  /// Call it before a step after which `observe` takes all. Collective.
  void prepare();
  /// Measures the state after a step: all of it, or only the flow. Averages are weighted with the time since all was
  /// measured last. Collective.
  void observe(double dt, bool all);
  /// Measures the state without adding it to the averages. Collective.
  void observe_start(double dt);

  /// Registers the state carried from step to step: averages and the like.
  void register_state(StateList& state);

  QuantityList& quantities() { return quantities_; }
  const QuantityList& quantities() const { return quantities_; }
  /// The figures of a cycle, over the whole run.
  const Cycles& whole_run() const { return *whole_run_; }
  Cycles& cycles() { return *cycles_; }
  const Cycles& cycles() const { return *cycles_; }
  const FlowDiagnostics<Dim>& flow() const { return flow_.flow(); }
  /// Statistics of the flow; null if none are taken.
  const FlowStatistics<Dim>* statistics() const { return statistics_.get(); }
  /// Statistics over cycles of the machine; null if none are taken.
  const PhaseStatistics* phases() const { return phases_.get(); }
  /// The present values of this rank's markers for cloth.h5. Collective.
  std::vector<MarkerField> marker_fields() const;
  ClothMeasure<Dim>& cloth() { return cloth_; }
  const ClothMeasure<Dim>& cloth() const { return cloth_; }

 private:
  ContactLoads<Dim> contact() const;
  void take_phases(const MeasureOptions& options, double cycle_time);

  const System<Dim>& system_;
  FlowMeasure<Dim> flow_;
  BodyMeasure<Dim> bodies_;
  WallMeasure<Dim> walls_;
  BodyDepths<Dim> depths_;  ///< shared by the counts and the figures of cloths
  ClothMeasure<Dim> cloth_;
  CouplingMeasure<Dim> coupling_;
  IntersectionMeasure<Dim> intersections_;
  std::vector<std::unique_ptr<Measure<Dim>>> further_;
  std::unique_ptr<FlowStatistics<Dim>> statistics_;
  std::unique_ptr<PhaseStatistics> phases_;
  QuantityList quantities_;
  std::optional<Cycles> cycles_, whole_run_;
  double unmeasured_time_ = 0;  ///< time since all was measured last [s]
};

extern template class Measures<2>;
extern template class Measures<3>;

}  // namespace washfsi
