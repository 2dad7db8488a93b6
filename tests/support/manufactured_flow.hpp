// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdio>
#include <functional>

#include "support/water.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {

/// A flow known in closed form: velocity [m/s] and pressure [Pa] at a place and time, and its liquid.
template <int Dim>
struct ExactFlow {
  double density = 1, viscosity = 0.05;
  std::function<double(const Point<Dim>&, double)> variable_density;  ///< if set, instead of `density` [kg/m3]
  std::function<double(const Point<Dim>&)> variable_viscosity;        ///< if set, instead of `viscosity` [Pa s]
  std::function<Point<Dim>(const Point<Dim>&, double)> velocity;
  std::function<double(const Point<Dim>&, double)> pressure;

  /// The force density that makes it a solution: rho (du/dt + u.grad u) + grad p - mu lap u -
  /// (grad u + grad u^T) grad mu, by fourth-order differences.
  Point<Dim> force(const Point<Dim>& x, double t) const {
    constexpr double s = 1e-3;
    const auto first = [&](auto&& f) { return ((8.0 * (f(s) - f(-s)) - (f(2 * s) - f(-2 * s))) / (12 * s)).eval(); };
    Point<Dim> result = first([&](double e) { return velocity(x, t + e); });
    const Point<Dim> u = velocity(x, t);
    Point<Dim> laplacian = Point<Dim>::Zero(), gradient, viscosity_gradient;
    Eigen::Matrix<double, Dim, Dim> velocity_gradient;
    for (int d = 0; d < Dim; ++d) {
      const Point<Dim> axis = Point<Dim>::Unit(d);
      const auto along = [&](double e) { return velocity(x + e * axis, t); };
      velocity_gradient.col(d) = first(along);
      result += u[d] * velocity_gradient.col(d);
      laplacian += (-along(2 * s) - along(-2 * s) + 16 * (along(s) + along(-s)) - 30 * u) / (12 * s * s);
      gradient[d] = first([&](double e) { return Eigen::Matrix<double, 1, 1>(pressure(x + e * axis, t)); })[0];
      viscosity_gradient[d] =
          first([&](double e) { return Eigen::Matrix<double, 1, 1>(viscosity_at(x + e * axis)); })[0];
    }
    return density_at(x, t) * result + gradient - viscosity_at(x) * laplacian -
           (velocity_gradient + velocity_gradient.transpose()) * viscosity_gradient;
  }

  double density_at(const Point<Dim>& x, double t) const { return variable_density ? variable_density(x, t) : density; }
  double viscosity_at(const Point<Dim>& x) const { return variable_viscosity ? variable_viscosity(x) : viscosity; }
};

/// A viscosity that is what a function of the place says [Pa s].
template <int Dim>
class GivenViscosity : public ViscosityModel<Dim> {
 public:
  explicit GivenViscosity(std::function<double(const Point<Dim>&)> at) : at_(std::move(at)) {}

  void add(const Grid<Dim>& grid, const ConstFaceView<Dim>&, const PureLiquid&, const CellShare<Dim>&,
           const CellView<Dim>& viscosity) const override {
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) { viscosity(cell) += at_(grid.cell_center(cell)); });
  }

 private:
  std::function<double(const Point<Dim>&)> at_;
};

/// Distance of a computed flow from the exact one: max and rms norms of velocity and pressure.
struct FlowError {
  double velocity_max = 0, velocity_rms = 0, pressure_max = 0, pressure_rms = 0;
};

inline double order(double coarse, double fine, double ratio = 2) {
  return std::log(coarse / fine) / std::log(ratio);
}

/// Prints the errors on two grids and the orders between them, a row of docs/validation/order.md.
inline void report(const char* name, const FlowError& coarse, const FlowError& fine) {
  if (rank_of(PETSC_COMM_WORLD) != 0) return;
  const auto print = [&](const char* norm, double a, double b) {
    std::printf("%-24s %-14s %.3e  %.3e  order %.2f\n", name, norm, a, b, order(a, b));
  };
  print("u max", coarse.velocity_max, fine.velocity_max);
  print("u rms", coarse.velocity_rms, fine.velocity_rms);
  print("p max", coarse.pressure_max, fine.pressure_max);
  print("p rms", coarse.pressure_rms, fine.pressure_rms);
}

/// Advances an exact flow and compares at the end.
template <int Dim>
class ManufacturedRun {
 public:
  ManufacturedRun(ExactFlow<Dim> exact, const GridShape<Dim>& shape, typename Boundary<Dim>::Sides sides, bool forced,
                  const std::string& advection = "central")
      : exact_(std::move(exact)),
        grid_(PETSC_COMM_WORLD, shape),
        boundary_(grid_, std::move(sides)),
        water_(grid_, boundary_, options(advection)),
        forced_(forced) {}

