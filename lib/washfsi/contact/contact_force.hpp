// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

#include "washfsi/cloth/forces.hpp"
#include "washfsi/contact/pair_distances.hpp"
#include "washfsi/grid/boundary.hpp"
#include "washfsi/motion/body.hpp"
#include "washfsi/motion/load.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi {

/// The surroundings of the cloths for their forces. All must outlive the forces.
template <int Dim>
struct Surroundings {
  const Grid<Dim>& grid;
  const Boundary<Dim>& boundary;
  const std::vector<Body<Dim>>& bodies;
  const Cloths<Dim>& cloths;
};

/// Creates a force on the markers; null if it was not requested.
template <int Dim>
using MakeForce = std::function<std::unique_ptr<MarkerForce<Dim>>(const Surroundings<Dim>&)>;

/// Loads of contact: on each body, about its centre, and on the lower and upper side of the box along each axis, about
/// the box's middle.
template <int Dim>
struct ContactLoads {
  Loads<Dim> bodies;
  std::array<std::array<Load<Dim>, 2>, Dim> sides{};
};

/// Weighted mean: a share of the first loads, and the rest of the second.
template <int Dim>
ContactLoads<Dim> weighed(double share, ContactLoads<Dim> first, const ContactLoads<Dim>& second) {
  const auto weigh = [&](Load<Dim>& load, const Load<Dim>& other) { (load = share * load) += (1 - share) * other; };
  for (std::size_t b = 0; b < first.bodies.size(); ++b) weigh(first.bodies[b], second.bodies[b]);
  for (std::size_t axis = 0; axis < first.sides.size(); ++axis)
    for (std::size_t end = 0; end < 2; ++end) weigh(first.sides[axis][end], second.sides[axis][end]);
  return first;
}

/// The effect of contact on each of a rank's markers.
struct MarkerContact {
  std::vector<double> normal_force;    ///< sum of the normal forces, each by the marker's share [N]
  std::vector<double> area;            ///< undeformed area that touches [m2; m in the plane]
  std::vector<double> friction_power;  ///< friction power lost in the step: between cloths half on either, else all [W]

  explicit MarkerContact(std::size_t markers) : normal_force(markers), area(markers), friction_power(markers) {}
};

/// The place where things are nearest to each other, relative to their contact distance.
struct TightestContact {
  double share = 1;         ///< distance over the contact distance; 1: nothing touches
  std::string description;  ///< what touches, where, and how near it is
};

/// A force that keeps the markers away from others, or from the bodies and the sides of the box.
template <int Dim>
class ContactForce : public MarkerForce<Dim> {
 public:
  /// Whether it is with bodies and sides of the box, not between cloths.
  virtual bool is_with_bodies() const { return false; }
  /// The contact distances; things are the cloths and, after them, the bodies and the sides of the box.
  virtual PairDistances& distances() = 0;
  virtual const PairDistances& distances() const = 0;
  /// The tightest contact of this rank's markers at the places evaluated last. No communication.
  virtual TightestContact tightest() const = 0;
  /// Adds its effect on this rank's markers at these places. Collective.
  virtual void add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const = 0;
  /// Adds the reactions of this rank's markers at these places on bodies and sides of the box. Collective.
  virtual void add_reactions(const Points<Dim>&, ContactLoads<Dim>&) const {}
  /// Registers the contact distances of what started in contact; without stored ones they begin anew.
  void register_state(StateList& state) override {
    state.add({.name = is_with_bodies() ? "/body_contact_distances" : "/contact_distances",
               .slab = {},
               .get = [this] { return distances().stored(); },
               .set = [this](const StateEntry::Values& stored) { distances().restore(stored); },
               .spread = StateEntry::Spread::shared,
               .if_other = StateEntry::IfOther::begin_anew,
               .use = StateEntry::Use::restart});
  }
};

/// The reactions of all contact forces of this rank's markers at these places, as the last step saw the surroundings.
/// Collective.
template <int Dim>
ContactLoads<Dim> contact_loads(const Forces<Dim>& forces, const Points<Dim>& positions, std::size_t bodies) {
  ContactLoads<Dim> loads{Loads<Dim>(bodies), {}};
  for (const auto& force : forces.list())
    if (const auto* contact = dynamic_cast<const ContactForce<Dim>*>(force.get()))
      contact->add_reactions(positions, loads);
  return loads;
}

/// Describes the tightest contact of all ranks in words; empty if nothing touches. Collective.
template <int Dim>
std::string tightest_contact(const Forces<Dim>& forces) {
  TightestContact tightest;
  for (const auto& force : forces.list())
    if (const auto* contact = dynamic_cast<const ContactForce<Dim>*>(force.get()))
      if (TightestContact other = contact->tightest(); other.share < tightest.share) tightest = std::move(other);
  const double least = -largest(forces.comm(), -tightest.share);
  const std::string mine = tightest.share == least && least < 1 ? tightest.description + "\n" : "";
  const std::vector<char> all = of_all_ranks(forces.comm(), std::vector<char>(mine.begin(), mine.end()));
  return {all.begin(), std::find(all.begin(), all.end(), '\n')};
}

}  // namespace washfsi
