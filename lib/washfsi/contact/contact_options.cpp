// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/contact_options.hpp"

#include <algorithm>

#include "washfsi/support/errors.hpp"
#include "washfsi/support/format_text.hpp"

namespace washfsi {

const ChoiceNames<ContactKind>& names_of(ContactKind) {
  static const ChoiceNames<ContactKind> names{
      {"none", ContactKind::none}, {"penalty", ContactKind::penalty}, {"barrier", ContactKind::barrier}};
  return names;
}

namespace {

constexpr Range coefficient{0.0, 5.0, false, "a number from 0 to 5"};

// Marks the options that the kind of contact does not use.
void mark_unused(Options& options, const ContactOptions& contact) {
  const std::string kind = "-contact is " + name_of(contact.kind);
  if (contact.kind != ContactKind::barrier)
    options.mark_idle(kind, {"contact_body_distance", "contact_stiffness", "contact_friction", "contact_body_friction",
                             "contact_damping"});
  if (contact.kind != ContactKind::penalty) options.mark_idle(kind, {"contact_pressure"});
  if (contact.kind == ContactKind::none) options.mark_idle(kind, {"contact_distance"});
}

}  // namespace

ContactOptions ContactOptions::from_options(Options& options, bool has_cloths, const Refinement& refinement) {
  ContactOptions contact;
  if (!has_cloths) contact.kind = ContactKind::none;
  options.alias_value("contact", "cushion", "penalty");
  options.block("", "Contact of cloths", [&](OptionBlock& block) {
    block.choice(
        "contact", contact.kind,
        "what keeps cloth out of others: a barrier between cloths, which none passes, and on bodies and walls; penalty "
        "contact with bodies and walls, of a given pressure; or only water");
  });
  options.block("contact_", "Contact of cloths", [&](OptionBlock& block) {
    block.real(
        "distance", contact.distance, "m", non_negative,
        "at which contact begins; 0: 0.01 of penalty contact, 0.16 of the least spacing of markers of the barrier");
    block.real("body_distance", contact.body_distance, "m", non_negative,
               "at which the barrier of bodies and walls begins; 0: 0.4 of the least spacing of markers, and in "
               "water at least the least width of a cell");
    block.real("pressure", contact.pressure, "Pa", non_negative,
               "of penalty contact, on cloth at a body's surface; 0: there is none");
    block.real("stiffness", contact.stiffness, "Pa", positive, "of the barrier");
    block.real("friction", contact.friction, "-", coefficient, "coefficient between cloths, with the barrier");
    block.real("body_friction", contact.body_friction, "-", coefficient,
               "coefficient of cloths on bodies and walls, with the barrier");
    block.real(
        "damping", contact.damping, "-", coefficient,
        "of the motion towards and from what a cloth touches, over the critical one for its excess mass, with the "
        "barrier; 0: it bounces");
    block.boolean("drainage", contact.drainage,
                  "water between cloths that are nearer than a cell drains along them, by the law of squeezed films "
                  "(semi_implicit, implicit)");
    block.real("verify_interval", contact.verify_interval, "s", non_negative,
               "between counts of the cloths' intersections; 0: after each step with the barrier, else never");
  });
  refinement.divide(options, "contact_distance", contact.distance);
  refinement.divide(options, "contact_body_distance", contact.body_distance);
  if (contact.kind == ContactKind::penalty && contact.pressure == 0 && !options.help())
    throw InputError("-contact penalty: needs -contact_pressure, above 0");
  if (has_cloths) mark_unused(options, contact);
  return contact;
}

namespace {

// Refuses contact distances of more than two spacings of markers and two cells: surfaces would push distant cloth.
template <int Dim>
void refuse_far_reach(const std::string& option, double distance, const Surroundings<Dim>& around) {
  double most = around.grid.spacing().maxCoeff();
  for (const auto& group : around.cloths.groups())
    most = std::max({most, group.sheet.ds, Dim == 3 ? group.sheet.dr : group.sheet.ds});
  if (distance > 2 * most && around.cloths.marker_count() > 0)
    throw InputError(option + " " + to_text(distance) + ": must be at most " + format_text("%.6g", 2 * most) +
                     " m, twice the widest spacing of markers or cells; farther off nothing touches");
}

template <int Dim>
MakeForce<Dim> within_reach(const std::string& option, double distance, MakeForce<Dim> make) {
  return [=](const Surroundings<Dim>& around) {
    refuse_far_reach(option, distance, around);
    return make(around);
  };
}

}  // namespace

template <int Dim>
std::vector<MakeForce<Dim>> ContactOptions::forces(bool in_water) const {
  if (kind == ContactKind::none) return {};
  if (kind == ContactKind::barrier) {
    const BarrierOptions barrier{distance, body_distance, stiffness, friction, body_friction, damping};
    return {within_reach<Dim>("-contact_body_distance", body_distance, barrier_of_bodies<Dim>(barrier, in_water)),
            Barrier<Dim>::maker(barrier)};
  }
  BodyContactOptions penalty;
  penalty.pressure = pressure;
  if (distance > 0) penalty.distance = distance;
  return {within_reach<Dim>("-contact_distance", distance, BodyContact<Dim>::maker(penalty))};
}

template std::vector<MakeForce<2>> ContactOptions::forces<2>(bool) const;
template std::vector<MakeForce<3>> ContactOptions::forces<3>(bool) const;

}  // namespace washfsi
