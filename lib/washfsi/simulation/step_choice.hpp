// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/coupling/coupling_scheme.hpp"
#include "washfsi/simulation/checkpoint.hpp"
#include "washfsi/simulation/options.hpp"

namespace washfsi {

/// How long steps are: what the user asks for, as far as flow, bodies, cloth and accuracy let them. Walls and cloth
/// that meet water at once make it faster, by as much as no formula says: the first step is tried before it is taken,
/// and the first ones are taken again, shorter, as long as their CFL number is beyond the one that they were chosen
/// for.
template <int Dim>
class StepChoice {
 public:
  /// All must outlive it. Collective. Errors: InputError if -time_tolerance cannot see the scheme's error.
  StepChoice(const RunOptions& run, const CouplingOptions& coupling, System<Dim>& system, CouplingScheme<Dim>& scheme);

  /// Of the first step, unless that of a checkpoint is there. Collective. Errors: InputError.
  void begin(RunState& state) const;
  /// The bound of the coupling where the cloth was located last, so that a restarted run, which locates it anew, has
  /// the same steps. Collective.
  void find_cloth_bound(RunState& state) const;
  /// Takes a step. Whether it is one of the first, whose length may change. Collective. Errors: DivergedError.
  void advance(RunState& state) const;
  bool may_shorten() const;
  /// Of the next step, with the CFL number of the last. Collective.
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

extern template class StepChoice<2>;
extern template class StepChoice<3>;

}  // namespace washfsi
