// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/machine/crossings.hpp"
#include "washfsi/machine/tumbling.hpp"
#include "washfsi/output/history.hpp"
#include "washfsi/simulation/system.hpp"

namespace washfsi {

/// What is known of each marker, by name and unit: `stress` at the surface (5.2-2), the sum of `membrane_stress` and
/// `bending_stress`; `stretch` of the edges beside, `curvature`. In space each stress has the components ss, rr and sr,
/// `stress` without one is the mean of ss and rr, and there is the `shear_angle`. Last the washing action of the water,
/// on the mean of both sides: its `relative_speed` along the cloth one and a half cells away, near the edge of the
/// delta, and the `water_shear` viscosity times that over the distance.
template <int Dim>
const std::vector<Column>& marker_quantities();

/// What water does to the cloth at a marker.
struct WashingAction {
  double relative_speed = 0, shear = 0;  ///< [m/s], [Pa]
};

/// The quantities of one marker, in this order.
template <int Dim>
std::vector<double> quantities_of(const MarkerState& state, const WashingAction& action);

/// Numbers of one group of cloths. The vectors have a value for each of `marker_quantities`.
struct GroupMeasures {
  double elastic_energy = 0;      ///< now [J; per unit depth in the plane]
  std::vector<double> now;        ///< means over the markers
  std::vector<double> mean;       ///< (5.2-5): means over the markers of the averages over the run so far
  std::vector<double> deviation;  ///< standard deviations of these over the markers
  double max_stretch = 0;         ///< largest |X_s| - 1 so far
  double depth = 0;               ///< of the deepest marker in any body now [m]; 0 if none is inside
  double max_depth = 0;           ///< the same, largest so far [m]
  double tumbles = 0;             ///< mean turns of its cloths in the (r, z) plane so far; in space
};

/// Stress, deformation and place of the cloths after each step, and over a run.
template <int Dim>
class ClothMeasures {
 public:
  explicit ClothMeasures(const System<Dim>& system);

  /// Takes the state after a step of dt; dt = 0: without adding it to the averages. Collective.
  void observe(double dt);

  const std::vector<GroupMeasures>& groups() const { return groups_; }
  /// In space, where there are sheets.
  const ClothCrossings* crossings() const { return crossings_ ? &*crossings_ : nullptr; }

  /// Columns of history.csv, and their present values.
  std::vector<Column> columns() const;
  std::vector<double> row() const;
  /// Columns of tracks.csv, the centre of each cloth, and their present values.
  std::vector<Column> track_columns() const;
  std::vector<double> track_row() const;

  /// Sums that a restart needs: a number for each quantity of each of this rank's markers, and the totals.
  std::vector<double>& time_integrals() { return time_integrals_; }
  std::vector<double> totals() const;
  void set_totals(std::span<const double> totals);
  std::size_t totals_count() const { return totals().size(); }

 private:
  std::vector<double> sums_by(const std::vector<std::size_t>& part_of, std::size_t parts,
                              const std::vector<double>& marker_values) const;
  std::vector<WashingAction> washing_action() const;
  std::vector<std::vector<double>> means_of(const std::vector<double>& values) const;
  void measure_places();
  void measure_laundry();
  template <class Value>
  Value mean_over_cloths(std::size_t group, const std::vector<Value>& values, Value sum) const;

  const System<Dim>& system_;
  std::vector<GroupMeasures> groups_;
  std::vector<std::size_t> group_of_;   ///< of each of this rank's markers
  std::vector<double> counts_;          ///< markers of each group
  std::vector<Point<Dim>> centers_;     ///< of each cloth [m]
  std::vector<double> time_integrals_;  ///< of the quantities of each marker
  double averaged_time_ = 0;            ///< [s]
  std::optional<TumbleCounter> tumbles_;
  std::optional<ClothCrossings> crossings_;
};

extern template class ClothMeasures<2>;
extern template class ClothMeasures<3>;

}  // namespace washfsi
