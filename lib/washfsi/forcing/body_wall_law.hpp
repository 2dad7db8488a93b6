// SPDX-License-Identifier: BSD-3-Clause
//
// The friction of bodies that markers hold, where the wall layer is thinner than a cell. As at the box's sides
// (`wall_model.hpp`) it is passed on by the water's own viscosity, so that the implicit solve, loads and dissipation
// all have it, whatever moves. At points on the surface, y from it in cells and u relative to the body:
//   1. u(5/2)         filtered over T = y/(0.41 u_tau): outside what the markers' deltas reach, which is 1.65
//   2. u_tau          of Reichardt's law for it
//   3. r              = -2 <u'v'> along the flow, mean of y = 1/2 and 3/2: what eddies that the grid carries take to
//                     the wall, half of which is lost between faces; s = [u(3/2) - u(1/2)]/h; both filtered over 3 T
//   4. mu_wall        = rho (u_tau^2 - r)/s, r taken as 0.8 u_tau^2 at most: the rest of the law's stress
//   5. cells nearer than 5/2 get the mean mu_wall of the points round them, by the delta, with a weight that is 1 up to
//      2 and falls to 0
//   6. within bodies, from a cell on behind the surface, the viscosity is rho h^2/(4 dt): the water there stays at
//      rest with the body. Else it would be as turbulent as that outside, and let eddies through the wall.
//   7. markers of parts that are thicker than two cells hold only the velocity along the normal, by the part of the
//      points at which the law holds: holding all, they would push back the first layer of water before them, by the
//      more the nearer it lies.
// Where y+ of u(5/2) is 5 or less nothing is changed; from 10 on all is.
#pragma once

#include "washfsi/coupling/transfer.hpp"
#include "washfsi/fluid/wall_viscosity.hpp"
#include "washfsi/forcing/wall_points.hpp"

namespace washfsi {

template <int Dim>
class BodyWallLaw : public WallViscosity {
 public:
  /// The markers are those that hold the bodies. Collective.
  BodyWallLaw(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
              const BodyMarkers<Dim>& markers);

  void observe(const StepFlow& flow, const PureLiquid& liquid) override;
  void replace(Vec viscosity) const override;

  /// The largest y+ of half a cell from each body, by the law at 5/2; 0 where it does not hold. Collective.
  std::vector<double> largest_y_plus() const;

  /// Out of the surface at each patch of markers, in its body's frame: where the law holds, only the water's velocity
  /// along it is to be held. Zero where parts are thin, and both faces share the patch.
  const Points<Dim>& patch_normals() const { return patch_normals_; }
  /// The part of the points at which the law holds.
  double part() const { return turbulent_; }

  /// What goes on from step to step, in the bodies' frames: so many of each of this rank's points. They hold a run's
  /// earlier flow after `go_on`; else the next flow is taken as it is.
  static constexpr std::size_t kept_of_each = 5;
  Points<Dim>& kept() { return kept_; }
  const Points<Dim>& kept() const { return kept_; }
  void go_on() { begun_ = true; }
  std::size_t point_count() const { return count_; }  ///< of all ranks
  std::size_t begin() const { return begin_; }        ///< this rank's points
  std::size_t end() const { return begin_ + points_.size(); }

 private:
  /// Velocities relative to the body before each point, in its frame.
  struct Probes {
    Points<Dim> low, high, far;
  };
  void place(double time);
  bool is_free(const PosedBodies<Dim>& posed, const WallPoint<Dim>& point, const Point<Dim>& place) const;
  Points<Dim> relative_velocities(Vec local_velocity, double distance, double time) const;
  Points<Dim> in_bodies_frames(Points<Dim> values, double time) const;
  void filter(std::size_t point, const Probes& seen, double dt, double nu);
  void set_viscosity(std::size_t point, const PureLiquid& liquid);

  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  const std::vector<Body<Dim>>& bodies_;
  std::vector<WallPoint<Dim>> points_;  ///< of this rank
  std::size_t count_, begin_;
  Points<Dim> patch_normals_;
  Transfer<Dim> transfer_;
  Points<Dim> places_, normals_;               ///< of the points now, the places a cell before the surface
  std::vector<char> acts_;                     ///< false where something is too near
  std::vector<double> weights_, viscosities_;  ///< what each point covers, and that times its viscosity
  std::vector<double> y_plus_;                 ///< of the matching place
  Points<Dim> kept_;                           ///< of each point: far, low, high, v u at low, at high
  double turbulent_ = 0;                       ///< part of the points at which the law holds
  double inner_viscosity_ = 0;                 ///< [Pa s]
  Vec fluid_share_ = nullptr;                  ///< of the flow seen last
  bool begun_ = false;
};

extern template class BodyWallLaw<2>;
extern template class BodyWallLaw<3>;

}  // namespace washfsi
