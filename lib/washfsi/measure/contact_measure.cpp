// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/contact_measure.hpp"

#include <numeric>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
ContactMeasure<Dim>::ContactMeasure(const System<Dim>& system)
    : system_(system), groups_(system.model.cloths.groups().size()) {
  for (const auto& force : system.model.forces.list())
    if (const auto* contact = dynamic_cast<const ContactForce<Dim>*>(force.get()))
      forces_[contact->is_with_bodies()].push_back(contact);
}

template <int Dim>
void ContactMeasure<Dim>::declare(QuantityList& quantities) {
  if (!present(false) && !present(true)) return;
  for (std::size_t g = 0; g < groups_.size(); ++g) declare_group(quantities, g);
  quantities.add({"friction_power", Units<Dim>::power,
                  "that all cloths lose to friction and damping on cloths, bodies and walls", [this] {
                    return std::accumulate(groups_.begin(), groups_.end(), 0.0,
                                           [](double sum, const Group& group) { return sum + group.friction_power; });
                  }});
}

template <int Dim>
void ContactMeasure<Dim>::declare_group(QuantityList& quantities, std::size_t g) {
  const std::string& name = system_.model.cloths.groups()[g].name;
  const Group& group = groups_[g];
  if (present(false))
    quantities.add(
        {name + "_contact_force", Units<Dim>::force, "sum over the group's markers of what presses them to cloths",
         [&group] { return group.of_cloths; }},
        {{name + "_contact_force", Units<Dim>::force, OverCycle::mean, "that presses cloths to cloths"}});
  if (present(true))
    quantities.add(
        {name + "_body_contact_force", Units<Dim>::force,
         "sum over the group's markers of what presses them to bodies and walls", [&group] { return group.of_bodies; }},
        {{name + "_body_contact_force", Units<Dim>::force, OverCycle::mean,
          "that presses cloths to bodies and walls"}});
  quantities.add(
      {name + "_friction_power", Units<Dim>::power,
       "that the group loses to friction, between cloths half of each pair's: its wear",
       [&group] { return group.friction_power; }},
      {{name + "_friction_work", Units<Dim>::energy, OverCycle::integral, "of friction on the group: its wear"}});
}

template <int Dim>
MarkerContact ContactMeasure<Dim>::contact(bool with_bodies) const {
  MarkerContact contact(system_.model.cloths.owned());
  for (const auto* force : forces_[with_bodies]) force->add_marker_contact(system_.step.evaluated_at, contact);
  return contact;
}

template <int Dim>
void ContactMeasure<Dim>::observe(const Observation<Dim>&) {
  if (!present(false) && !present(true)) return;
  const Cloths<Dim>& cloths = system_.model.cloths;
  const MarkerContact of_cloths = contact(false), of_bodies = contact(true);
  std::vector<double> sums(3 * groups_.size(), 0.0);
  for (std::size_t m = 0; m < cloths.owned(); ++m) {
    const std::size_t first = 3 * cloths.group_number(m);
    sums[first] += of_cloths.normal_force[m];
    sums[first + 1] += of_bodies.normal_force[m];
    sums[first + 2] += of_cloths.friction_power[m] + of_bodies.friction_power[m];
  }
  sums = ordered_sum(cloths.comm(), sums);
  for (std::size_t g = 0; g < groups_.size(); ++g) groups_[g] = {sums[3 * g], sums[3 * g + 1], sums[3 * g + 2]};
}

template <int Dim>
std::vector<MarkerField> ContactMeasure<Dim>::marker_fields() const {
  std::vector<MarkerField> fields;
  for (const bool with_bodies : {false, true}) {
    if (!present(with_bodies)) continue;
    MarkerContact now = contact(with_bodies);
    const std::string start = with_bodies ? "body_contact_" : "contact_";
    fields.push_back({start + "force", Units<Dim>::force, std::move(now.normal_force)});
    fields.push_back({start + "area", Dim == 3 ? "m2" : "m", std::move(now.area)});
  }
  return fields;
}

template class ContactMeasure<2>;
template class ContactMeasure<3>;

}  // namespace washfsi
