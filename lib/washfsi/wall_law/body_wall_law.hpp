// SPDX-License-Identifier: BSD-3-Clause
//
// The friction of bodies whose walls have markers, where the wall layer is thinner than a cell. As at the sides of the
// box (`wall_model.hpp`) it follows the law of the wall, but acts as a force on the water before the walls. It is found
// at points on the surface, on both faces of thin parts. y is the distance from the surface along the normal n, h the
// size of a cell along n, and u_t(y) the velocity along the surface relative to the body, in its frame:
//   1. u_bar_t       u_t(3h) and u_t(0), filtered over T = 3h/|u_t(3h)|, which is chosen as at the sides of the box
//   2. u_tau         of Reichardt's law, |u_bar_t(3h)| = u_tau u+(3h u_tau/nu)
//   3. F             = -w rho u_tau^2 A u_bar_t/|u_bar_t| on the water, spread round y = 3/2 h, so that nearly all of
//                    it acts before the wall; A is the area of the point
//   4. markers       constrain the velocity along n, and that along the surface with the share 1 - w
//   5. inner water   the constrained water behind the walls slides along them by w u_bar_t(0), and from a cell behind
//                    them on the viscosity is rho h^2/(4 dt)
// The factor w of a patch (`PatchSlide::part`) rises from 0 where y+ at 3h is 5 or less to 1 where it is 6 or more.
// This range is narrow, since markers that constrain a part of a velocity constrain all of it: their solver iterates
// until no slip is left. The faces of a sheet share its markers, which slide where the water passes either face fast
// enough; both faces then have the friction.
// Because of 5, F is all of the friction. Inner water at rest would make the wall a shear layer one cell thick. Where
// that crosses the grid at an angle theta it has numerical friction: a velocity u(y) along the wall has a divergence of
// h^2/24 u''' cos theta sin theta (cos^2 theta - sin^2 theta) on the faces, and the flow by which the pressure removes
// it goes through the wall. Inner water of the usual viscosity would be as turbulent as that outside, and let eddies
// through.
#pragma once

#include "washfsi/fluid/wall_viscosity.hpp"
#include "washfsi/motion/load.hpp"
#include "washfsi/wall_law/filtered_velocities.hpp"
#include "washfsi/wall_law/placed_points.hpp"

namespace washfsi {

/// How the water slides along a patch of markers.
struct PatchSlide {
  double part = 0;    ///< w, the share of the wall law, from 0 (no slip) to 1
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

  /// The largest y+ at half a cell from each body, from the law at y = 3h; 0 where it does not apply. Collective.
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
  FilteredVelocities<Dim> filtered_;  ///< u_bar_t at 3h and 0 of each point, in its body's frame
  Points<Dim> forces_, slips_;        ///< F [N], and slips w u_bar_t(0) of the inner water [m/s]
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
