// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/measure/body_depths.hpp"
#include "washfsi/measure/crossings.hpp"
#include "washfsi/measure/machine_axis.hpp"
#include "washfsi/measure/marker_means.hpp"
#include "washfsi/measure/marker_samples.hpp"
#include "washfsi/measure/measure.hpp"
#include "washfsi/measure/paths.hpp"
#include "washfsi/measure/tumbling.hpp"
#include "washfsi/output/series.hpp"

namespace washfsi {

/// Numbers of one group of cloths. The vectors have a value for each of `marker_quantities`.
template <int Dim>
struct GroupMeasures {
  double elastic_energy = 0;               ///< now [J; per unit depth in the plane]
  std::vector<double> now;                 ///< means over the markers
  std::vector<double> mean;                ///< (5.2-5): means over the markers of the averages over the run so far
  std::vector<double> deviation;           ///< standard deviations of these over the markers
  double stretch = 0;                      ///< largest |X_s| - 1 now
  double depth = 0;                        ///< depth of the deepest face in a body now [m]; 0 if none is inside
  double tumbles = 0;                      ///< mean turns of its cloths in the (r, z) plane so far; in space
  Point<Dim> center = Point<Dim>::Zero();  ///< mean of its cloths' centres [m]
};

/// Stress, deformation and place of the cloths.
template <int Dim>
class ClothMeasure : public Measure<Dim> {
 public:
  /// All arguments must outlive it.
  ClothMeasure(const System<Dim>& system, const MachineAxis& machine, BodyDepths<Dim>& depths);

  void declare(QuantityList& quantities) override;
  void observe(const Observation<Dim>& seen) override;
  void observe_start(const Observation<Dim>& seen) override { observe(seen); }

  const std::vector<GroupMeasures<Dim>>& groups() const { return groups_; }
  double elastic_energy() const;  ///< energy of all cloths [J; per unit depth in the plane]

  /// The columns of tracks.csv, the centre of each cloth, and their present values.
  std::vector<Column> track_columns() const;
  std::vector<double> track_row() const;

  std::vector<MarkerField> marker_fields() const override;

  /// Registers the integrals over time of each quantity of each marker.
  void register_state(StateList& state);

 private:
  void declare_all(QuantityList& quantities);
  void declare_group(QuantityList& quantities, std::size_t group);
  void declare_markers(QuantityList& quantities, std::size_t group);
  void measure_markers(double interval);
  double path(std::size_t group) const;  ///< mean path of its cloths [m]
  void measure_places();
  void measure_depths();
  void measure_laundry();

  const System<Dim>& system_;
  std::vector<GroupMeasures<Dim>> groups_;
  MarkerMeans<Dim> means_;
  std::vector<Point<Dim>> centers_;     ///< centre of each cloth [m]
  Paths<Dim> paths_;                    ///< paths of the centres
  std::vector<double> time_integrals_;  ///< integrals over time of the quantities of each marker
  double averaged_time_ = 0;            ///< time over which they are integrated [s]
  double step_error_ = 0;               ///< error of the last step [m/s]
  BodyDepths<Dim>& depths_;
  std::optional<TumbleCounter> tumbles_;
  std::optional<ClothCrossings> crossings_;
};

extern template class ClothMeasure<2>;
extern template class ClothMeasure<3>;

}  // namespace washfsi
