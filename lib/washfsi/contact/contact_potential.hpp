// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/contact_force.hpp"

namespace washfsi {

/// A contact force that is minus the gradient of a potential of the places: of nearness, and of friction, which is
/// lagged (contact/friction.hpp). It owns the contact distances, which are smaller for what starts in contact.
template <int Dim>
class ContactPotential : public ContactForce<Dim> {
 public:
  /// `distance` is the usual contact distance [m], `friction` the coefficient of friction; `has_step_limit` as in
  /// `ForceKind`.
  ContactPotential(double distance, double friction, bool has_step_limit)
      : distances_(distance),
        kind_{.dependence = Dependence::potential, .has_friction = friction > 0, .has_step_limit = has_step_limit} {}

  ForceKind kind() const override { return kind_; }
  PairDistances& distances() override { return distances_; }
  const PairDistances& distances() const override { return distances_; }

 private:
  PairDistances distances_;
  ForceKind kind_;
};

}  // namespace washfsi
