// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/barrier.hpp"
#include "washfsi/contact/body_contact.hpp"
#include "washfsi/support/refinement.hpp"

namespace washfsi {

/// The kind of contact.
enum class ContactKind {
  none,     ///< no contact force: water alone separates
  penalty,  ///< penalty contact with bodies and sides of the box
  barrier,  ///< between cloths, which never pass through each other, and with bodies and sides of the box
};
const ChoiceNames<ContactKind>& names_of(ContactKind);

/// All options of contact, prefix contact_.
struct ContactOptions {
  ContactKind kind = ContactKind::barrier;  ///< none by default without cloths
  double distance = 0;                      ///< d_0 or d^, contact distance [m]; 0: the default of the kind
  double body_distance = 0;    ///< barrier's contact distance of bodies and sides of the box [m]; 0: its default
  double pressure = 0;         ///< p_0 of penalty contact [Pa]; 0: there is none
  double stiffness = 1e4;      ///< kappa of the barrier [Pa]
  double friction = 0.4;       ///< mu_C between cloths, with the barrier
  double body_friction = 0.2;  ///< mu_C on bodies and sides of the box
  double damping = 0.3;        ///< zeta, damping of the normal motion with the barrier over the critical one
  bool drainage = false;       ///< whether films between cloths nearer than a cell drain
  double verify_interval = 0;  ///< interval between counts of intersections [s]; 0: each step with the barrier

  /// Without cloths there is no contact by default.
  static ContactOptions from_options(Options& options, bool has_cloths, const Refinement& refinement);
  /// Makers of the forces that these options request.
  template <int Dim>
  std::vector<MakeForce<Dim>> forces(bool in_water) const;
};

}  // namespace washfsi
