// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/contact_planes.hpp"
#include "washfsi/contact/friction.hpp"

namespace washfsi {

/// The friction of cloth on bodies and sides of the box in a step, and the damping of its motion along the normal: with
/// the normal forces of the step's start, and the motion relative to the surface in the step. Places and velocities are
/// those of the markers with halo, as planes index them.
template <int Dim>
class BodyFriction {
 public:
  /// The cloths must outlive it.
  BodyFriction(const BodyContactOptions& options, const Cloths<Dim>& cloths)
      : coefficient_(options.friction), damping_(options.damping), cloths_(cloths) {}

  /// Begins a step with the planes that are pressed at its start. With dt = 0 nothing slides, unless an explicit step
  /// follows: in this, markers and surfaces slide as they do at its start, and are not damped. No communication.
  void begin(const StepStart<Dim>& start, const Points<Dim>& velocities, const ContactPlanes<Dim>& planes);
  /// Linearises for Newton's method at these places.
  void linearise(const Points<Dim>& all) { friction_.linearise(ways(all)); }
  /// The length of the step [s].
  double dt() const { return friction_.dt(); }

  /// Calls visit(plane, friction force there) at these places.
  template <class Visit>
  void visit(const Points<Dim>& all, const Visit& visit) const {
    const std::vector<FrictionForce<Dim>> forces = friction_.forces(ways(all));
    for (std::size_t r = 0; r < forces.size(); ++r) visit(sliding_[r].plane, forces[r]);
  }

 private:
  /// A friction pair: a point of a cloth that slides on a plane in this step.
  struct SlidingPoint {
    TangentPlane<Dim> plane;
    Point<Dim> way;  ///< motion of the surface in the step; in an explicit step, relative to the point [m]
  };
  FrictionPair<Dim> pair(const TangentPlane<Dim>& plane, const BodyPush& before, const StepStart<Dim>& start) const;
  Points<Dim> ways(const Points<Dim>& all) const;

  double coefficient_, damping_;
  const Cloths<Dim>& cloths_;
  std::vector<SlidingPoint> sliding_;
  Friction<Dim> friction_;
};

extern template class BodyFriction<2>;
extern template class BodyFriction<3>;

}  // namespace washfsi
