// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "washfsi/cloth/sheet.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

/// What a force depends on, and so what a coupling scheme may do with it.
enum class Dependence {
  none,        ///< neither places nor velocities: constant over a step
  potential,   ///< on places alone: minus the gradient of its energy, with its Jacobian
  places,      ///< on places alone, without an energy of its own; its Jacobian is only near the true one
  velocities,  ///< on velocities too: takes energy out of the cloth
};

/// The acceleration of a marker that moves with the mean velocity W in a step: rate W - known.
template <int Dim>
struct Acceleration {
  double rate = 0;    ///< [1/s]; 0: none
  Points<Dim> known;  ///< of this rank's markers [m/s2]
};

/// A step in which forces are held as they are at its start.
struct ExplicitStep {
  double dt = 0;                   ///< [s]; 0: none
  std::vector<double> mobilities;  ///< the most speed that a force over a time gives each of this rank's markers [1/kg]
};

/// The markers when a step begins, and the end of that step, at which a force is to act.
template <int Dim>
struct StepStart {
  const Points<Dim>&positions, &velocities;  ///< of this rank's markers [m, m/s]
  double time;                               ///< at which the forces act [s]
  double dt;                                 ///< for which the markers move until then [s]; 0: not at all
  Acceleration<Dim> acceleration = {};       ///< from the motion to the end; none where they do not move
  ExplicitStep lagged = {};                  ///< the step for which the forces at these places are held, if they are
  double share = 1;                          ///< of the step's mean force that those at its end make up
};

/// What the longest explicit step needs of a marker.
struct StiffnessBound {
  double stiffness = 0;  ///< a quarter of the largest eigenvalue of the stiffness per undeformed area [N/m3]
  double damping = 0;    ///< Kelvin-Voigt time [s]
};

/// Takes the block of K = d2E/dX2 between two markers, given by their numbers among those of all ranks.
template <int Dim>
using AddMarkerBlock = std::function<void(PetscInt row, PetscInt column, const StiffnessBlock<Dim>& block)>;

/// Something that pushes on markers. Arrays hold this rank's markers; forces are per marker [N; per unit depth in the
/// plane]. All members are collective.
template <int Dim>
class MarkerForce {
 public:
  MarkerForce() = default;
  MarkerForce(const MarkerForce&) = delete;
  MarkerForce& operator=(const MarkerForce&) = delete;
  virtual ~MarkerForce() = default;

  virtual Dependence dependence() const = 0;
  /// The option that asked for it, for messages.
  virtual std::string origin() const = 0;
  /// Whether its energy is stored in the cloth itself.
  virtual bool is_elastic() const { return false; }

  /// Whether it has friction, and so needs to know an explicit step.
  virtual bool has_friction() const { return false; }

  /// Called before a step, by some schemes twice: looks at what is near, and keeps it until the next call. With dt = 0
  /// at the step's start, for the forces as they are there; with dt > 0 for those at the end, which may be solved for.
  virtual void begin_step(const StepStart<Dim>&) {}

  /// Adds the force.
  virtual void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const = 0;
  /// Adds this rank's part of the energy of each group of cloths [J; per unit depth in the plane].
  virtual void add_energy(const Points<Dim>&, std::span<double>) const {}
  /// Adds -K d: the rate of change of the force as the markers move along a direction d.
  virtual void add_force_rates(const Points<Dim>&, const Points<Dim>&, Points<Dim>&) const {}
  /// Called before K is taken at new places, as Newton's method goes on: for a force that gives its K by what it knows
  /// of the way there.
  virtual void linearise(const Points<Dim>&) {}
  /// Gives the blocks of K in the rows of this rank's markers, always the same ones in the same order as long as
  /// `pattern` returns the same number; it need not be the same on all ranks. Best is one that depends on the blocks
  /// alone, so that a matrix that fits is not laid out anew.
  virtual void visit_stiffness(const Points<Dim>&, GeometricStiffness, const AddMarkerBlock<Dim>&) const {}
  virtual long pattern() const { return 0; }
  /// Whether blocks at the last places were left out since the pattern has none for them; and makes a pattern with
  /// these, before a matrix is laid out anew.
  virtual bool outgrows_pattern() const { return false; }
  virtual void renew_pattern() {}
  /// Adds a size of the parts that the force of each marker is the difference of: its round-off over the machine's.
  virtual void add_cancelling_size(const Points<Dim>&, std::span<double>) const {}
  /// Adds to the bound of each marker.
  virtual void add_bound(std::span<StiffnessBound>) const {}

  /// Whether there are places that it does not let markers come to, so that a scheme has to ask before it moves them.
  virtual bool has_step_limit() const { return false; }
  /// The part of a straight motion, from 0 to 1, that all markers can make without coming to such places. What it looks
  /// at after that is right for all places on this way.
  virtual double step_limit(const Points<Dim>&, const Points<Dim>&) { return 1; }
  /// Registers what goes on from step to step.
  virtual void register_state(StateList&) {}

  /// Shortens the motion of those markers that would come to such places.
  virtual void shorten(const Points<Dim>&, Points<Dim>&) {}
};

}  // namespace washfsi
