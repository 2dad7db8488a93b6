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
      cloth_(system) {
  if (system.balance_loads && !loads_.empty()) control_volumes_.emplace(system.grid, system.boundary, system.bodies);
}

template <int Dim>
void Measures<Dim>::observe_start(double dt) {
  flow_ = FlowDiagnostics<Dim>::of(system_.grid, system_.boundary, system_.fluid.velocity(), system_.density,
                                   system_.fluid.time(), dt);
  cloth_.observe(0);
}

template <int Dim>
void Measures<Dim>::observe(double dt) {
  const petsc::LogPart part("measures");
  flow_ = FlowDiagnostics<Dim>::of(system_.grid, system_.boundary, system_.fluid.velocity(), system_.density,
                                   system_.fluid.time(), dt);
  largest_divergence_ = std::max(largest_divergence_, flow_.max_divergence);
  measure_loads(dt);
  cloth_.observe(dt);
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
  const std::vector<Column> of_cloth = cloth_.columns();
  columns.insert(columns.end(), of_cloth.begin(), of_cloth.end());
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
  const std::vector<double> of_cloth = cloth_.row();
  row.insert(row.end(), of_cloth.begin(), of_cloth.end());
  return row;
}

template <int Dim>
std::vector<double> Measures<Dim>::totals() const {
  std::vector<double> totals = cloth_.totals();
  totals.push_back(largest_divergence_);
  return totals;
}

template <int Dim>
void Measures<Dim>::set_totals(const std::vector<double>& totals) {
  cloth_.set_totals(totals);
  largest_divergence_ = totals.back();
}

template class Measures<2>;
template class Measures<3>;

}  // namespace washfsi
