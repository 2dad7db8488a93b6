// SPDX-License-Identifier: BSD-3-Clause
//
// The driving force of water along the periodic axes of a box, where the pressure that is solved for has no mean
// gradient: the uniform force density -G_c, with G the gradient of the mean pressure. Along an axis with the bulk
// velocity u_bulk, G is such that the mean <u_c> over the box has this value:
//   df_c = (u_bulk,c - <u*_c>) / <H dt / rho>,    u*_c += df_c H dt / rho,    G_c^(n+1/2) = G_c^(n-1/2) - df_c
// after the momentum solve, which uses G^(n-1/2). A step adds only the change of G, so in a steady flow no part of the
// force bypasses the implicit friction. The first step adds all of it, and may so start water from rest at once.
//
// Water that slides inside bodies would pass the force on to the water before their walls. So the bodies take the force
// on their share of the faces.
#pragma once

#include "washfsi/grid/grid.hpp"
#include "washfsi/support/options.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

template <int Dim>
struct DrivingOptions {
  Point<Dim> pressure_gradient = Point<Dim>::Zero();  ///< mean gradient; negative drives forwards [Pa/m]
  Point<Dim> bulk_velocity = Point<Dim>::Zero();      ///< prescribed along each axis where it is not 0 [m/s]

  static DrivingOptions from_options(Options& options);
};

template <int Dim>
class Driving {
 public:
  /// Errors: InputError where an axis is driven that is not periodic, or driven twice.
  Driving(const Grid<Dim>& grid, const DrivingOptions<Dim>& options);

  /// Whether it drives along an axis, and whether there it keeps the bulk velocity.
  bool drives(int axis) const { return options_.pressure_gradient[axis] != 0 || keeps_bulk(axis); }
  bool keeps_bulk(int axis) const { return options_.bulk_velocity[axis] != 0; }
  bool is_there() const;

  /// Begins the trial of a step and returns G for the momentum solve [Pa/m].
  const Point<Dim>& begin_trial();
  /// Adds G (1 - share) to a force density on faces [N/m3]: the reaction of bodies on their share, which is not driven.
  void add_reaction_of_undriven(Vec driven_share, Vec force) const;
  /// Gives u* its bulk velocity. `driven_share` is H on faces; null for 1 everywhere. Collective.
  void keep_bulk(double dt, Vec density, Vec driven_share, Vec velocity);
  /// Accepts the trial. The first step's G is not used as guess of the next one's.
  void accept(bool is_first);

  /// G of the step that was tried last [Pa/m].
  const Point<Dim>& gradient() const { return gradient_; }
  /// Registers the guess of the next G. With other driving options than before it starts without.
  void register_state(StateList& state);

 private:
  const Grid<Dim>& grid_;
  DrivingOptions<Dim> options_;
  Point<Dim> guess_, gradient_;
};

/// Mean of the components of a global velocity over the box's faces, sides at the lower ends included. With a share of
/// each face, the mean of the velocity times it. Collective.
template <int Dim>
Point<Dim> mean_velocity(const Grid<Dim>& grid, Vec velocity, Vec share = nullptr);

extern template struct DrivingOptions<2>;
extern template struct DrivingOptions<3>;
extern template class Driving<2>;
extern template class Driving<3>;

}  // namespace washfsi
