// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>

#include "support/gather.hpp"
#include "support/water.hpp"
#include "washfsi/mask/control_volume.hpp"
#include "washfsi/mask/mask_loads.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/wall_forces/marker_loads.hpp"
#include "washfsi/wall_forces/water_step.hpp"

namespace washfsi::test {

/// The circular Couette flow of thesis 4.3.1 between two turning cylinders, Re = 131, w_i/w_o = 6.13, r_i/r_o = 0.34,
/// in a box of 2.83 r_o, started from the exact field. The outer cylinder fills the box, whose walls turn with it.
class CircularCouette {
 public:
  static constexpr double ro = 1, ri = 0.34, wo = 1, wi = 6.13, half_box = 0.5 * 2.83;
  static constexpr double viscosity = wo * ro * (ro - ri) / 131;

  struct Errors {
    double rms = 0, max = 0;                      ///< of |u_theta - exact| / exact at cell centres in fluid
    double rms_away = 0;                          ///< of those farther than two cells from the walls
    double inner_torque = 0, outer_torque = 0;    ///< computed over exact
    double inner_balance = 0, outer_balance = 0;  ///< the same by the balance of momentum
  };

  /// `shift`: of the cylinders' centre within a cell, in cells.
  CircularCouette(PetscInt n, const Point<2>& shift, const BodyTreatment& treatment, MPI_Comm comm = PETSC_COMM_WORLD)
      : center_(shift * 2 * half_box / static_cast<double>(n)),
        bodies_(cylinders(center_)),
        grid_(comm, shape(n)),
        boundary_(grid_, turning_walls(center_)),
        water_(grid_, boundary_, liquid()),
        mask_(grid_, bodies_, treatment),
        control_volumes_(grid_, boundary_, bodies_) {
    if (treatment.method == BodyMethod::direct_forcing)
      walls_ = std::make_unique<WallForces<2>>(grid_, boundary_, bodies_, treatment);
    const FaceView<2> u(grid_.face_dm(), water_.fluid.velocity());
    for (int c = 0; c < 2; ++c)
      for_each<2>(grid_.owned(), [&](const Index<2>& face) {
        const Point<2> arm = grid_.face_center(face, c) - center_;
        u(face, c) = exact(arm.norm()) / std::max(arm.norm(), 1e-12) * (c == 0 ? -arm[1] : arm[0]);
      });
  }

  Errors run(double time, double courant) {
    const double dt = courant * grid_.spacing()[0] / (wi * ri);
    const int steps = static_cast<int>(std::ceil(time / dt));
    for (int n = 0; n < steps; ++n) {
      mask_.update(water_.clock.time + dt);
      if (walls_) walls_->place(water_.clock.time + dt);
      extrapolate(dt);
      WaterStep<2>(water_.fluid, walls_.get())
          .advance(water_.clock.next(dt), {water_.liquid.fields(), water_.force, mask_.constraint()});
      water_.clock.advance(dt);
    }
    return errors(dt);
  }

  /// The velocity on every rank of the world.
  std::vector<double> velocity(bool everywhere) const {
    return gather<2, 2>(grid_, grid_.face_dm(), water_.fluid.velocity(), everywhere);
  }

