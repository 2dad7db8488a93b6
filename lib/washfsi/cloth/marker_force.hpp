// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "washfsi/cloth/sheet.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

/// The variables on which a force depends, which decide how a coupling scheme may treat it.
enum class Dependence {
  none,        ///< neither places nor velocities: constant over a step
  potential,   ///< on places alone: minus the gradient of its energy, with its Jacobian
  places,      ///< on places alone, without an energy of its own; its Jacobian is approximate, so schemes with Newton's
               ///< method refuse it
  velocities,  ///< on velocities too: dissipates energy of the cloth
};

/// What a coupling scheme has to know of a force.
struct ForceKind {
  Dependence dependence;
  bool is_elastic = false;      ///< whether its energy is stored in the cloth itself
  bool has_friction = false;    ///< whether it has friction, which depends on the length of an explicit step
  bool has_step_limit = false;  ///< whether it forbids some places to markers: schemes shorten motions to `step_limit`
};

/// The acceleration of a marker that moves with the mean velocity W in a step: rate W - known.
template <int Dim>
struct Acceleration {
  double rate = 0;    ///< factor of W [1/s]; 0: no acceleration
  Points<Dim> known;  ///< known part for this rank's markers [m/s2]
};

/// A step in which forces are constant, as at its start.
struct ExplicitStep {
  double dt = 0;                   ///< length [s]; 0: no such step
  std::vector<double> mobilities;  ///< most speed per impulse of each of this rank's markers [1/kg]
};

/// What a force is told before a step: the markers at its start, and the time at which the force will act.
template <int Dim>
struct StepStart {
  const Points<Dim>&positions, &velocities;  ///< positions and velocities of this rank's markers [m, m/s]
  double time;                               ///< time at which the forces act [s]
  double dt;                                 ///< time for which the markers move until then [s]; 0: not at all
  Acceleration<Dim> acceleration = {};       ///< acceleration in the step; none where markers do not move
  ExplicitStep lagged = {};                  ///< the explicit step over which the forces at these places are constant
  double share = 1;                          ///< weight of these forces in the step's mean force
};

/// The quantities of a marker that bound the explicit step.
struct StiffnessBound {
  double stiffness = 0;  ///< a quarter of the largest eigenvalue of the stiffness per undeformed area [N/m3]
  double damping = 0;    ///< Kelvin-Voigt time [s]
};

/// Takes the block of K = d2Psi/dX2 between two markers, given by their numbers among those of all ranks.
template <int Dim>
using AddMarkerBlock = std::function<void(PetscInt row, PetscInt column, const StiffnessBlock<Dim>& block)>;

/// A force on markers. Arrays are of this rank's markers; forces are per marker [N; per unit depth in the plane]. All
/// members are collective.
template <int Dim>
class MarkerForce {
 public:
  MarkerForce() = default;
  MarkerForce(const MarkerForce&) = delete;
  MarkerForce& operator=(const MarkerForce&) = delete;
  virtual ~MarkerForce() = default;

  virtual ForceKind kind() const = 0;
  /// The option that created it, for messages.
  virtual std::string origin() const = 0;

  /// Called before a step, by some schemes twice: finds what is near, valid until the next call. With dt = 0 at the
  /// step's start, for the forces there; with dt > 0 for those at the end, which may be solved for.
  virtual void begin_step(const StepStart<Dim>&) {}

  /// Adds the force.
  virtual void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const = 0;
  /// Adds this rank's part of the energy of each group of cloths [J; per unit depth in the plane].
  virtual void add_energy(const Points<Dim>&, std::span<double>) const {}
  /// Adds -K d: the rate of change of the force as the markers move along a direction d.
  virtual void add_force_rates(const Points<Dim>&, const Points<Dim>&, Points<Dim>&) const {}
  /// Called by Newton's method before K is evaluated at new places: for a force whose K depends on earlier iterates.
  virtual void linearise(const Points<Dim>&) {}
  /// Visits the blocks of K in the rows of this rank's markers, always the same ones in the same order as long as
  /// `pattern` returns the same number, which may differ between ranks. Best the number depends on the blocks alone, so
  /// that a fitting matrix is not laid out again.
  virtual void visit_stiffness(const Points<Dim>&, GeometricStiffness, const AddMarkerBlock<Dim>&) const {}
  virtual long pattern() const { return 0; }
  /// Whether blocks at the last places were left out because the pattern lacks them; and renews the pattern with these,
  /// before a matrix is laid out again.
  virtual bool outgrows_pattern() const { return false; }
  virtual void renew_pattern() {}
  /// Adds the size of the terms whose difference is the force on each marker: its round-off over the machine's.
  virtual void add_cancelling_size(const Points<Dim>&, std::span<double>) const {}
  /// Adds to the bound of each marker.
  virtual void add_bound(std::span<StiffnessBound>) const {}

  /// The share of a straight motion, from 0 to 1, that all markers can make without reaching such places. Afterwards
  /// what it has found near the markers is valid for all places on this way.
  virtual double step_limit(const Points<Dim>&, const Points<Dim>&) { return 1; }
  /// Called with the solution of a step: refines what the force simplified for this step where these places show that
  /// it was too simple. Returns whether it did; then the step has to be solved again. Collective.
  virtual bool sharpen(const Points<Dim>&) { return false; }
  /// Registers the state that it carries from step to step.
  virtual void register_state(StateList&) {}

  /// Shortens the motion of those markers that would reach forbidden places.
  virtual void shorten(const Points<Dim>&, Points<Dim>&) {}
};

/// Whether a force depends on places alone, with its Jacobian or an approximate one.
template <int Dim>
bool is_of_places(const MarkerForce<Dim>& force) {
  const Dependence dependence = force.kind().dependence;
  return dependence == Dependence::potential || dependence == Dependence::places;
}

}  // namespace washfsi
