// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/cloth_measures.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
ClothMeasures<Dim>::ClothMeasures(const System<Dim>& system)
    : system_(system),
      groups_(system.cloths.groups().size()),
      centers_(system.cloths.pieces().size(), Point<Dim>::Zero()),
      time_integrals_(marker_sums * system.cloths.owned(), 0.0) {
  for (const std::size_t piece : system.cloths.piece_of_marker())
    group_of_.push_back(system.cloths.pieces()[piece].group);
  counts_ = sums_by(group_of_, groups_.size(), std::vector<double>(group_of_.size(), 1.0));
}

// Sums over the markers of each part, groups or cloths.
template <int Dim>
std::vector<double> ClothMeasures<Dim>::sums_by(const std::vector<std::size_t>& part_of, std::size_t parts,
                                                const std::vector<double>& marker_values) const {
  std::vector<double> sums(parts, 0.0);
  for (std::size_t m = 0; m < marker_values.size(); ++m) sums[part_of[m]] += marker_values[m];
  return ordered_sum(system_.grid.comm(), sums);
}

template <int Dim>
std::vector<MarkerMeans> ClothMeasures<Dim>::means_of(const std::vector<MarkerState>& states) const {
  const auto mean = [&](auto&& value) {
    std::vector<double> values;
    for (const MarkerState& state : states) values.push_back(value(state));
    std::vector<double> sums = sums_by(group_of_, groups_.size(), values);
    for (std::size_t g = 0; g < sums.size(); ++g) sums[g] /= counts_[g];
    return sums;
  };
  const auto membrane = mean([](const MarkerState& s) { return s.membrane_stress; });
  const auto bending = mean([](const MarkerState& s) { return s.bending_stress; });
  const auto stretch = mean([](const MarkerState& s) { return s.stretch; });
  const auto curvature = mean([](const MarkerState& s) { return s.curvature; });
  const auto square = mean([](const MarkerState& s) { return std::pow(s.membrane_stress + s.bending_stress, 2); });
  std::vector<MarkerMeans> result;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const double stress = membrane[g] + bending[g];
    result.push_back({stress, membrane[g], bending[g], stretch[g], curvature[g],
                      std::sqrt(std::max(0.0, square[g] - stress * stress))});
  }
  return result;
}

template <int Dim>
void ClothMeasures<Dim>::observe(double dt) {
  if (groups_.empty()) return;
  const std::vector<MarkerState> states = system_.cloths.marker_states(system_.positions);
  averaged_time_ += dt;
  const double time = averaged_time_ > 0 ? averaged_time_ : 1;
  std::vector<MarkerState> averages;
  for (std::size_t m = 0; m < states.size(); ++m) {
    double* sums = &time_integrals_[marker_sums * m];
    sums[0] += dt * states[m].membrane_stress;
    sums[1] += dt * states[m].bending_stress;
    sums[2] += dt * states[m].stretch;
    sums[3] += dt * states[m].curvature;
    averages.push_back({sums[0] / time, sums[1] / time, sums[2] / time, sums[3] / time});
  }
  const auto now = means_of(states), means = means_of(averages);
  const std::vector<double> energies = system_.cloths.elastic_energies(system_.positions);
  const std::vector<double> stretches = system_.cloths.largest_stretches(system_.positions);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].now = now[g];
    groups_[g].mean = means[g];
    groups_[g].elastic_energy = energies[g];
    groups_[g].max_stretch = std::max(groups_[g].max_stretch, stretches[g]);
  }
  measure_places();
}

