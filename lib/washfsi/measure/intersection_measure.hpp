// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/coupling/system.hpp"
#include "washfsi/measure/body_depths.hpp"
#include "washfsi/measure/intersections.hpp"
#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// Counts intersections of cloths with each other and with bodies, after each step or in intervals
/// (-contact_verify_interval). If contact has a step limit there must be none; else they are only counted, if an
/// interval is given.
template <int Dim>
class IntersectionMeasure {
 public:
  /// All arguments must outlive it.
  IntersectionMeasure(const System<Dim>& system, BodyDepths<Dim>& depths);

  void declare(QuantityList& quantities);
  /// Counts before the first step, also of a restarted run. Collective. Errors: InputError if one is forbidden.
  void verify_start();
  /// Counts after a step of length dt, if due. Collective. Errors: DivergedError if one is forbidden.
  void verify(double dt);

 private:
  bool is_forbidden() const { return system_.model.forces.have_step_limit(); }
  bool counts() const;
  void count();
  /// Describes the first forbidden intersection; empty if there is none.
  std::string forbidden() const;

  const System<Dim>& system_;
  IntersectionCount<Dim> of_cloths_;
  BodyDepths<Dim>& in_bodies_;
};

extern template class IntersectionMeasure<2>;
extern template class IntersectionMeasure<3>;

}  // namespace washfsi
