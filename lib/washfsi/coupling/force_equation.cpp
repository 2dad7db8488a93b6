// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/force_equation.hpp"

#include <algorithm>
#include <numeric>

#include "washfsi/coupling/coupling_operations.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/point_vectors.hpp"

namespace washfsi {

// Applies only a share of U, which is 1 in the end.
template <int Dim>
Points<Dim> ForceEquation<Dim>::velocities(const Step& step, double share, const Points<Dim>& change) const {
  return share * step.water_velocities + step.dt * step.mobility.times(change);
}

template <int Dim>
double ForceEquation<Dim>::potential(const Step& step, double share, const Points<Dim>& change) const {
  const Points<Dim> gained = step.dt * step.mobility.times(change);
  const Points<Dim> all = share * step.water_velocities + gained;
  const std::vector<double> energies = step.all.energies(step.start + step.dt * all);
  return 0.5 * dot(step.all.comm(), change, gained) + std::accumulate(energies.begin(), energies.end(), 0.0) / step.dt +
         dot(step.all.comm(), step.forces, all);
}

template <int Dim>
void ForceEquation<Dim>::set_stiffness(const Step& step, const Points<Dim>& places, GeometricStiffness geometric,
                                       Mat matrix) {
  step.all.stiffness().set(places, geometric, 1, matrix);
  if (any_rank(step.all.comm(), pattern_ != step.all.stiffness().pattern())) {
    WASH_PETSC(MatDuplicate(matrix, MAT_COPY_VALUES, stiffness_.put()));
    pattern_ = step.all.stiffness().pattern();
  } else {
    WASH_PETSC(MatCopy(matrix, stiffness_, SAME_NONZERO_PATTERN));
  }
}

template <int Dim>
Points<Dim> ForceEquation<Dim>::residual(const Step& step, double share, const Points<Dim>& all) const {
  return all - velocities(step, share, step.all.of_places(step.start + step.dt * all) - step.forces);
}

template <int Dim>
ClothEquation<Dim> ForceEquation<Dim>::of_velocities(const Step& step, double share) {
  ClothEquation<Dim> equation;
  equation.residual = [=, this](const Points<Dim>& all) { return residual(step, share, all); };
  equation.assemble = [=, this](const Points<Dim>& all, GeometricStiffness geometric, Mat matrix) {
    set_stiffness(step, step.start + step.dt * all, geometric, matrix);
    step.mobility.precondition(step.dt * step.dt, matrix);
  };
  equation.product = [=, this](const Points<Dim>& direction) {
    return direction + step.dt * step.dt * step.mobility.times(product_(stiffness_, direction));
  };
  equation.step_limit = [=](const Points<Dim>& from, const Points<Dim>& way) {
    return step.all.step_limit(step.start + step.dt * from, step.dt * way);
  };
  return equation;
}

template <int Dim>
ClothEquation<Dim> ForceEquation<Dim>::of_forces(const Step& step, double share) {
  const auto places = [=, this](const Points<Dim>& change) {
    return step.start + step.dt * velocities(step, share, change);
  };
  ClothEquation<Dim> equation;
  equation.residual = [=](const Points<Dim>& change) {
    return change - (step.all.of_places(places(change)) - step.forces);
  };
  equation.assemble = [=, this](const Points<Dim>& change, GeometricStiffness geometric, Mat matrix) {
    set_stiffness(step, places(change), geometric, matrix);
    scale_columns_and_shift<Dim>(step.mobility.row_sums(step.dt * step.dt), 1, matrix);
  };
  equation.is_solved = [=](const Points<Dim>& residual) {
    return norm(step.all.comm(), step.dt * step.mobility.times(residual)) <= step.tolerance;
  };
  equation.round_off = 10 * step.all.round_off(step.start);
  equation.potential = [=, this](const Points<Dim>& change) { return potential(step, share, change); };
  equation.product = [=, this](const Points<Dim>& direction) {
    return direction + step.dt * step.dt * product_(stiffness_, step.mobility.times(direction));
  };
  equation.slope = [=](const Points<Dim>& residual, const Points<Dim>& direction) {
    return step.dt * dot(step.all.comm(), step.mobility.times(residual), direction);
  };
  equation.step_limit = [=](const Points<Dim>& change, const Points<Dim>& way) {
    return step.all.step_limit(places(change), step.dt * step.dt * step.mobility.times(way));
  };
  return equation;
}

// Solves from a guess within the step limit: for velocities, or for forces where that fails.
template <int Dim>
void ForceEquation<Dim>::solve_at(const Step& step, double share, Points<Dim>& all, double& iterations) {
  const Points<Dim> guess = all;
  try {
    iterations += static_cast<double>(solver_.solve(of_velocities(step, share), step.tolerance, all));
  } catch (const DivergedError&) {
    all = solved_for_forces(step, share, guess, iterations);
  }
}

template <int Dim>
Points<Dim> ForceEquation<Dim>::solved_for_forces(const Step& step, double share, const Points<Dim>& guess,
                                                  double& iterations) {
  double most = 0;
  for (const double sum : step.mobility.row_sums()) most = std::max(most, sum);
  const double tolerance = step.tolerance / (step.dt * largest(step.all.comm(), most));
  Points<Dim> change = step.all.of_places(step.start + step.dt * guess) - step.forces;
  if (!is_free(step, velocities(step, share, change))) change.assign(change.size(), Point<Dim>::Zero());
  iterations += static_cast<double>(solver_.solve(of_forces(step, share), tolerance, change));
  return velocities(step, share, change);
}

template <int Dim>
bool ForceEquation<Dim>::is_free(const Step& step, const Points<Dim>& all) const {
  return step.all.step_limit(step.start, step.dt * all) == 1;
}

template <int Dim>
Points<Dim> ForceEquation<Dim>::solve(const Step& step, std::vector<Points<Dim>> guesses, double& iterations) {
  solve_sharply(step.all, [&] {
    guesses = {solve_once(step, guesses, iterations)};
    return step.start + step.dt * guesses[0];
  });
  return guesses[0];
}

// Starts from that guess within the step limit whose residual is smallest.
template <int Dim>
Points<Dim> ForceEquation<Dim>::solve_once(const Step& step, const std::vector<Points<Dim>>& guesses,
                                           double& iterations) {
  const Points<Dim>* best = nullptr;
  double least = 0;
  for (const Points<Dim>& guess : guesses) {
    if (!is_free(step, guess)) continue;
    const double size = norm(step.all.comm(), residual(step, 1, guess));
    if (best && size >= least) continue;
    best = &guess;
    least = size;
  }
  if (!best) return solved_by_shares(step, iterations);
  Points<Dim> all = *best;
  solve_at(step, 1, all, iterations);
  return all;
}

// Starts from no motion, which nothing limits; raises the water's velocity as far as the step limit permits and solves
// for the contact forces there, until all of the velocity is applied.
template <int Dim>
Points<Dim> ForceEquation<Dim>::solved_by_shares(const Step& step, double& iterations) {
  constexpr int most_raises = 30;
  double share = 0;
  Points<Dim> all(step.start.size(), Point<Dim>::Zero());
  for (int n = 0; n < most_raises && share < 1; ++n) {
    const Points<Dim> rest = (1 - share) * step.water_velocities;
    const double part = step.all.step_limit(step.start + step.dt * all, step.dt * rest);
    all += part * rest;
    share = part == 1 ? 1 : share + part * (1 - share);
    solve_at(step, share, all, iterations);
  }
  if (share < 1) throw DivergedError("cloth: the water presses cloths through each other; a shorter step may help");
  return all;
}

template <int Dim>
void check_symmetry(const Model<Dim>& model) {
  const DeltaOptions& delta = model.transfer.delta();
  if (model.forces.have_step_limit() && delta.spread_width != delta.interpolate_width)
    throw InputError(
        "-contact barrier: needs -delta_spread_width equal to -delta_interpolate_width, or -coupling_scheme "
        "semi_implicit with -coupling_mobility row_sums, or else -contact none");
}

template void check_symmetry<2>(const Model<2>&);
template void check_symmetry<3>(const Model<3>&);
template class ForceEquation<2>;
template class ForceEquation<3>;

}  // namespace washfsi
