// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/friction.hpp"
#include "washfsi/contact/tangent_planes.hpp"

namespace washfsi {

/// The law by which the push of a surface grows with nearness.
enum class CushionLaw { quadratic, barrier };

/// The parameters of a cushion.
struct CushionOptions {
  double pressure = 0;     ///< P0, at the surface, or kappa of the barrier [Pa]; 0: no contact force
  double distance = 0.01;  ///< d0, contact distance [m]
  CushionLaw law = CushionLaw::quadratic;
  double friction = 0;  ///< coefficient of friction
  double damping = 0;   ///< damping of the normal motion over the critical one, in implicit steps
};

/// The action of a cushion per undeformed area at a distance from a surface.
struct CushionPush {
  double energy = 0, pressure = 0, stiffness = 0;  ///< [J/m2, Pa, N/m3]
};
/// The push for the contact distance `begins` [m]; below the share `soft` of that the barrier is a parabola.
CushionPush cushion_push(const CushionOptions& options, double distance, double begins, double soft = 0);

/// Penalty contact that keeps cloth out of bodies and sides of the box: a marker nearer than d0 is pushed along the
/// outward normal with the force per undeformed area
///   P0 s^2,  s = (d0 - Phi)/d0 > 0,      energy P0 d0/3 s^3,      stiffness 2 P0/d0 s n n^T
/// or, with the law of the barrier between cloths (contact/barrier_function.hpp),
///   -P0 b'(Phi/d0),                      energy P0 d0 b,          stiffness P0/d0 b'' n n^T
/// In a step Phi is the distance from a plane that moves with the body (contact/tangent_planes.hpp): so the energy is
/// convex, and its stiffness exact and never negative. With the barrier no motion goes through the plane
/// (`step_limit`); only where a moving body comes nearer than d0/10 to a marker at rest by the step's end, the barrier
/// continues from there with constant stiffness. A post or an edge may come nearest to a place in a face rather than to
/// a marker: this place is pushed likewise from d0/2 on, with the area of the face. Points that start nearer than d0
/// have their own distance (contact/pair_distances.hpp). Friction is that of the barrier between cloths
/// (contact/friction.hpp), with the normal force of the step's start and the motion relative to the surface in the
/// step.
template <int Dim>
class Cushion : public ContactForce<Dim> {
 public:
  Cushion(const CushionOptions& options, const Surroundings<Dim>& surroundings);
  /// Returns what creates the force; it creates none if the pressure is 0.
  static MakeForce<Dim> maker(const CushionOptions& options);

  Dependence dependence() const override { return Dependence::potential; }
  std::string origin() const override { return "-contact_pressure"; }
  bool has_friction() const override { return options_.friction > 0; }
  void begin_step(const StepStart<Dim>& start) override;
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
  void add_energy(const Points<Dim>& positions, std::span<double> of_groups) const override;
  void add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction, Points<Dim>& rates) const override;
  void visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                       const AddMarkerBlock<Dim>& add) const override;
  void add_bound(std::span<StiffnessBound> bounds) const override;
  void linearise(const Points<Dim>& positions) override { friction_.linearise(ways(with_halo(positions))); }
  bool has_step_limit() const override { return options_.law == CushionLaw::barrier; }
  double step_limit(const Points<Dim>& from, const Points<Dim>& motion) override;
  PairDistances& distances() override { return distances_; }
  const PairDistances& distances() const override { return distances_; }
  TightestContact tightest() const override;
  bool is_with_bodies() const override { return true; }
  void add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const override;
  void add_reactions(const Points<Dim>& positions, ContactLoads<Dim>& loads) const override;

 private:
  using Plane = TangentPlane<Dim>;
  /// A friction pair: a point of a cloth that slides on a plane in this step.
  struct Rubbing {
    Plane plane;
    Point<Dim> way;  ///< motion of the surface in the step; in an explicit step, relative to the point [m]
  };
  /// The values of this rank's markers, followed by those with halo where faces need these. Collective.
  Points<Dim> with_halo(const Points<Dim>& values) const;
  void follow_distances();
  void begin_friction(const StepStart<Dim>& start, const Points<Dim>& velocities);
  Points<Dim> ways(const Points<Dim>& all) const;
  template <class Visit>
  void visit_friction(const Points<Dim>& all, const Visit& visit) const;
  template <class Visit>
  void visit_own(const Plane& plane, const Visit& visit) const;
  Point<Dim> middle() const { return 0.5 * (around_.grid.lower() + around_.grid.upper()); }
  void add_reaction(const Plane& plane, const Points<Dim>& all, const Point<Dim>& reaction,
                    ContactLoads<Dim>& loads) const;
  double gap(const Plane& plane, const Points<Dim>& all) const {
    return plane.distance + plane.normal.dot(plane.place(all) - plane.start);
  }
  /// The share of the contact distance below which the barrier is soft.
  double softness(const Plane& plane) const;
  CushionPush push(const Plane& plane, double gap) const;
  CushionPush push(const Plane& plane, const Points<Dim>& all) const { return push(plane, gap(plane, all)); }

  CushionOptions options_;
  Surroundings<Dim> around_;
  PairDistances distances_;
  TangentPlanes<Dim> planes_near_;
  double time_ = 0;  ///< the step's end [s]
  std::vector<Plane> planes_;
  bool has_faces_ = false;  ///< whether any rank has a plane of a face
  std::vector<Rubbing> rubbing_;
  Friction<Dim> friction_;
};

extern template class Cushion<2>;
extern template class Cushion<3>;

}  // namespace washfsi
