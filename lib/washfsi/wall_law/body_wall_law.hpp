// SPDX-License-Identifier: BSD-3-Clause
//
// The friction of bodies whose walls have markers, where the wall layer is thinner than a cell. As at the box's sides
// (`wall_model.hpp`) it follows the law of the wall; here it acts as a force on the water before the walls. At points
// on the surface, on both faces of thin parts, with y the distance from it in cells and u along it relative to the
// body:
//   1. u(3), u(0)    filtered over T = y/|u|, y = 3: longer ones would not follow an agitator's strokes
//   2. u_tau         of Reichardt's law for u(3)
//   3. F             = -rho u_tau^2 A u/|u| on the water, spread by the delta round y = 3/2, so that nearly all acts
//                    before the wall; A the point's area
//   4. markers       constrain only the velocity along the normal where the law applies
//   5. inner water   the constrained water behind the walls slides along them by u(0), and from a cell behind them on
//                    the viscosity is rho h^2/(4 dt)
// Because of 5 the force of 3 is all of the friction. Were the inner water at rest, the wall would be a shear layer one
// cell thick, which has numerical friction where it crosses the grid at an angle a: u = f(n) along it has a divergence
// of f''' h^2/24 cos a sin a (cos^2 a - sin^2 a) on the faces, and the flow by which the pressure removes that goes
// through the wall. And inner water of the usual viscosity would be as turbulent as that outside and let eddies
// through. Where y+ of u(3) is 5 or less nothing is changed; from 6 on the law applies fully, patch by patch. The
// transition is narrow, since markers that constrain a part of a velocity constrain all of it: their solver iterates
// until no slip is left. The faces of a sheet share its markers: these allow sliding where the water passes either face
// fast enough, and the law then applies to both.
#pragma once

#include "washfsi/fluid/wall_viscosity.hpp"
#include "washfsi/motion/load.hpp"
#include "washfsi/wall_law/filtered_velocities.hpp"
#include "washfsi/wall_law/placed_points.hpp"

namespace washfsi {

/// How the water slides along a patch of markers.
struct PatchSlide {
  double part = 0;    ///< share of the law of friction, from 0 (no slip) to 1
  double passes = 0;  ///< cells that the water passes in a step, times `part`
};

template <int Dim>
class BodyWallLaw : public WallViscosity {
 public:
  /// `markers` are those of the bodies' walls. Collective.
  BodyWallLaw(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
              const BodyMarkers<Dim>& markers);

  void observe(const StepFlow& flow, const PureLiquid& liquid) override;
  void replace(Vec viscosity) const override;
  /// Adds the friction to the force on the water [N/m3], on faces. Collective.
  void add_friction(Vec force) const;
  /// Adds the slip of the inner water to the velocity of the bodies [m/s], on the faces behind their walls where the
  /// fluid fraction is below 1. Collective.
  void add_inner_slip(Vec fluid_fraction, Vec velocity) const;

  /// The friction of the water on this rank's part of each body, about its centre.
  Loads<Dim> loads_here() const;
  /// The power that the water lost to friction over a step to `time`, with the velocities before and now [W; W/m in the
  /// plane]. Collective.
  double dissipation(Vec velocity_before, Vec velocity, double time) const;

  /// The largest y+ at half a cell from each body, from the law at y = 3; 0 where it does not apply. Collective.
  std::vector<double> largest_y_plus() const;

  /// Outward normals at the patches of markers, of one face where two share a patch, in the bodies' frames: where the
  /// law applies, only the velocity along the normal is constrained. Zero in corners, which have no point.
  const Points<Dim>& patch_normals() const { return patch_normals_; }
  const std::vector<PatchSlide>& patch_slides() const { return patch_slides_; }  ///< for all ranks' patches

  std::size_t point_count() const { return points_.count(); }  ///< number of points on all ranks
  /// Registers the filtered velocities of the points. With other bodies the filter starts with the next flow.
  void register_state(StateList& state);

 private:
  BodyWallLaw(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
              std::size_t patches, const std::vector<WallPoint<Dim>>& all);
  void apply_friction(std::size_t point, const PureLiquid& liquid);
  void tell_patches(double step);

  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  const std::vector<Body<Dim>>& bodies_;
  PlacedPoints<Dim> points_;
  Points<Dim> patch_normals_;
  std::vector<PatchSlide> patch_slides_;
  FilteredVelocities<Dim> filtered_;  ///< u(3), u(0) of each point, in its body's frame
  Points<Dim> forces_, slips_;        ///< F [N], and slips of the inner water [m/s]
  petsc::Vector friction_;            ///< density of F on faces [N/m3]
  std::vector<double> y_plus_;        ///< y+ at the matching place
  double turbulent_ = 0;              ///< share of the points at which the law applies
  double inner_viscosity_ = 0;        ///< viscosity of the inner water [Pa s]
  Vec fluid_share_ = nullptr;         ///< fluid share of the flow observed last
  bool observes_ = false;             ///< whether this run has observed a flow
};

extern template class BodyWallLaw<2>;
extern template class BodyWallLaw<3>;

}  // namespace washfsi
