// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/measures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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
  const FractionalStep<Dim>& fluid = system_.fluid;
  measure_flow(GhostedVelocity<Dim>(system_.boundary, system_.grid.face_dm(), fluid.velocity(), fluid.time()), dt);
  cloth_.observe(0);
  elastic_energy_ = elastic_energy();
}

template <int Dim>
void Measures<Dim>::prepare() {
  if (unmeasured_time_ == 0) return;
  const std::vector<double> energies = system_.cloths.elastic_energies(system_.positions);
  elastic_energy_ = std::accumulate(energies.begin(), energies.end(), 0.0);
}

template <int Dim>
void Measures<Dim>::observe(double dt, bool all) {
  const petsc::LogPart part("measures");
  const FractionalStep<Dim>& fluid = system_.fluid;
  const GhostedVelocity<Dim> velocity(system_.boundary, system_.grid.face_dm(), fluid.velocity(), fluid.time());
  measure_flow(velocity, dt);
  largest_divergence_ = std::max(largest_divergence_, flow_.max_divergence);
  unmeasured_time_ += dt;
  if (!all) return;
  const Loads<Dim> contact = ordered_sum<Dim>(system_.grid.comm(), system_.contact_loads.bodies);
  measure_loads(velocity, dt, contact);
  cloth_.observe(std::exchange(unmeasured_time_, 0.0));
  if (couples()) measure_cloth_dissipation(dt, contact);
}

template <int Dim>
double Measures<Dim>::elastic_energy() const {
  double energy = 0;
  for (const GroupMeasures& group : cloth_.groups()) energy += group.elastic_energy;
  return energy;
}

// What the cloths got (from bodies that push them, weight, loads, and out of their elastic energy) and did not give to
// the water: their damping, and that of the coupling.
template <int Dim>
void Measures<Dim>::measure_cloth_dissipation(double dt, const Loads<Dim>& contact) {
  const FractionalStep<Dim>& fluid = system_.fluid;
  double before = 0, after = 0;
  WASH_PETSC(VecDot(system_.force, fluid.velocity_before(), &before));
  WASH_PETSC(VecDot(system_.force, fluid.velocity(), &after));
  const double given = 0.5 * (before + after) * system_.grid.cell_volume();
  double got = 0;
  for (std::size_t m = 0; m < system_.velocities.size(); ++m)
    got +=
        system_.velocities[m].dot(system_.cloths.marker_masses()[m] * system_.gravity + system_.cloths.dead_loads()[m]);
  got = ordered_sum(system_.grid.comm(), got);
  for (std::size_t b = 0; b < contact.size(); ++b)
    got += power(system_.bodies[b].motion, contact[b], fluid.time() - 0.5 * dt);
  const double energy = elastic_energy();
  cloth_dissipation_ = got - given - (energy - elastic_energy_) / dt;
  elastic_energy_ = energy;
}

template <int Dim>
void Measures<Dim>::measure_flow(Vec local_velocity, double dt) {
  const Vec share = system_.mask.empty() ? nullptr : system_.mask.fluid_fraction();
  flow_ =
      FlowDiagnostics<Dim>::of(system_.grid, {local_velocity, system_.density, share, system_.fluid.viscosity()}, dt);
}

template <int Dim>
void Measures<Dim>::measure_loads(Vec local_velocity, double dt, const Loads<Dim>& contact) {
  const FractionalStep<Dim>& fluid = system_.fluid;
  const double middle = fluid.time() - 0.5 * dt;
  wall_loads_ = wall_loads<Dim>(system_.grid, system_.boundary, system_.bodies, walls_, local_velocity,
                                fluid.pressure(), fluid.viscosity(), fluid.time());
  Loads<Dim> of_contact;
  for (const SideName side : walls_)
    of_contact.push_back(
        system_.contact_loads.sides[static_cast<std::size_t>(side.axis)][side.end == End::upper ? 1 : 0]);
  of_contact = ordered_sum<Dim>(system_.grid.comm(), of_contact);
  for (std::size_t s = 0; s < walls_.size(); ++s) wall_loads_[s] += of_contact[s];
  if (loads_.empty()) return;
  loads_ = system_.mask.loads(fluid.constraint_force(), system_.density, fluid.pressure(), middle);
  const Loads<Dim> beneath =
      system_.mask.hidden_wall_shear(system_.boundary, local_velocity, fluid.viscosity(), fluid.time());
  for (std::size_t b = 0; b < loads_.size(); ++b) loads_[b] += beneath[b];
  if (control_volumes_)
    balance_loads_ =
        control_volumes_->loads({fluid.velocity_before(), fluid.velocity(), fluid.pressure(), system_.density,
                                 system_.force, system_.mask.fluid_fraction(), fluid.viscosity(), fluid.time(), dt});
  for (std::size_t b = 0; b < loads_.size(); ++b)
    for (Load<Dim>* load : {&loads_[b], &balance_loads_[b]}) *load += contact[b];
  mask_dissipation_ = system_.mask.dissipation(fluid.velocity_before(), system_.density, dt);
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
  std::vector<Column> columns{{"step", "-"},
                              {"time", "s"},
                              {"dt", "s"},
                              {"cfl", "-"},
                              {"kinetic_energy", energy},
                              {"max_divergence", "1/s"},
                              {"angular_momentum", plane ? "J s/m" : "J s"},
                              {"dissipation", power}};
  if (system_.fluid.departs_from_central()) columns.push_back({"numerical_dissipation", power});
  if (!system_.mask.empty()) columns.push_back({"mask_dissipation", power});
  for (const auto& body : system_.bodies) {
    add_columns<Dim>(columns, body.name + "_");
    columns.push_back({body.name + "_power", power});
    if (control_volumes_) add_columns<Dim>(columns, body.name + "_balance_");
  }
  for (const SideName side : walls_) add_columns<Dim>(columns, name_of(side) + "_");
  if (couples()) columns.push_back({"cloth_dissipation", power});
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
  std::vector<double> row{
      system_.fluid.time(), dt, flow_.courant.value, flow_.kinetic_energy, flow_.max_divergence, flow_.angular_momentum,
      flow_.dissipation};
  if (system_.fluid.departs_from_central()) row.push_back(system_.fluid.numerical_dissipation());
  if (!system_.mask.empty()) row.push_back(mask_dissipation_);
  for (std::size_t b = 0; b < loads_.size(); ++b) {
    add_values(row, loads_[b]);
    row.push_back(powers_[b]);
    if (control_volumes_) add_values(row, balance_loads_[b]);
  }
  for (const Load<Dim>& load : wall_loads_) add_values(row, load);
  if (couples()) row.push_back(cloth_dissipation_);
  const std::vector<double> of_cloth = cloth_.row();
  row.insert(row.end(), of_cloth.begin(), of_cloth.end());
  return row;
}

template <int Dim>
std::vector<double> Measures<Dim>::totals() const {
  std::vector<double> totals = cloth_.totals();
  totals.insert(totals.end(), {largest_divergence_, unmeasured_time_});
  return totals;
}

template <int Dim>
void Measures<Dim>::set_totals(const std::vector<double>& totals) {
  cloth_.set_totals(totals);
  largest_divergence_ = totals[totals.size() - 2];
  unmeasured_time_ = totals.back();
}

template class Measures<2>;
template class Measures<3>;

}  // namespace washfsi
