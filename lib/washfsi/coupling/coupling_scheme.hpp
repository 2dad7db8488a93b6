// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "washfsi/coupling/step_bound.hpp"
#include "washfsi/coupling/system.hpp"

namespace washfsi {

/// How the implicit coupling weighs the two ends of a step.
enum class TimeScheme { trapezoidal, backward_euler };
const ChoiceNames<TimeScheme>& names_of(TimeScheme);

/// How the semi-implicit coupling represents the mobility of the markers.
enum class Mobility { matrix, row_sums };
const ChoiceNames<Mobility>& names_of(Mobility);

/// The default of -coupling_sweeps where the cloths carry their own mass: an impulsive start takes some.
inline constexpr PetscInt most_sweeps_with_inertia = 10;

/// How cloth and water are coupled in a step.
struct CouplingOptions {
  std::string scheme = "semi_implicit";           ///< one of `coupling_schemes`; not for cloth or water alone
  bool scheme_given = false;                      ///< whether the user gave the scheme
  std::string scheme_option = "coupling_scheme";  ///< the name by which the user gave it
  TimeScheme time_scheme = TimeScheme::trapezoidal;
  Mobility mobility = Mobility::matrix;
  double mobility_factor = 1;  ///< factor of the markers' mobility
  double tolerance = 1e-5;     ///< rms residual of the markers' velocities over the flow's speed
  PetscInt order = 2;          ///< order in time of the semi-implicit coupling: 1 or 2
  PetscInt sweeps = 1;         ///< most sweeps of the semi-implicit coupling; `from_options` has more by default
  MassCarrier mass_carrier =
      MassCarrier::water;        ///< what has the cloths' excess mass; `from_options`: as the scheme has it
  double slip_tolerance = 0.01;  ///< relative slip of cloth and water below which no further sweep is made

  static CouplingOptions from_options(Options& options);

 private:
  void read_scheme(Options& options);
  void read_solution(Options& options);
};

/// A way of advancing cloth and water together by one time step.
template <int Dim>
class CouplingScheme {
 public:
  /// Whether the cloths may carry their own mass; schemes that let them redeclare it.
  static constexpr bool takes_inertia = false;
  /// Whether the cloths may let water through; schemes that allow it redeclare it.
  static constexpr bool takes_seepage = false;

  CouplingScheme() = default;
  CouplingScheme(const CouplingScheme&) = delete;
  CouplingScheme& operator=(const CouplingScheme&) = delete;
  virtual ~CouplingScheme() = default;

  /// Advances the system from t^n to t^n + dt. Collective. Errors: DivergedError.
  void advance(System<Dim>& system, double dt) {
    State<Dim>& state = system.state;
    const Points<Dim> start = state.positions;
    Points<Dim> before = state.velocities;
    advance_fields(system, dt);
    state.velocities_before = std::move(before);
    state.mean_velocities = (1 / dt) * (state.positions - start);
    state.clock.advance(dt);
  }
  /// Longest step for the cloth as it lies now [s]: that of the explicit coupling unless overridden. Collective.
  virtual double step_bound(const System<Dim>& system) const { return cloth_step_bound<Dim>(system.model); }

 private:
  /// Takes a step without advancing the clock, which shows t^n.
  virtual void advance_fields(System<Dim>& system, double dt) = 0;
};

/// Creates the scheme for a system. Collective. Errors: InputError if it does not fit the cloths.
template <int Dim>
std::unique_ptr<CouplingScheme<Dim>> make_coupling_scheme(const CouplingOptions& options, System<Dim>& system);

}  // namespace washfsi
