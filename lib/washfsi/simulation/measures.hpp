// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/body/control_volume.hpp"
#include "washfsi/body/wall_loads.hpp"
#include "washfsi/fluid/diagnostics.hpp"
#include "washfsi/simulation/cloth_measures.hpp"

namespace washfsi {

/// What is measured after each step, or after some, and what accumulates over a run.
template <int Dim>
class Measures {
 public:
  explicit Measures(const System<Dim>& system);

  /// Before a step of which `observe` will take all. Collective.
  void prepare();
  /// Takes the state after a step: all of it, or only the flow's. Averages weigh it with the time since all was taken
  /// last. Collective.
  void observe(double dt, bool all);
  /// Takes the state without adding it to the averages. Collective.
  void observe_start(double dt);

  const FlowDiagnostics<Dim>& flow() const { return flow_; }
  const Loads<Dim>& loads() const { return loads_; }  ///< on each body in the last step, by what held the water
  /// The same by the balance of momentum round each body; zero if that is not measured.
  const Loads<Dim>& balance_loads() const { return balance_loads_; }
  bool has_balance() const { return control_volumes_.has_value(); }
  const std::vector<double>& powers() const { return powers_; }  ///< that each body puts into the water [W; W/m]
  /// Sides of the box that are walls, by name, and the loads on them.
  std::vector<std::string> wall_names() const;
  const Loads<Dim>& loads_on_walls() const { return wall_loads_; }
  const ClothMeasures<Dim>& cloth() const { return cloth_; }
  ClothMeasures<Dim>& cloth() { return cloth_; }
  double largest_divergence() const { return largest_divergence_; }

  /// Columns of history.csv after `step`, and their present values.
  std::vector<Column> columns() const;
  std::vector<double> row(double dt) const;

  /// Sums and largest values that a restart needs, beside those at the markers.
  std::vector<double> totals() const;
  void set_totals(const std::vector<double>& totals);
  std::size_t totals_count() const { return 2 + cloth_.totals_count(); }

 private:
  /// `local_velocity`: with its ghosts filled.
  void measure_flow(Vec local_velocity, double dt);
  /// `contact`: the loads of contact on each body.
  void measure_loads(Vec local_velocity, double dt, const Loads<Dim>& contact);
  void measure_cloth_dissipation(double dt, const Loads<Dim>& contact);
  double elastic_energy() const;
  bool couples() const { return system_.has_fluid && !cloth_.groups().empty(); }

  const System<Dim>& system_;
  FlowDiagnostics<Dim> flow_;
  std::vector<SideName> walls_;
  std::optional<ControlVolumes<Dim>> control_volumes_;
  Loads<Dim> loads_, balance_loads_, wall_loads_;
  std::vector<double> powers_;
  ClothMeasures<Dim> cloth_;
  double largest_divergence_ = 0;  ///< [1/s]
  double unmeasured_time_ = 0;     ///< since all was taken last [s]
  double mask_dissipation_ = 0;    ///< [W; W/m in the plane]
  double cloth_dissipation_ = 0;   ///< [W; W/m in the plane]
  double elastic_energy_ = 0;      ///< of all cloths after the last step [J; J/m in the plane]
};

extern template class Measures<2>;
extern template class Measures<3>;

}  // namespace washfsi
