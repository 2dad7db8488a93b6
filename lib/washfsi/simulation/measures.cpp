// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/measures.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

template <int Dim>
Measures<Dim>::Measures(const System<Dim>& system)
    : system_(system),
      loads_(system.bodies.size()),
      groups_(system.cloths.groups().size()),
      centers_(groups_.size(), Point<Dim>::Zero()),
      stress_time_(system.cloths.owned(), 0.0) {
  for (const std::size_t piece : system.cloths.piece_of_marker())
    group_of_.push_back(system.cloths.pieces()[piece].group);
  counts_ = group_sums(std::vector<double>(group_of_.size(), 1.0));
}

template <int Dim>
std::vector<double> Measures<Dim>::group_sums(const std::vector<double>& marker_values) const {
  std::vector<double> sums(groups_.size(), 0.0);
  for (std::size_t m = 0; m < marker_values.size(); ++m) sums[group_of_[m]] += marker_values[m];
  return ordered_sum(system_.grid.comm(), sums);
}

template <int Dim>
void Measures<Dim>::observe_start(double dt) {
  flow_ = FlowDiagnostics<Dim>::of(system_.grid, system_.boundary, system_.fluid.velocity(), system_.density,
                                   system_.fluid.time(), dt);
  measure_cloth(dt, false);
}

template <int Dim>
void Measures<Dim>::observe(double dt) {
  const petsc::LogPart part("measures");
  flow_ = FlowDiagnostics<Dim>::of(system_.grid, system_.boundary, system_.fluid.velocity(), system_.density,
                                   system_.fluid.time(), dt);
  largest_divergence_ = std::max(largest_divergence_, flow_.max_divergence);
  measure_loads();
  measure_cloth(dt, true);
}

template <int Dim>
void Measures<Dim>::measure_loads() {
  loads_ = system_.mask.loads(system_.fluid.constraint_force(), system_.density, system_.fluid.pressure(),
                              system_.fluid.time());
  std::vector<double> contact;
  for (const Load<Dim>& load : system_.contact_loads) {
    contact.insert(contact.end(), load.force.data(), load.force.data() + Dim);
    contact.insert(contact.end(), load.torque.data(), load.torque.data() + rotation_components<Dim>);
  }
  contact = ordered_sum(system_.grid.comm(), contact);
  for (std::size_t b = 0; b < loads_.size(); ++b) {
    const double* values = &contact[b * (Dim + rotation_components<Dim>)];
    loads_[b].force += Point<Dim>(values);
    loads_[b].torque += Eigen::Map<const Rotation<Dim>>(values + Dim);
  }
}

template <int Dim>
void Measures<Dim>::measure_cloth(double dt, bool accumulate) {
  if (groups_.empty()) return;
  measure_stress(dt, accumulate);
  measure_places();
  const std::vector<double> energies = system_.cloths.elastic_energies(system_.positions);
  const std::vector<double> stretches = system_.cloths.largest_stretches(system_.positions);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].elastic_energy = energies[g];
    groups_[g].max_stretch = std::max(groups_[g].max_stretch, stretches[g]);
  }
}

template <int Dim>
void Measures<Dim>::measure_stress(double dt, bool accumulate) {
  const std::vector<double> stress = system_.cloths.stresses(system_.positions);
  if (accumulate) {
    averaged_time_ += dt;
    for (std::size_t m = 0; m < stress.size(); ++m) stress_time_[m] += dt * stress[m];
  }
  const double time = averaged_time_ > 0 ? averaged_time_ : 1;
  std::vector<double> mean(stress.size()), square(stress.size());
  for (std::size_t m = 0; m < stress.size(); ++m) {
    mean[m] = stress_time_[m] / time;
    square[m] = mean[m] * mean[m];
  }
  const std::vector<double> now = group_sums(stress), means = group_sums(mean), squares = group_sums(square);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    GroupMeasures& group = groups_[g];
    group.stress_now = now[g] / counts_[g];
    group.stress_mean = means[g] / counts_[g];
    group.stress_std = std::sqrt(std::max(0.0, squares[g] / counts_[g] - group.stress_mean * group.stress_mean));
  }
}

