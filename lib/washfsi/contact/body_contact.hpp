// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/body_friction.hpp"
#include "washfsi/contact/contact_planes.hpp"
#include "washfsi/contact/contact_potential.hpp"

namespace washfsi {

/// Contact that keeps cloth out of bodies and sides of the box. A marker at a signed distance Phi below the contact
/// distance is repelled along the outward normal n. Penalty contact has, per undeformed area,
///   pressure p_0 Phi~^2,          energy 1/3 p_0 d_0 Phi~^3,    stiffness 2 p_0/d_0 Phi~ n n^T
/// with Phi~ = (d_0 - Phi)/d_0 > 0; the barrier, with the function b of contact/barrier_function.hpp, has
///   pressure -kappa b'(Phi/d^),   energy kappa d^ b(Phi/d^),    stiffness kappa/d^ b''(Phi/d^) n n^T
/// In a step Phi is the distance from a plane that moves with the body (contact/tangent_planes.hpp): so the energy is
/// convex, and its stiffness exact and never negative. With the barrier no motion passes through the plane
/// (`step_limit`). Only where a moving body comes nearer than d^/10 to a marker at rest by the end of the step, the
/// barrier continues from there with constant stiffness; where the solution of the step lies deep in that part, it
/// begins nearer, and the step is solved again (`sharpen`). A post or an edge may be nearest to a place within a face
/// rather than to a marker. This place is repelled from d^/2 on, with the area of the face; so is a second place that
/// the face turns to the body, if the solution shows one. Points that start nearer than the contact distance have their
/// own distance (contact/pair_distances.hpp). Friction is that of the barrier between cloths (contact/friction.hpp),
/// with the normal force at the start of the step and the motion relative to the surface in the step.
template <int Dim>
class BodyContact : public ContactPotential<Dim> {
 public:
  BodyContact(const BodyContactOptions& options, const Surroundings<Dim>& surroundings);
  /// Returns what creates the force; it creates none if the pressure is 0.
  static MakeForce<Dim> maker(const BodyContactOptions& options);

  std::string origin() const override { return "-contact_pressure"; }
  void begin_step(const StepStart<Dim>& start) override;
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
  void add_energy(const Points<Dim>& positions, std::span<double> of_groups) const override;
  void add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction, Points<Dim>& rates) const override;
  void visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                       const AddMarkerBlock<Dim>& add) const override;
  void add_bound(std::span<StiffnessBound> bounds) const override;
  void linearise(const Points<Dim>& positions) override { friction_.linearise(planes_.with_halo(positions)); }
  double step_limit(const Points<Dim>& from, const Points<Dim>& motion) override;
  bool sharpen(const Points<Dim>& positions) override { return planes_.sharpen(positions); }
  TightestContact tightest() const override;
  bool is_with_bodies() const override { return true; }
  void add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const override;
  void add_reactions(const Points<Dim>& positions, ContactLoads<Dim>& loads) const override;

 private:
  using Plane = TangentPlane<Dim>;
  void add_reaction(const Plane& plane, const Points<Dim>& all, const Point<Dim>& reaction,
                    ContactLoads<Dim>& loads) const;

  BodyContactOptions options_;
  Surroundings<Dim> around_;
  ContactPlanes<Dim> planes_;
  BodyFriction<Dim> friction_;
};

extern template class BodyContact<2>;
extern template class BodyContact<3>;

}  // namespace washfsi