  FlowError advance(double dt, int steps) {
    set_exact_start(dt);
    take_steps(dt, steps);
    return error(dt);
  }

  /// Pairs of steps of 4/3 and 2/3 dt, without forces.
  FlowError advance_unequally(double dt, int pairs) {
    set_exact_start(4 * dt / 3);
    set_density(water_.liquid.density(), 0);
    for (int n = 0; n < pairs; ++n) {
      water_.advance(4 * dt / 3);
      water_.advance(2 * dt / 3);
    }
    return error(2 * dt / 3);
  }

  /// Velocity and pressure at the end of so many steps, the pressure extrapolated to the same time.
  std::pair<petsc::Vector, petsc::Vector> final_state(double dt, int steps) {
    const petsc::Vector before = grid_.cell_vector();
    (void)advance(dt, steps - 1);
    WASH_PETSC(VecCopy(water_.fluid.projection().pressure(), before));
    take_steps(dt, 1);
    petsc::Vector velocity = grid_.face_vector(), pressure = grid_.cell_vector();
    WASH_PETSC(VecCopy(water_.fluid.velocity(), velocity));
    WASH_PETSC(VecCopy(water_.fluid.projection().pressure(), pressure));
    WASH_PETSC(VecAXPBY(pressure, -0.5, 1.5, before));
    return {std::move(velocity), std::move(pressure)};
  }

  FractionalStep<Dim>& fluid() { return water_.fluid; }
  const Grid<Dim>& grid() const { return grid_; }

 private:
  FluidOptions<Dim> options(const std::string& advection) const {
    FluidOptions<Dim> options;
    options.advection = advection;
    options.density = exact_.density;
    options.viscosity = exact_.variable_viscosity ? 0 : exact_.viscosity;
    if (exact_.variable_viscosity)
      options.viscosity_models.push_back(std::make_shared<GivenViscosity<Dim>>(exact_.variable_viscosity));
    options.momentum_tolerance = 1e-12;
    options.pressure_tolerance = 1e-10;
    return options;
  }

  void set_exact_start(double dt) {
    const FaceView<Dim> u(grid_.face_dm(), water_.fluid.velocity());
    const CellView<Dim> p(grid_.cell_dm(), water_.fluid.projection().pressure());
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
      for (int c = 0; c < Dim; ++c) u(cell, c) = exact_.velocity(grid_.face_center(cell, c), 0)[c];
      p(cell) = exact_.pressure(grid_.cell_center(cell), -dt / 2);
    });
  }

  void take_steps(double dt, int steps) {
    for (int n = 0; n < steps; ++n) {
      set_density(water_.liquid.density(), water_.clock.time + dt / 2);
      if (forced_) set_force(water_.force, water_.clock.time + dt / 2);
      water_.advance(dt);
    }
  }

  void set_density(Vec density, double time) {
    const FaceView<Dim> rho(grid_.face_dm(), density);
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
      for (int c = 0; c < Dim; ++c) rho(cell, c) = exact_.density_at(grid_.face_center(cell, c), time);
    });
  }

  void set_force(Vec force, double time) {
    const FaceView<Dim> f(grid_.face_dm(), force);
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
      for (int c = 0; c < Dim; ++c) f(cell, c) = exact_.force(grid_.face_center(cell, c), time)[c];
    });
  }

  FlowError error(double dt) {
    const ConstFaceView<Dim> u(grid_.face_dm(), water_.fluid.velocity());
    const ConstCellView<Dim> p(grid_.cell_dm(), water_.fluid.projection().pressure());
    const double time = water_.clock.time, count = grid_.cell_count();
    double offset = 0;
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
      offset += p(cell) - exact_.pressure(grid_.cell_center(cell), time - dt / 2);
    });
    offset = ordered_sum(grid_.comm(), offset) / count;
    FlowError error;
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
      for (int c = 0; c < Dim; ++c) {
        const double e = u(cell, c) - exact_.velocity(grid_.face_center(cell, c), time)[c];
        error.velocity_max = std::max(error.velocity_max, std::abs(e));
        error.velocity_rms += e * e;
      }
      const double e = p(cell) - exact_.pressure(grid_.cell_center(cell), time - dt / 2) - offset;
      error.pressure_max = std::max(error.pressure_max, std::abs(e));
      error.pressure_rms += e * e;
    });
    error.velocity_max = largest(grid_.comm(), error.velocity_max);
    error.pressure_max = largest(grid_.comm(), error.pressure_max);
    error.velocity_rms = std::sqrt(ordered_sum(grid_.comm(), error.velocity_rms) / count);
    error.pressure_rms = std::sqrt(ordered_sum(grid_.comm(), error.pressure_rms) / count);
    return error;
  }

  ExactFlow<Dim> exact_;
  Grid<Dim> grid_;
  Boundary<Dim> boundary_;
  Water<Dim> water_;
  bool forced_;
};

}  // namespace washfsi::test
