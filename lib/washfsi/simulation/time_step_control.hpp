// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/coupling/coupling_scheme.hpp"
#include "washfsi/simulation/checkpoint.hpp"
#include "washfsi/simulation/options.hpp"

namespace washfsi {

/// The choice of step lengths: as the user requests, within the limits of flow, bodies, cloth and accuracy. Walls and
/// cloth that meet water abruptly accelerate it by an unpredictable amount: the first step is tried before it is taken,
/// and the first ones are repeated, shorter, as long as their CFL number exceeds the one for which they were chosen.
template <int Dim>
class TimeStepControl {
 public:
  /// All must outlive it. Collective. Errors: InputError if -time_tolerance cannot measure the scheme's error.
  TimeStepControl(const RunOptions& run, const CouplingOptions& coupling, System<Dim>& system,
                  CouplingScheme<Dim>& scheme);

  /// Chooses the length of the first step, unless a checkpoint gives it. Collective. Errors: InputError.
  void begin(RunState& state) const;
  /// Computes the bound of the coupling where the cloth was located last, so that a restarted run, which locates it
  /// again, has the same steps. Collective.
  void find_cloth_bound(RunState& state) const;
  /// Takes a step; if it is one of the first, its length may change. Collective. Errors: DivergedError.
  void advance(RunState& state) const;
  bool may_shorten() const;
  /// Chooses the length of the next step, given the CFL number of the last. Collective.
  void adapt(RunState& state, double courant) const;

 private:
  bool starts_at_once() const;
  double tried(double dt) const;
  double courant_now(double dt) const;
  std::optional<double> courant_after(double dt) const;
  double longest_step(const RunState& state) const;
  double accurate_step(const RunState& state) const;

  const RunOptions& run_;
  System<Dim>& system_;
  CouplingScheme<Dim>& scheme_;
  BodySpeeds<Dim> body_speeds_;
};

extern template class TimeStepControl<2>;
extern template class TimeStepControl<3>;

}  // namespace washfsi
