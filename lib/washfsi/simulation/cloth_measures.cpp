// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/cloth_measures.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
const std::vector<Column>& marker_quantities() {
  static const std::vector<Column> in_plane{{"stress", "Pa"},     {"membrane_stress", "Pa"}, {"bending_stress", "Pa"},
                                            {"stretch", "-"},     {"curvature", "1/m"},      {"relative_speed", "m/s"},
                                            {"water_shear", "Pa"}};
  static const std::vector<Column> in_space{{"stress", "Pa"},
                                            {"stress_ss", "Pa"},
                                            {"stress_rr", "Pa"},
                                            {"stress_sr", "Pa"},
                                            {"membrane_stress_ss", "Pa"},
                                            {"membrane_stress_rr", "Pa"},
                                            {"membrane_stress_sr", "Pa"},
                                            {"bending_stress_ss", "Pa"},
                                            {"bending_stress_rr", "Pa"},
                                            {"bending_stress_sr", "Pa"},
                                            {"stretch", "-"},
                                            {"curvature", "1/m"},
                                            {"shear_angle", "rad"},
                                            {"relative_speed", "m/s"},
                                            {"water_shear", "Pa"}};
  return Dim == 2 ? in_plane : in_space;
}

template <int Dim>
std::vector<double> quantities_of(const MarkerState& state, const WashingAction& action) {
  const auto &membrane = state.membrane_stress, &bending = state.bending_stress;
  const auto surface = [&](StressComponent component) { return membrane[component] + bending[component]; };
  if constexpr (Dim == 2)
    return {surface(ss),     membrane[ss],          bending[ss], state.stretch,
            state.curvature, action.relative_speed, action.shear};
  return {0.5 * (surface(ss) + surface(rr)),
          surface(ss),
          surface(rr),
          surface(sr),
          membrane[ss],
          membrane[rr],
          membrane[sr],
          bending[ss],
          bending[rr],
          bending[sr],
          state.stretch,
          state.curvature,
          state.shear_angle,
          action.relative_speed,
          action.shear};
}

template <int Dim>
ClothMeasures<Dim>::ClothMeasures(const System<Dim>& system)
    : system_(system),
      groups_(system.cloths.groups().size()),
      centers_(system.cloths.pieces().size(), Point<Dim>::Zero()),
      time_integrals_(marker_quantities<Dim>().size() * system.cloths.owned(), 0.0) {
  for (const std::size_t piece : system.cloths.piece_of_marker())
    group_of_.push_back(system.cloths.pieces()[piece].group);
  counts_ = sums_by(group_of_, groups_.size(), std::vector<double>(group_of_.size(), 1.0));
  if constexpr (Dim == 3) {
    if (groups_.empty()) return;
    tumbles_.emplace(system.machine.axis, system.machine.orbit_center, centers_.size());
    crossings_.emplace(system.cloths);
  }
}

// Sums over the markers of each part, groups or cloths.
template <int Dim>
std::vector<double> ClothMeasures<Dim>::sums_by(const std::vector<std::size_t>& part_of, std::size_t parts,
                                                const std::vector<double>& marker_values) const {
  std::vector<double> sums(parts, 0.0);
  for (std::size_t m = 0; m < marker_values.size(); ++m) sums[part_of[m]] += marker_values[m];
  return ordered_sum(system_.grid.comm(), sums);
}

// Means over the markers of each group of each of the values that every marker has.
template <int Dim>
std::vector<std::vector<double>> ClothMeasures<Dim>::means_of(const std::vector<double>& values) const {
  const std::size_t each = marker_quantities<Dim>().size();
  std::vector<double> sums(groups_.size() * each, 0.0);
  for (std::size_t n = 0; n < values.size(); ++n) sums[group_of_[n / each] * each + n % each] += values[n];
  sums = ordered_sum(system_.grid.comm(), sums);
  std::vector<std::vector<double>> means;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    means.emplace_back(sums.begin() + static_cast<long>(g * each), sums.begin() + static_cast<long>((g + 1) * each));
    for (double& mean : means.back()) mean /= counts_[g];
  }
  return means;
}

template <int Dim>
void ClothMeasures<Dim>::observe(double dt) {
  if (groups_.empty()) return;
  averaged_time_ += dt;
  const double time = averaged_time_ > 0 ? averaged_time_ : 1;
  std::vector<double> values;
  const std::vector<MarkerState> states = system_.cloths.marker_states(system_.positions);
  const std::vector<WashingAction> actions = washing_action();
  for (std::size_t m = 0; m < states.size(); ++m)
    for (const double value : quantities_of<Dim>(states[m], actions[m])) values.push_back(value);
  std::vector<double> averages, squares;
  for (std::size_t n = 0; n < values.size(); ++n) {
    time_integrals_[n] += dt * values[n];
    averages.push_back(time_integrals_[n] / time);
    squares.push_back(averages[n] * averages[n]);
  }
  const auto now = means_of(values), means = means_of(averages), mean_squares = means_of(squares);
  const std::vector<double> energies = system_.cloths.elastic_energies(system_.positions);
  const std::vector<double> stretches = system_.cloths.largest_stretches(system_.positions);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].now = now[g];
    groups_[g].mean = means[g];
    groups_[g].deviation.clear();
    for (std::size_t n = 0; n < means[g].size(); ++n)
      groups_[g].deviation.push_back(std::sqrt(std::max(0.0, mean_squares[g][n] - means[g][n] * means[g][n])));
    groups_[g].elastic_energy = energies[g];
    groups_[g].max_stretch = std::max(groups_[g].max_stretch, stretches[g]);
  }
  measure_places();
  if constexpr (Dim == 3) measure_laundry();
}

