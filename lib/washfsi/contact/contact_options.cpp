// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/contact_options.hpp"

namespace washfsi {

const ChoiceNames<ContactKind>& names_of(ContactKind) {
  static const ChoiceNames<ContactKind> names{
      {"none", ContactKind::none}, {"cushion", ContactKind::cushion}, {"barrier", ContactKind::barrier}};
  return names;
}

ContactOptions ContactOptions::from_options(Options& options) {
  ContactOptions contact;
  options.block("", "Contact of cloths", [&](OptionBlock& block) {
    block.choice(
        "contact", contact.kind,
        "what keeps cloth out of others: only water; a cushion on bodies and walls; or a barrier between cloths, "
        "which none passes, and on bodies and walls");
  });
  options.block("contact_", "Contact of cloths", [&](OptionBlock& block) {
    block.real("distance", contact.distance, "m", non_negative,
               "at which contact begins; 0: 0.01 of the cushion, 0.16 of the least spacing of markers of the barrier");
    block.real("body_distance", contact.body_distance, "m", non_negative,
               "at which the barrier of bodies and walls begins; 0: 0.4 of the least spacing of markers");
    block.real("pressure", contact.pressure, "Pa", non_negative,
               "push of the cushion on cloth at a body's surface; 0: no cushion");
    block.real("stiffness", contact.stiffness, "Pa", positive, "of the barrier");
    block.real("friction", contact.friction, "-", non_negative, "coefficient between cloths, with the barrier");
    block.real("body_friction", contact.body_friction, "-", non_negative,
               "coefficient of cloths on bodies and walls, with the barrier");
    block.boolean("drainage", contact.drainage,
                  "water between cloths that are nearer than a cell drains along them, by the law of squeezed films "
                  "(semi_implicit, implicit)");
    block.real("verify_interval", contact.verify_interval, "s", non_negative,
               "between counts of the cloths' intersections, with the barrier; 0: after each step");
  });
  return contact;
}

template <int Dim>
std::vector<MakeForce<Dim>> ContactOptions::forces() const {
  if (kind == ContactKind::none) return {};
  if (kind == ContactKind::barrier) {
    const BarrierOptions barrier{distance, body_distance, stiffness, friction, body_friction};
    return {barrier_of_bodies<Dim>(barrier), Barrier<Dim>::maker(barrier)};
  }
  CushionOptions cushion;
  cushion.pressure = pressure;
  if (distance > 0) cushion.distance = distance;
  return {Cushion<Dim>::maker(cushion)};
}

template std::vector<MakeForce<2>> ContactOptions::forces<2>() const;
template std::vector<MakeForce<3>> ContactOptions::forces<3>() const;

}  // namespace washfsi
