// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/output/history.hpp"
#include "washfsi/simulation/system.hpp"

namespace washfsi {

/// Mean over the markers of a group of what a marker bears: now, or of the averages over time.
struct MarkerMeans {
  double stress = 0;            ///< at the surface, (5.2-2): the sum of the next two [Pa]
  double membrane = 0;          ///< |T|/q [Pa]
  double bending = 0;           ///< 6 |M|/q2 [Pa]
  double stretch = 0;           ///< of its edges, | |X_s| - 1 |
  double curvature = 0;         ///< |X_ss| [1/m]
  double stress_deviation = 0;  ///< standard deviation of the stress over the markers [Pa]
};

/// Numbers of one group of cloths.
struct GroupMeasures {
  double elastic_energy = 0;  ///< now [J; per unit depth in the plane]
  MarkerMeans now;
  MarkerMeans mean;        ///< (5.2-5): over the markers of the averages over the run so far
  double max_stretch = 0;  ///< largest |X_s| - 1 so far
  double depth = 0;        ///< of the deepest marker in any body now [m]; 0 if none is inside
  double max_depth = 0;    ///< the same, largest so far [m]
};

/// Stress, deformation and place of the cloths after each step, and over a run.
template <int Dim>
class ClothMeasures {
 public:
  explicit ClothMeasures(const System<Dim>& system);

  /// Takes the state after a step of dt; dt = 0: without adding it to the averages. Collective.
  void observe(double dt);

  const std::vector<GroupMeasures>& groups() const { return groups_; }

  /// Columns of history.csv, and their present values.
  std::vector<Column> columns() const;
  std::vector<double> row() const;
  /// Columns of tracks.csv, the centre of each cloth, and their present values.
  std::vector<Column> track_columns() const;
  std::vector<double> track_row() const;

  /// Sums that a restart needs: `marker_sums` numbers at each of this rank's markers, and the totals.
  static constexpr int marker_sums = 4;
  std::vector<double>& time_integrals() { return time_integrals_; }
  std::vector<double> totals() const;
  void set_totals(std::span<const double> totals);
  std::size_t totals_count() const { return 1 + 2 * groups_.size(); }

 private:
  std::vector<double> sums_by(const std::vector<std::size_t>& part_of, std::size_t parts,
                              const std::vector<double>& marker_values) const;
  std::vector<MarkerMeans> means_of(const std::vector<MarkerState>& states) const;
  void measure_places();

  const System<Dim>& system_;
  std::vector<GroupMeasures> groups_;
  std::vector<std::size_t> group_of_;   ///< of each of this rank's markers
  std::vector<double> counts_;          ///< markers of each group
  std::vector<Point<Dim>> centers_;     ///< of each cloth [m]
  std::vector<double> time_integrals_;  ///< of membrane and bending stress [Pa s], stretch [s], curvature [s/m]
  double averaged_time_ = 0;            ///< [s]
};

extern template class ClothMeasures<2>;
extern template class ClothMeasures<3>;

}  // namespace washfsi
