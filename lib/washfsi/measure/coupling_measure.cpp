// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/coupling_measure.hpp"

#include <algorithm>
#include <numeric>

#include "washfsi/measure/body_measure.hpp"
#include "washfsi/measure/carried_mass.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
CouplingMeasure<Dim>::CouplingMeasure(const System<Dim>& system, const ClothMeasure<Dim>& cloth)
    : system_(system), cloth_(cloth) {
  const Points<Dim> constant = system.model.forces.constant();
  const bool is_loaded = std::ranges::any_of(constant, [](const Point<Dim>& load) { return !load.isZero(0); });
  is_loaded_ = couples() && any_rank(system.model.grid.comm(), is_loaded);
}

template <int Dim>
void CouplingMeasure<Dim>::declare(QuantityList& quantities) {
  if (couples())
    quantities.add({"cloth_dissipation", Units<Dim>::power, "energy that the cloth's damping and the coupling take out",
                    [this] { return dissipation_; }},
                   {{"cloth_dissipated", Units<Dim>::energy, OverCycle::integral,
                     "energy lost to the cloth's damping and the coupling", -1}});
  if (is_loaded_)
    quantities.add(
        {"load_power", Units<Dim>::power, "that weight and loads put into the cloth", [this] { return load_power_; }},
        {{"load_work", Units<Dim>::energy, OverCycle::integral, "that weight and loads put into the cloth", 1}});
}

template <int Dim>
void CouplingMeasure<Dim>::prepare() {
  const std::vector<double> energies = system_.model.forces.elastic_energies(system_.state.positions);
  energy_ = std::accumulate(energies.begin(), energies.end(), CarriedMass::of(system_).kinetic_energy);
}

template <int Dim>
void CouplingMeasure<Dim>::observe_start(const Observation<Dim>&) {
  energy_ = cloth_.elastic_energy() + CarriedMass::of(system_).kinetic_energy;
}

template <int Dim>
void CouplingMeasure<Dim>::observe(const Observation<Dim>& seen) {
  if (!couples()) return;
  const Model<Dim>& model = system_.model;
  double before = 0, after = 0;
  WASH_PETSC(VecDot(system_.step.force, model.fluid.velocity_before(), &before));
  WASH_PETSC(VecDot(system_.step.force, model.fluid.velocity(), &after));
  const double given = 0.5 * (before + after) * model.grid.cell_volume();
  load_power_ = 0;
  const Points<Dim> constant = model.forces.constant();
  for (std::size_t m = 0; m < constant.size(); ++m) load_power_ += system_.state.mean_velocities[m].dot(constant[m]);
  load_power_ = ordered_sum(model.grid.comm(), load_power_);
  double got = load_power_;
  const double middle = system_.state.clock.time - 0.5 * seen.dt;
  for (std::size_t b = 0; b < model.body_list.size(); ++b)
    got += power(model.body_list[b].motion, seen.contact.bodies[b], middle);
  const double energy = cloth_.elastic_energy() + CarriedMass::of(system_).kinetic_energy;
  dissipation_ = got - given - (energy - energy_) / seen.dt;
  energy_ = energy;
}

template class CouplingMeasure<2>;
template class CouplingMeasure<3>;

}  // namespace washfsi
