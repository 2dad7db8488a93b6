// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/measures.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

namespace {

/// What moving a body against its load costs [W; W/m in the plane]: positive if the body drives the water.
template <int Dim>
double power(const RigidMotion<Dim>& motion, const Load<Dim>& load, double time) {
  return -load.torque[rotation_components<Dim> - 1] * motion.angular_velocity(time) -
         load.force.dot(motion.velocity(motion.center_at(time), time));
}

}  // namespace

template <int Dim>
Measures<Dim>::Measures(const System<Dim>& system)
    : system_(system),
      walls_(exposed_walls<Dim>(system.grid, system.boundary, system.bodies)),
      loads_(system.bodies.size()),
      balance_loads_(system.bodies.size()),
      wall_loads_(walls_.size()),
      powers_(system.bodies.size(), 0.0),
      groups_(system.cloths.groups().size()),
      centers_(groups_.size(), Point<Dim>::Zero()),
      stress_time_(system.cloths.owned(), 0.0) {
  for (const std::size_t piece : system.cloths.piece_of_marker())
    group_of_.push_back(system.cloths.pieces()[piece].group);
  counts_ = group_sums(std::vector<double>(group_of_.size(), 1.0));
  if (system.balance_loads && !loads_.empty()) control_volumes_.emplace(system.grid, system.boundary, system.bodies);
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
  measure_loads(dt);
  measure_cloth(dt, true);
}

template <int Dim>
void Measures<Dim>::measure_loads(double dt) {
  const FractionalStep<Dim>& fluid = system_.fluid;
  const double middle = fluid.time() - 0.5 * dt;
  wall_loads_ = wall_loads<Dim>(system_.grid, system_.boundary, system_.bodies, walls_, fluid.velocity(),
                                fluid.pressure(), fluid.viscosity(), fluid.time());
  if (loads_.empty()) return;
  loads_ = system_.mask.loads(fluid.constraint_force(), system_.density, fluid.pressure(), middle);
  if (control_volumes_)
    balance_loads_ =
        control_volumes_->loads({fluid.velocity_before(), fluid.velocity(), fluid.pressure(), system_.density,
                                 system_.force, system_.mask.fluid_fraction(), fluid.viscosity(), fluid.time(), dt});
  const Loads<Dim> contact = ordered_sum<Dim>(system_.grid.comm(), system_.contact_loads);
  for (std::size_t b = 0; b < loads_.size(); ++b)
    for (Load<Dim>* load : {&loads_[b], &balance_loads_[b]}) {
      load->force += contact[b].force;
      load->torque += contact[b].torque;
    }
  for (std::size_t b = 0; b < loads_.size(); ++b) powers_[b] = power(system_.bodies[b].motion, loads_[b], middle);
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

namespace {

std::string name_of(SideName side) {
  return std::string("wall_") + "xyz"[side.axis] + (side.end == End::lower ? "_lower" : "_upper");
}

/// Columns of a load, with a prefix.
template <int Dim>
void add_columns(std::vector<Column>& columns, const std::string& prefix) {
  const char* force = Dim == 2 ? "N/m" : "N";
  const char* torque = Dim == 2 ? "N m/m" : "N m";
  for (int d = 0; d < Dim; ++d) columns.push_back({prefix + "force_" + "xyz"[d], force});
  if (Dim == 2) columns.push_back({prefix + "torque", torque});
  for (int d = 0; d < Dim && Dim == 3; ++d) columns.push_back({prefix + "torque_" + "xyz"[d], torque});
}

template <int Dim>
void add_values(std::vector<double>& row, const Load<Dim>& load) {
  row.insert(row.end(), load.force.data(), load.force.data() + Dim);
  row.insert(row.end(), load.torque.data(), load.torque.data() + rotation_components<Dim>);
}

}  // namespace

template <int Dim>
std::vector<Column> Measures<Dim>::columns() const {
  const bool plane = Dim == 2;
  const char* energy = plane ? "J/m" : "J";
  const char* power = plane ? "W/m" : "W";
  std::vector<Column> columns{
      {"step", "-"}, {"time", "s"}, {"dt", "s"}, {"cfl", "-"}, {"kinetic_energy", energy}, {"max_divergence", "1/s"}};
  if (system_.fluid.upwind()) columns.push_back({"numerical_dissipation", power});
  for (const auto& body : system_.bodies) {
    add_columns<Dim>(columns, body.name + "_");
    columns.push_back({body.name + "_power", power});
    if (control_volumes_) add_columns<Dim>(columns, body.name + "_balance_");
  }
  for (const SideName side : walls_) add_columns<Dim>(columns, name_of(side) + "_");
  if (!groups_.empty()) columns.push_back({"cloth_slip", "-"});
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
std::vector<std::string> Measures<Dim>::wall_names() const {
  std::vector<std::string> names;
  for (const SideName side : walls_) names.push_back(name_of(side));
  return names;
}

template <int Dim>
std::vector<double> Measures<Dim>::row(double dt) const {
  std::vector<double> row{system_.fluid.time(), dt, flow_.courant.value, flow_.kinetic_energy, flow_.max_divergence};
  if (system_.fluid.upwind()) row.push_back(system_.fluid.numerical_dissipation());
  for (std::size_t b = 0; b < loads_.size(); ++b) {
    add_values(row, loads_[b]);
    row.push_back(powers_[b]);
    if (control_volumes_) add_values(row, balance_loads_[b]);
  }
  for (const Load<Dim>& load : wall_loads_) add_values(row, load);
  if (!groups_.empty()) row.push_back(system_.cloth_slip);
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