template <int Dim>
void Measures<Dim>::measure_places() {
  for (int d = 0; d < Dim; ++d) {
    std::vector<double> coordinate;
    for (const auto& position : system_.positions) coordinate.push_back(position[d]);
    const std::vector<double> sums = group_sums(coordinate);
    for (std::size_t g = 0; g < groups_.size(); ++g) centers_[g][d] = sums[g] / counts_[g];
  }
  std::vector<double> depths(groups_.size(), 0.0);
  for (std::size_t m = 0; m < system_.positions.size(); ++m) {
    const double distance = nearest_distance<Dim>(system_.bodies, system_.positions[m], system_.fluid.time());
    depths[group_of_[m]] = std::max(depths[group_of_[m]], -distance);
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) groups_[g].depth = largest(system_.grid.comm(), depths[g]);
}

template <int Dim>
std::vector<Column> Measures<Dim>::columns() const {
  const bool plane = Dim == 2;
  const char* force = plane ? "N/m" : "N";
  const char* torque = plane ? "N m/m" : "N m";
  const char* energy = plane ? "J/m" : "J";
  std::vector<Column> columns{
      {"step", "-"}, {"time", "s"}, {"dt", "s"}, {"cfl", "-"}, {"kinetic_energy", energy}, {"max_divergence", "1/s"}};
  if (system_.fluid.upwind()) columns.push_back({"numerical_dissipation", plane ? "W/m" : "W"});
  for (const auto& body : system_.bodies) {
    for (int d = 0; d < Dim; ++d) columns.push_back({body.name + "_force_" + "xyz"[d], force});
    if (plane) columns.push_back({body.name + "_torque", torque});
    for (int d = 0; d < Dim && !plane; ++d) columns.push_back({body.name + "_torque_" + "xyz"[d], torque});
  }
  for (const auto& group : system_.cloths.groups()) {
    columns.push_back({group.name + "_elastic_energy", energy});
    columns.push_back({group.name + "_stress_mean", "Pa"});
    columns.push_back({group.name + "_max_stretch", "-"});
    columns.push_back({group.name + "_depth", "m"});
    for (int d = 0; d < Dim; ++d) columns.push_back({group.name + "_center_" + "xyz"[d], "m"});
  }
  return columns;
}

template <int Dim>
std::vector<double> Measures<Dim>::row(double dt) const {
  std::vector<double> row{system_.fluid.time(), dt, flow_.courant.value, flow_.kinetic_energy, flow_.max_divergence};
  if (system_.fluid.upwind()) row.push_back(system_.fluid.numerical_dissipation());
  for (const Load<Dim>& load : loads_) {
    row.insert(row.end(), load.force.data(), load.force.data() + Dim);
    row.insert(row.end(), load.torque.data(), load.torque.data() + rotation_components<Dim>);
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    row.insert(row.end(), {groups_[g].elastic_energy, groups_[g].stress_now, groups_[g].max_stretch, groups_[g].depth});
    row.insert(row.end(), centers_[g].data(), centers_[g].data() + Dim);
  }
  return row;
}

template <int Dim>
std::vector<double> Measures<Dim>::totals() const {
  std::vector<double> totals{averaged_time_, largest_divergence_};
  for (const GroupMeasures& group : groups_) totals.push_back(group.max_stretch);
  return totals;
}

template <int Dim>
void Measures<Dim>::set_totals(const std::vector<double>& totals) {
  averaged_time_ = totals[0];
  largest_divergence_ = totals[1];
  for (std::size_t g = 0; g < groups_.size(); ++g) groups_[g].max_stretch = totals[2 + g];
}

template class Measures<2>;
template class Measures<3>;

}  // namespace washfsi