template <int Dim>
std::vector<WashingAction> ClothMeasures<Dim>::washing_action() const {
  std::vector<WashingAction> actions(system_.positions.size());
  if (!system_.has_fluid) return actions;
  const Points<Dim> normals = system_.cloths.normals(system_.positions);
  const GhostedVelocity<Dim> local(system_.boundary, system_.grid.wide_face_dm(), system_.fluid.velocity(),
                                   system_.fluid.time());
  // within `sample_reach` along each axis, cells being flat or not; 0 where there is no normal
  const auto distance = [&](const Point<Dim>& normal) {
    const double cells = normal.cwiseQuotient(system_.grid.spacing()).norm();
    return cells > 0 ? Transfer<Dim>::sample_reach / cells : 0.0;
  };
  for (const double side : {-1.0, 1.0}) {
    Points<Dim> offsets;
    for (const auto& normal : normals) offsets.push_back(side * distance(normal) * normal);
    const Points<Dim> water = system_.transfer.sample(local, offsets);
    for (std::size_t m = 0; m < normals.size(); ++m) {
      const Point<Dim> relative = water[m] - system_.velocities[m];
      actions[m].relative_speed += 0.5 * (relative - relative.dot(normals[m]) * normals[m]).norm();
    }
  }
  for (std::size_t m = 0; m < normals.size(); ++m)
    if (distance(normals[m]) > 0)
      actions[m].shear = system_.fluid.viscosity() * actions[m].relative_speed / distance(normals[m]);
  return actions;
}

template <int Dim>
void ClothMeasures<Dim>::measure_laundry() {
  if constexpr (Dim == 3) {
    tumbles_->observe(centers_);
    const std::vector<double> turns = tumbles_->turns();
    for (std::size_t g = 0; g < groups_.size(); ++g) groups_[g].tumbles = mean_over_cloths(g, turns, 0.0);
    crossings_->observe(system_.positions);
  }
}

// All cloths of a group are equal. `sum` is the zero to begin with.
template <int Dim>
template <class Value>
Value ClothMeasures<Dim>::mean_over_cloths(std::size_t group, const std::vector<Value>& values, Value sum) const {
  for (std::size_t p = 0; p < values.size(); ++p)
    if (system_.cloths.pieces()[p].group == group) sum += values[p];
  return sum / static_cast<double>(system_.cloths.groups()[group].count);
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
    const Point<Dim> place = system_.grid.folded(system_.positions[m]);
    const double distance = nearest_distance<Dim>(system_.bodies, place, system_.fluid.time());
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
  if (crossings_) {
    columns.push_back({"cloth_distance", "m"});
    columns.push_back({"cloth_crossings", "-"});
  }
  for (const auto& group : system_.cloths.groups()) {
    columns.push_back({group.name + "_elastic_energy", Dim == 2 ? "J/m" : "J"});
    for (const Column& quantity : marker_quantities<Dim>())
      columns.push_back({group.name + "_" + quantity.name + "_mean", quantity.unit});
    columns.push_back({group.name + "_max_stretch", "-"});
    columns.push_back({group.name + "_depth", "m"});
    if (tumbles_) columns.push_back({group.name + "_tumbles", "-"});
    for (int d = 0; d < Dim; ++d) columns.push_back({group.name + "_center_" + "xyz"[d], "m"});
  }
  return columns;
}

template <int Dim>
std::vector<double> ClothMeasures<Dim>::row() const {
  std::vector<double> row;
  if (groups_.empty()) return row;
  row.push_back(system_.cloth_slip);
  if (crossings_) row.insert(row.end(), {crossings_->least_distance(), crossings_->crossings()});
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const GroupMeasures& group = groups_[g];
    row.push_back(group.elastic_energy);
    row.insert(row.end(), group.now.begin(), group.now.end());
    row.insert(row.end(), {group.max_stretch, group.depth});
    if (tumbles_) row.push_back(group.tumbles);
    const Point<Dim> center = mean_over_cloths<Point<Dim>>(g, centers_, Point<Dim>::Zero());
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
  if (crossings_) totals.push_back(crossings_->crossings());
  if (tumbles_)
    for (const double number : tumbles_->state()) totals.push_back(number);
  return totals;
}

template <int Dim>
void ClothMeasures<Dim>::set_totals(std::span<const double> totals) {
  averaged_time_ = totals[0];
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].max_stretch = totals[1 + 2 * g];
    groups_[g].max_depth = totals[2 + 2 * g];
  }
  const std::size_t next = 1 + 2 * groups_.size();
  if (crossings_) crossings_->set_crossings(totals[next]);
  if (tumbles_) tumbles_->set_state(totals.subspan(next + 1, tumbles_->state_count()));
}

template const std::vector<Column>& marker_quantities<2>();
template const std::vector<Column>& marker_quantities<3>();
template std::vector<double> quantities_of<2>(const MarkerState&, const WashingAction&);
template std::vector<double> quantities_of<3>(const MarkerState&, const WashingAction&);
template class ClothMeasures<2>;
template class ClothMeasures<3>;

}  // namespace washfsi
