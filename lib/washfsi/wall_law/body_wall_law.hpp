// SPDX-License-Identifier: BSD-3-Clause
//
// The friction of bodies that markers hold, where the wall layer is thinner than a cell. As at the box's sides
// (`wall_model.hpp`) it is that of the law of the wall; here it acts as a force on the water before the walls. At
// points on the surface, on both faces of thin parts, y from it in cells and u along it relative to the body:
//   1. u(3), u(0)    filtered over T = y/|u|, y = 3: longer ones would not follow an agitator's strokes
//   2. u_tau         of Reichardt's law for u(3)
//   3. F             = -rho u_tau^2 A u/|u| on the water, spread by the delta round y = 3/2, so that nearly all acts
//                    before the wall; A the point's area
//   4. markers       hold only the velocity along the normal where the law holds
//   5. inner water   what is held behind the walls slides along them by u(0), and from a cell on behind them the
//                    viscosity is rho h^2/(4 dt)
// The last is what makes 3 all of the friction. Were the inner water at rest, the wall would be a layer of shear as
// thin as a cell, which rubs by itself where it crosses the grid at an angle a: u = f(n) along it has a divergence of
// f''' h^2/24 cos a sin a (cos^2 a - sin^2 a) on the faces, and what the pressure makes of that goes through the wall.
// And water inside with a viscosity of its own would be as turbulent as that outside, and let eddies through.
// Where y+ of u(3) is 5 or less nothing is changed; from 6 on all is, patch by patch. The step is narrow, since
// markers that hold a part of a velocity hold all of it: their solver goes on until no slip is left. The faces of a
// sheet share its markers: these let go where the water passes either of them fast enough, and both rub by the law.
#pragma once

#include "washfsi/fluid/wall_viscosity.hpp"
#include "washfsi/immersed_boundary/transfer.hpp"
#include "washfsi/motion/load.hpp"
#include "washfsi/support/state_list.hpp"
#include "washfsi/wall_law/wall_points.hpp"

namespace washfsi {

/// How the water slides along a patch of markers.
struct PatchSlide {
  double part = 0;    ///< by how much the law holds, from 0 to 1
  double passes = 0;  ///< how many cells it passes in a step, times `part`
};

template <int Dim>
class BodyWallLaw : public WallViscosity {
 public:
  /// The markers are those that hold the bodies. Collective.
  BodyWallLaw(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
              const BodyMarkers<Dim>& markers);

  void observe(const StepFlow& flow, const PureLiquid& liquid) override;
  void replace(Vec viscosity) const override;
  /// Adds the friction to the force on the water [N/m3], on faces. Collective.
  void add_friction(Vec force) const;
  /// Adds what the inner water slides by to the velocity of the bodies [m/s], on the faces behind their walls where the
  /// fraction of fluid is not 1. Collective.
  void add_inner_slip(Vec fluid_fraction, Vec velocity) const;

  /// The friction of the water on this rank's part of each body, about its centre.
  Loads<Dim> loads_here() const;
  /// The power that the water lost to it over a step to `time`, with the velocities before and now [W; W/m in the
  /// plane]. Collective.
  double dissipation(Vec velocity_before, Vec velocity, double time) const;

  /// The largest y+ of half a cell from each body, by the law at 3; 0 where it does not hold. Collective.
  std::vector<double> largest_y_plus() const;

  /// Out of the surface at each patch of markers, or of one face where two share it, in its body's frame: where the law
  /// holds, only the water's velocity along it is to be held. Zero in corners, where there is no point.
  const Points<Dim>& patch_normals() const { return patch_normals_; }
  const std::vector<PatchSlide>& patch_slides() const { return patch_slides_; }  ///< of all ranks' patches

  std::size_t point_count() const { return count_; }  ///< of all ranks
  /// Registers the filtered velocities of the points. With other bodies the next flow is taken as it is.
  void register_state(StateList& state);

 private:
  void place();
  bool is_free(const PosedBodies<Dim>& posed, const WallPoint<Dim>& point, const Point<Dim>& place) const;
  Points<Dim> speeds_along(Vec local_velocity, double distance) const;
  Points<Dim> turned(Points<Dim> values, bool into_space) const;
  void filter(std::size_t point, const Point<Dim>& near, const Point<Dim>& far, double dt);
  void apply_friction(std::size_t point, const PureLiquid& liquid);
  void tell_patches(double step);

  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  const std::vector<Body<Dim>>& bodies_;
  std::vector<WallPoint<Dim>> points_;  ///< of this rank
  std::size_t count_, begin_;
  Points<Dim> patch_normals_;
  Transfer<Dim> transfer_, inner_;  ///< round y = 3/2; behind the walls
  Points<Dim> places_, normals_;    ///< of the points now: y = 3/2; out of the surface
  std::vector<char> acts_;          ///< false where something is too near
  Points<Dim> forces_, slips_;      ///< F [N], and what the inner water slides by
  petsc::Vector friction_;          ///< the density of F on faces [N/m3]
  std::vector<double> covers_;      ///< what each point covers of the inner water; 0 beyond the box
  std::vector<double> y_plus_;      ///< of the matching place
  static constexpr std::size_t of_each = 2;
  Points<Dim> filtered_;  ///< of each point: u(3), u(0), in its body's frame
  std::vector<PatchSlide> patch_slides_;
  std::vector<std::size_t> faces_;  ///< of this rank's points: twice the patch, and 1 more on a sheet's other face
  double turbulent_ = 0;            ///< part of the points at which the law holds
  double inner_viscosity_ = 0;      ///< [Pa s]
  double time_ = 0;                 ///< of `observe` [s]
  std::vector<typename RigidMotion<Dim>::State> motions_;  ///< of the bodies then
  Vec fluid_share_ = nullptr;                              ///< of the flow seen last
  bool begun_ = false;                                     ///< what is filtered is an earlier flow
  bool observes_ = false;                                  ///< this run has seen one
};

extern template class BodyWallLaw<2>;
extern template class BodyWallLaw<3>;

}  // namespace washfsi
