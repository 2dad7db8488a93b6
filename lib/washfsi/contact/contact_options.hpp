// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/barrier.hpp"
#include "washfsi/contact/cushion.hpp"

namespace washfsi {

/// What keeps cloths out of other things.
enum class ContactKind {
  none,     ///< water alone
  cushion,  ///< a soft push from bodies and walls
  barrier,  ///< between cloths, which never pass through each other, and from bodies and walls
};
const ChoiceNames<ContactKind>& names_of(ContactKind);

/// All options of contact, prefix contact_.
struct ContactOptions {
  ContactKind kind = ContactKind::cushion;
  double distance = 0;         ///< at which contact begins [m]; 0: as the kind has it
  double body_distance = 0;    ///< of bodies and walls, of the barrier [m]; 0: as that has it
  double pressure = 0;         ///< of the cushion, P0 [Pa]; 0: none
  double stiffness = 1e4;      ///< of the barrier, kappa [Pa]
  double friction = 0.4;       ///< coefficient between cloths, with the barrier
  double body_friction = 0.2;  ///< the same on bodies and walls
  double damping = 0.3;        ///< with the barrier, of the motion along the normal, over the critical one
  bool drainage = false;       ///< films between cloths that are nearer than a cell drain along themselves
  double verify_interval = 0;  ///< between counts of intersections [s]; 0: after each step

  static ContactOptions from_options(Options& options);
  /// What these ask for.
  template <int Dim>
  std::vector<MakeForce<Dim>> forces(bool in_water) const;
};

}  // namespace washfsi