 private:
  static double exact(double r) {
    if (r < ri) return wi * r;
    if (r > ro) return wo * r;
    const double b = (wi - wo) * ri * ri * ro * ro / (ro * ro - ri * ri);
    const double a = (wo * ro * ro - wi * ri * ri) / (ro * ro - ri * ri);
    return a * r + b / r;
  }
  static std::vector<Body<2>> cylinders(const Point<2>& center) {
    std::vector<Body<2>> bodies(2);
    bodies[0].shape = std::make_unique<Inverted<2>>(std::make_unique<Sphere<2>>(ro));
    bodies[0].motion.center = center;
    bodies[0].motion.angular_speed = wo;
    bodies[1].shape = std::make_unique<Sphere<2>>(ri);
    bodies[1].motion.center = center;
    bodies[1].motion.angular_speed = wi;
    return bodies;
  }
  static Boundary<2>::Sides turning_walls(const Point<2>& center) {
    Boundary<2>::Sides sides;
    for (auto& axis : sides)
      for (auto& side : axis)
        side.motion = [center](const Point<2>& x, double) -> Point<2> {
          return {-wo * (x[1] - center[1]), wo * (x[0] - center[0])};
        };
    return sides;
  }
  static GridShape<2> shape(PetscInt n) {
    GridShape<2> shape;
    shape.cells = {n, n};
    shape.lower = {-half_box, -half_box};
    shape.upper = {half_box, half_box};
    return shape;
  }
  static FluidOptions<2> liquid() {
    FluidOptions<2> options;
    options.density = 1;
    options.viscosity = viscosity;
    return options;
  }

  void extrapolate(double dt) {
    const GhostedVelocity<2> local = water_.ghosted(grid_.wide_face_dm());
    mask_.extrapolate(local, water_.clock.time + dt);
  }

  Errors errors(double dt) {
    const GhostedVelocity<2> local = water_.ghosted(grid_.face_dm());
    const ConstFaceView<2> u(grid_.face_dm(), local);
    double sum = 0, count = 0, sum_away = 0, count_away = 0, worst = 0;
    for_each<2>(grid_.owned(), [&](const Index<2>& cell) {
      const Point<2> arm = grid_.cell_center(cell) - center_;
      const double r = arm.norm();
      if (r <= ri || r >= ro) return;
      const double ux = 0.5 * (u(cell, 0) + u(shifted<2>(cell, 0, 1), 0));
      const double uy = 0.5 * (u(cell, 1) + u(shifted<2>(cell, 1, 1), 1));
      const double error = std::abs((arm[0] * uy - arm[1] * ux) / r - exact(r)) / exact(r);
      sum += error * error;
      count += 1;
      if (std::min(r - ri, ro - r) > 2 * grid_.spacing()[0]) {
        sum_away += error * error;
        count_away += 1;
      }
      worst = std::max(worst, error);
    });
    const double torque = 4 * std::numbers::pi * viscosity * (wi - wo) * ri * ri * ro * ro / (ro * ro - ri * ri);
    const double middle = water_.clock.time - 0.5 * dt;
    auto loads = constraint_loads(mask_, water_.fluid.constraint_force(), water_.liquid.density(),
                                  water_.fluid.projection().pressure(), middle);
    const auto of_markers = walls_ ? marker_loads(*walls_) : Loads<2>(loads.size());
    for (std::size_t b = 0; b < loads.size(); ++b) loads[b] += of_markers[b];
    const auto balance = control_volumes_.loads({water_.fluid.velocity_before(),
                                                 water_.fluid.velocity(),
                                                 water_.fluid.projection().pressure(),
                                                 water_.liquid.density(),
                                                 water_.force,
                                                 mask_.fluid_share(),
                                                 {viscosity},
                                                 water_.clock.time,
                                                 dt});
    return {std::sqrt(ordered_sum(grid_.comm(), sum) / ordered_sum(grid_.comm(), count)),
            largest(grid_.comm(), worst),
            std::sqrt(ordered_sum(grid_.comm(), sum_away) / ordered_sum(grid_.comm(), count_away)),
            -loads[1].torque[0] / torque,
            loads[0].torque[0] / torque,
            -balance[1].torque[0] / torque,
            balance[0].torque[0] / torque};
  }

  Point<2> center_;
  std::vector<Body<2>> bodies_;
  Grid<2> grid_;
  Boundary<2> boundary_;
  Water<2> water_;
  Mask<2> mask_;
  ControlVolumes<2> control_volumes_;
  std::unique_ptr<WallForces<2>> walls_;
};

}  // namespace washfsi::test
