// SPDX-License-Identifier: BSD-3-Clause
//
// What drives water along the periodic axes of a box, where the pressure that is solved for has no mean gradient: the
// uniform force density f_c = -G_c, G the gradient of the mean pressure. Along an axis with a given bulk velocity, of
// fluxes rather than forces, G is what keeps the mean of u_c over the box:
//   G^(n+1/2) = G^(n-1/2) - d,    d = (U_c - mean u*_c) / mean(H dt / rho),    u* += d H dt / rho
// after the momentum solve, which takes G^(n-1/2): what a step adds is what changed, so that at rest nothing of the
// force goes round the implicit friction. The first step adds all; it may start water from rest at once.
//
// Water inside bodies behind whose walls it slides would pass the force on to the water before them: their share of
// it the bodies hold.
#pragma once

#include "washfsi/grid/grid.hpp"
#include "washfsi/support/options.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

template <int Dim>
struct DrivingOptions {
  Point<Dim> pressure_gradient = Point<Dim>::Zero();  ///< of the mean pressure; a negative one drives forwards [Pa/m]
  Point<Dim> bulk_velocity = Point<Dim>::Zero();      ///< kept along each axis where it is not 0 [m/s]

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

  /// G that the momentum solve takes; begins the trial of a step [Pa/m].
  const Point<Dim>& begin();
  /// Adds to a force density on faces [N/m3] that by which bodies hold what is not driven: G (1 - share).
  void add_reaction_of_undriven(Vec driven_share, Vec force) const;
  /// Gives u* its bulk velocity. `driven_share`, on faces: H; null for 1 everywhere. Collective.
  void keep_bulk(double dt, Vec density, Vec driven_share, Vec velocity);
  /// Takes the trial. The first step's G is no guess of the next one's.
  void accept(bool is_first);

  /// G of the step that was tried last [Pa/m].
  const Point<Dim>& gradient() const { return gradient_; }
  /// Registers the guess of the next G. What is driven otherwise than before finds it by itself.
  void register_state(StateList& state);

 private:
  const Grid<Dim>& grid_;
  DrivingOptions<Dim> options_;
  Point<Dim> guess_, gradient_;
};

/// Mean of the components of a global velocity over the box, as of its faces; walls are at the lower ones. With a share
/// of each face, that of the velocity times it. Collective.
template <int Dim>
Point<Dim> mean_velocity(const Grid<Dim>& grid, Vec velocity, Vec share = nullptr);

extern template struct DrivingOptions<2>;
extern template struct DrivingOptions<3>;
extern template class Driving<2>;
extern template class Driving<3>;

}  // namespace washfsi
