// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/contact_measure.hpp"

#include <numeric>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
ContactMeasure<Dim>::ContactMeasure(const System<Dim>& system)
    : system_(system), groups_(system.model.cloths.groups().size()) {
  for (const auto& force : system.model.forces.list())
    if (const auto* barrier = dynamic_cast<const Barrier<Dim>*>(force.get())) barrier_ = barrier;
}

template <int Dim>
void ContactMeasure<Dim>::declare(QuantityList& quantities) {
  if (!barrier_) return;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const std::string& name = system_.model.cloths.groups()[g].name;
    const Group& group = groups_[g];
    quantities.add(
        {name + "_contact_force", Units<Dim>::force, "sum over the group's markers of what presses them to cloths",
         [&group] { return group.normal_force; }},
        {{name + "_contact_force", Units<Dim>::force, OverCycle::mean, "that presses cloths to cloths"}});
    quantities.add({name + "_friction_power", Units<Dim>::power,
                    "that the group loses to friction between cloths, half of each pair's: its wear",
                    [&group] { return group.friction_power; }},
                   {{name + "_friction_work", Units<Dim>::energy, OverCycle::integral,
                     "of friction between cloths on the group: its wear"}});
  }
  quantities.add({"friction_power", Units<Dim>::power, "that all cloths lose to friction between them", [this] {
                    return std::accumulate(groups_.begin(), groups_.end(), 0.0,
                                           [](double sum, const Group& group) { return sum + group.friction_power; });
                  }});
}

template <int Dim>
void ContactMeasure<Dim>::observe(const Observation<Dim>&) {
  if (!barrier_) return;
  const Cloths<Dim>& cloths = system_.model.cloths;
  const auto contact = barrier_->marker_contact(system_.step.pushed_at);
  std::vector<double> sums(2 * groups_.size(), 0.0);
  for (std::size_t m = 0; m < cloths.owned(); ++m) {
    sums[2 * cloths.group_number(m)] += contact.normal_force[m];
    sums[2 * cloths.group_number(m) + 1] += contact.friction_power[m];
  }
  sums = ordered_sum(cloths.comm(), sums);
  for (std::size_t g = 0; g < groups_.size(); ++g) groups_[g] = {sums[2 * g], sums[2 * g + 1]};
}

template class ContactMeasure<2>;
template class ContactMeasure<3>;

}  // namespace washfsi
