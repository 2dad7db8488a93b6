// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/viscous_stress.hpp"
#include "washfsi/motion/body.hpp"
#include "washfsi/motion/load.hpp"

namespace washfsi {

/// Loads of water and cloth on bodies from the balance of momentum in the water round each (4.3-10). In place of a box
/// with sharp edges there is a smooth weight w, 1 on the body and 0 some cells away or at the next wall:
///   load = sum over cells  dx f_w  +  sum over faces  dx [ (1 - H) rho a_solid - w (rho du/dt - f) ]
///   f_w  = rho u (u . grad w) + p grad w - mu (grad u + grad u^T) grad w
/// with u and p in the middle of the step and dx the volume of a cell. The torque has the cross products with the arms.
/// Nothing is evaluated at the wall, so the noise of its staircase does not enter. This checks the loads that follow
/// from the constraint force (`mask_loads.hpp`).
template <int Dim>
class ControlVolumes {
 public:
  ControlVolumes(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies);

  /// The fields for the balance over a step, on faces except for the pressure.
  struct Step {
    Vec velocity_before, velocity, pressure;  ///< u^n, u^(n+1) [m/s], p^(n+1/2) [Pa]
    Vec density, force;                       ///< rho [kg/m3], f [N/m3]
    Vec fluid_fraction;                       ///< H
    Viscosity viscosity;
    double time, dt;  ///< the step's end and length [s]
    /// Gradient of the mean pressure, which is neither in `pressure` nor as a force in `force` [Pa/m].
    Point<Dim> mean_gradient = Point<Dim>::Zero();
  };
  /// Returns one load per body. Collective.
  Loads<Dim> loads(const Step& step);

 private:
  void weigh(const PosedBodies<Dim>& posed, std::size_t body, Vec weight) const;
  double weight_at(const PosedBodies<Dim>& posed, std::size_t body, const Point<Dim>& place) const;
  double distance_to_sides(const Point<Dim>& place) const;
  template <class Form>
  void add_stress(const Step& step, const Form& viscosity, Vec weight, Vec local_velocity, const PosedBody<Dim>& body,
                  Load<Dim>& load) const;
  void add_inertia(const Step& step, Vec weight, const PosedBody<Dim>& body, Load<Dim>& load) const;

  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  const std::vector<Body<Dim>>& bodies_;
  bool all_at_rest_;
  /// The layer round each body in which its weight falls ends before the middle of the way to an image [m].
  std::vector<double> widths_;
  std::vector<petsc::Vector> weights_;  ///< weight w of each body, in cells, local
  petsc::Vector mean_velocity_;
};

extern template class ControlVolumes<2>;
extern template class ControlVolumes<3>;

}  // namespace washfsi
