// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/coupling/system.hpp"
#include "washfsi/measure/body_depths.hpp"
#include "washfsi/measure/intersections.hpp"
#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// Counts how often cloths go through each other and reach into bodies, after each step or in intervals
/// (-contact_verify_interval). Where contact limits the cloths' motion there must be none; else they are only counted,
/// if an interval is given.
template <int Dim>
class IntersectionMeasure {
 public:
  /// What is given must outlive it.
  IntersectionMeasure(const System<Dim>& system, BodyDepths<Dim>& depths);

  void declare(QuantityList& quantities);
  /// Before the first step, of a restarted run too. Collective. Errors: InputError if there is one that must not be.
  void verify_start();
  /// After a step of length dt. Collective. Errors: DivergedError if there is one that must not be.
  void verify(double dt);

 private:
  bool is_forbidden() const { return system_.model.forces.have_step_limit(); }
  bool counts() const;
  void count();
  /// The first that must not be, in words; empty if there is none.
  std::string forbidden() const;

  const System<Dim>& system_;
  IntersectionCount<Dim> of_cloths_;
  BodyDepths<Dim>& in_bodies_;
};

extern template class IntersectionMeasure<2>;
extern template class IntersectionMeasure<3>;

}  // namespace washfsi
