// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/body/control_volume.hpp"
#include "washfsi/body/wall_loads.hpp"
#include "washfsi/fluid/diagnostics.hpp"
#include "washfsi/output/history.hpp"
#include "washfsi/simulation/system.hpp"

namespace washfsi {

/// Numbers of one group of cloths over the run so far.
struct GroupMeasures {
  double elastic_energy = 0;  ///< now [J; per unit depth in the plane]
  double stress_now = 0;      ///< mean over the markers [Pa]
  double stress_mean = 0;     ///< (5.2-5): of the time averages at the markers [Pa]
  double stress_std = 0;      ///< of the same over the markers [Pa]
  double max_stretch = 0;     ///< largest |X_s| - 1 so far
  double depth = 0;           ///< of the deepest marker in any body now [m]; 0 if none is inside
};

/// What is measured after each step, and what accumulates over a run.
template <int Dim>
class Measures {
 public:
  explicit Measures(const System<Dim>& system);

  /// Takes the state after a step. Collective.
  void observe(double dt);
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
  const std::vector<GroupMeasures>& groups() const { return groups_; }
  double largest_divergence() const { return largest_divergence_; }

  /// Columns of history.csv after `step`, and their present values.
  std::vector<Column> columns() const;
  std::vector<double> row(double dt) const;

  /// Sums that a restart needs: stress times time at each marker [Pa s], the time [s], and the largest values.
  std::vector<double>& stress_time() { return stress_time_; }
  std::vector<double> totals() const;
  void set_totals(const std::vector<double>& totals);
  std::size_t totals_count() const { return 2 + groups_.size(); }

 private:
  void measure_loads(double dt);
  void measure_cloth(double dt, bool accumulate);
  void measure_stress(double dt, bool accumulate);
  void measure_places();
  std::vector<double> group_sums(const std::vector<double>& marker_values) const;

  const System<Dim>& system_;
  FlowDiagnostics<Dim> flow_;
  std::vector<SideName> walls_;
  std::optional<ControlVolumes<Dim>> control_volumes_;
  Loads<Dim> loads_, balance_loads_, wall_loads_;
  std::vector<double> powers_;
  std::vector<GroupMeasures> groups_;
  std::vector<Point<Dim>> centers_;
  std::vector<std::size_t> group_of_;
  std::vector<double> counts_;       ///< markers of each group
  std::vector<double> stress_time_;  ///< integral of the stress over time at each of this rank's markers [Pa s]
  double averaged_time_ = 0;         ///< [s]
  double largest_divergence_ = 0;    ///< [1/s]
};

extern template class Measures<2>;
extern template class Measures<3>;

}  // namespace washfsi
