// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/contact_force.hpp"
#include "washfsi/contact/friction.hpp"

namespace washfsi {

/// How the push of a surface grows with nearness.
enum class CushionLaw { quadratic, barrier };

/// What pushes, and from where on.
struct CushionOptions {
  double pressure = 0;     ///< P0, at the surface, or kappa of the barrier [Pa]; 0: no contact force
  double distance = 0.01;  ///< d0 [m]
  CushionLaw law = CushionLaw::quadratic;
  double friction = 0;  ///< coefficient, in steps that are solved for
};

/// What a cushion does per undeformed area at a distance from a surface.
struct CushionPush {
  double energy = 0, pressure = 0, stiffness = 0;  ///< [J/m2, Pa, N/m3]
};
CushionPush cushion_push(const CushionOptions& options, double distance);

/// A cushion on bodies and on the walls of the box that keeps cloth out of them: a marker nearer than d0 is pushed
/// along the outward normal with the force per undeformed area
///   P0 s^2,  s = (d0 - Phi)/d0 > 0,      energy P0 d0/3 s^3,      stiffness 2 P0/d0 s n n^T
/// or, with the law of the barrier between cloths (contact/barrier_function.hpp),
///   -P0 b'(Phi/d0),                      energy P0 d0 b,          stiffness P0/d0 b'' n n^T
/// which below d0/10, where a moving body may have a marker before the step is solved for, goes on with the same
/// stiffness. No-slip alone lets markers drift into the staircase of the sharp mask. In a step Phi is linear about
/// where the marker starts, with the bodies at the step's end: so the energy is convex, and its stiffness exact and
/// never negative. Friction is that of the barrier between cloths (contact/friction.hpp), with the normal force of the
/// step's start, over the way that the surface goes in the step.
template <int Dim>
class Cushion : public ContactForce<Dim> {
 public:
  Cushion(const CushionOptions& options, const Surroundings<Dim>& surroundings);
  /// Makes nothing if there is no pressure.
  static MakeForce<Dim> maker(const CushionOptions& options);

  Dependence dependence() const override { return Dependence::potential; }
  std::string origin() const override { return "-contact_pressure"; }
  bool rubs() const override { return options_.friction > 0; }
  void begin_step(const StepStart<Dim>& start) override;
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
  void add_energy(const Points<Dim>& positions, std::span<double> of_groups) const override;
  void add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction, Points<Dim>& rates) const override;
  void visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                       const AddMarkerBlock<Dim>& add) const override;
  void add_bound(std::span<StiffnessBound> bounds) const override;
  void linearise(const Points<Dim>& positions) override { friction_.linearise(ways(positions)); }
  bool is_with_bodies() const override { return true; }
  void add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const override;
  void add_reactions(const Points<Dim>& positions, ContactLoads<Dim>& loads) const override;

 private:
  /// The tangent plane of a surface near a marker: of a body, or of a side of the box.
  struct Plane {
    std::size_t marker;
    Point<Dim> start, normal;  ///< where the marker starts [m]; out of the body
    double distance;           ///< there, at the step's end [m]
    std::size_t body;          ///< its number; that of the bodies for a side
    int axis = 0;
    End end = End::lower;
  };
  void find_bodies(const PosedBodies<Dim>& posed, std::size_t marker, const Point<Dim>& start, double reach);
  void find_sides(std::size_t marker, const Point<Dim>& start, double reach);
  void begin_friction(const StepStart<Dim>& start);
  Point<Dim> velocity_of_surface(const Plane& plane, double time) const;
  Points<Dim> ways(const Points<Dim>& positions) const;
  template <class Visit>
  void visit_rubs(const Points<Dim>& positions, const Visit& visit) const;
  Point<Dim> middle() const { return 0.5 * (around_.grid.lower() + around_.grid.upper()); }
  void add_reaction(const Plane& plane, const Points<Dim>& positions, const Point<Dim>& reaction,
                    ContactLoads<Dim>& loads) const;
  CushionPush push(const Plane& plane, const Points<Dim>& positions) const;
  Point<Dim> force(const Plane& plane, const Points<Dim>& positions) const;

  CushionOptions options_;
  Surroundings<Dim> around_;
  double time_ = 0;  ///< the step's end [s]
  std::vector<Plane> planes_;
  /// A marker that rubs on a plane in this step.
  struct Rubbing {
    Plane plane;
    Point<Dim> way;  ///< of the surface in the step, of an explicit one over its marker [m]
  };
  std::vector<Rubbing> rubbing_;
  Friction<Dim> friction_;
};

extern template class Cushion<2>;
extern template class Cushion<3>;

}  // namespace washfsi