template <int Dim>
void ClothMeasures<Dim>::measure_places() {
  const std::vector<Piece>& pieces = system_.cloths.pieces();
  for (int d = 0; d < Dim; ++d) {
    std::vector<double> coordinate;
    for (const auto& position : system_.positions) coordinate.push_back(position[d]);
    const std::vector<double> sums = sums_by(system_.cloths.piece_of_marker(), pieces.size(), coordinate);
    for (std::size_t p = 0; p < pieces.size(); ++p) centers_[p][d] = sums[p] / static_cast<double>(pieces[p].count);
  }
  std::vector<double> depths(groups_.size(), 0.0);
  for (std::size_t m = 0; m < system_.positions.size(); ++m) {
    const double distance = nearest_distance<Dim>(system_.bodies, system_.positions[m], system_.fluid.time());
    depths[group_of_[m]] = std::max(depths[group_of_[m]], -distance);
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].depth = largest(system_.grid.comm(), depths[g]);
    groups_[g].max_depth = std::max(groups_[g].max_depth, groups_[g].depth);
  }
}

template <int Dim>
std::vector<Column> ClothMeasures<Dim>::columns() const {
  std::vector<Column> columns;
  if (groups_.empty()) return columns;
  columns.push_back({"cloth_slip", "-"});
  for (const auto& group : system_.cloths.groups()) {
    columns.push_back({group.name + "_elastic_energy", Dim == 2 ? "J/m" : "J"});
    columns.push_back({group.name + "_stress_mean", "Pa"});
    columns.push_back({group.name + "_membrane_stress_mean", "Pa"});
    columns.push_back({group.name + "_bending_stress_mean", "Pa"});
    columns.push_back({group.name + "_stretch_mean", "-"});
    columns.push_back({group.name + "_curvature_mean", "1/m"});
    columns.push_back({group.name + "_max_stretch", "-"});
    columns.push_back({group.name + "_depth", "m"});
    for (int d = 0; d < Dim; ++d) columns.push_back({group.name + "_center_" + "xyz"[d], "m"});
  }
  return columns;
}

template <int Dim>
std::vector<double> ClothMeasures<Dim>::row() const {
  std::vector<double> row;
  if (groups_.empty()) return row;
  row.push_back(system_.cloth_slip);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const GroupMeasures& group = groups_[g];
    row.insert(row.end(), {group.elastic_energy, group.now.stress, group.now.membrane, group.now.bending,
                           group.now.stretch, group.now.curvature, group.max_stretch, group.depth});
    Point<Dim> center = Point<Dim>::Zero();  // all cloths of a group are equal
    for (std::size_t p = 0; p < centers_.size(); ++p)
      if (system_.cloths.pieces()[p].group == g)
        center += centers_[p] / static_cast<double>(system_.cloths.groups()[g].count);
    row.insert(row.end(), center.data(), center.data() + Dim);
  }
  return row;
}

template <int Dim>
std::vector<Column> ClothMeasures<Dim>::track_columns() const {
  std::vector<Column> columns{{"step", "-"}, {"time", "s"}};
  for (const auto& group : system_.cloths.groups())
    for (PetscInt cloth = 0; cloth < group.count; ++cloth)
      for (int d = 0; d < Dim; ++d) columns.push_back({group.name + "_" + std::to_string(cloth) + "_" + "xyz"[d], "m"});
  return columns;
}

template <int Dim>
std::vector<double> ClothMeasures<Dim>::track_row() const {
  std::vector<double> row{system_.fluid.time()};
  for (const auto& center : centers_) row.insert(row.end(), center.data(), center.data() + Dim);
  return row;
}

template <int Dim>
std::vector<double> ClothMeasures<Dim>::totals() const {
  std::vector<double> totals{averaged_time_};
  for (const GroupMeasures& group : groups_) totals.insert(totals.end(), {group.max_stretch, group.max_depth});
  return totals;
}

template <int Dim>
void ClothMeasures<Dim>::set_totals(std::span<const double> totals) {
  averaged_time_ = totals[0];
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].max_stretch = totals[1 + 2 * g];
    groups_[g].max_depth = totals[2 + 2 * g];
  }
}

template class ClothMeasures<2>;
template class ClothMeasures<3>;

}  // namespace washfsi
