// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/scheme/force_equation.hpp"

#include <algorithm>
#include <numeric>

#include "washfsi/coupling/marker_vectors.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

template <int Dim>
double ForceEquation<Dim>::dot(const Step& step, const Points<Dim>& a, const Points<Dim>& b) const {
  double sum = 0;
  for (std::size_t m = 0; m < a.size(); ++m) sum += a[m].dot(b[m]);
  return ordered_sum(step.all.comm(), sum);
}

// With a share of U only; all of it at last.
template <int Dim>
Points<Dim> ForceEquation<Dim>::velocities(const Step& step, double share, const Points<Dim>& change) const {
  return share * step.water_velocities + step.dt * product<Dim>(step.mobility, change);
}

template <int Dim>
double ForceEquation<Dim>::potential(const Step& step, double share, const Points<Dim>& change) const {
  const Points<Dim> gained = step.dt * product<Dim>(step.mobility, change);
  const Points<Dim> all = share * step.water_velocities + gained;
  const std::vector<double> energies = step.all.energies(step.start + step.dt * all);
  return 0.5 * dot(step, change, gained) + std::accumulate(energies.begin(), energies.end(), 0.0) / step.dt +
         dot(step, step.forces, all);
}

template <int Dim>
void ForceEquation<Dim>::assemble(const Step& step, const Points<Dim>& places, GeometricStiffness geometric,
                                  Mat matrix) {
  if (any_rank(step.all.comm(), pattern_ != step.all.pattern())) {
    step.all.lay_out_stiffness(stiffness_);
    pattern_ = step.all.pattern();
  }
  step.all.set_stiffness(places, geometric, 1, stiffness_);
  PetscBool is_filled = PETSC_FALSE;  // not yet when it has just been laid out
  WASH_PETSC(MatAssembled(matrix, &is_filled));
  if (is_filled)
    WASH_PETSC(MatCopy(stiffness_, matrix, SAME_NONZERO_PATTERN));
  else
    step.all.set_stiffness(places, geometric, 1, matrix);
  std::vector<double> factors;
  for (const double sum : step.row_sums) factors.push_back(step.dt * step.dt * sum);
  scale_columns_and_shift<Dim>(factors, 1, matrix);
  if (blocks_are_old_ && step.is_packed) blocks_.factorise(places, stiffness_, step.mobility, step.dt * step.dt);
  blocks_are_old_ = false;
}

template <int Dim>
ClothEquation<Dim> ForceEquation<Dim>::equation(const Step& step, double share) {
  const auto places = [=, this](const Points<Dim>& change) {
    return step.start + step.dt * velocities(step, share, change);
  };
  ClothEquation<Dim> equation;
  equation.residual = [=, this](const Points<Dim>& change) {
    return change - (step.all.of_places(places(change)) - step.forces);
  };
  equation.assemble = [=, this](const Points<Dim>& change, GeometricStiffness geometric, Mat matrix) {
    assemble(step, places(change), geometric, matrix);
  };
  equation.is_solved = [=, this](const Points<Dim>& residual) {
    const Points<Dim> missing = step.dt * product<Dim>(step.mobility, residual);
    return dot(step, missing, missing) <= step.tolerance * step.tolerance;
  };
  equation.round_off = 10 * step.all.round_off(step.start);
  equation.potential = [=, this](const Points<Dim>& change) { return potential(step, share, change); };
  equation.product = [=, this](const Points<Dim>& direction) {
    return direction + step.dt * step.dt * product<Dim>(stiffness_, product<Dim>(step.mobility, direction));
  };
  if (step.is_packed) equation.correction = [this](const Points<Dim>& rest) { return blocks_.solve(rest); };
  equation.slope = [=, this](const Points<Dim>& residual, const Points<Dim>& direction) {
    return step.dt * dot(step, product<Dim>(step.mobility, residual), direction);
  };
  equation.free_part = [=, this](const Points<Dim>& change, const Points<Dim>& way) {
    return step.all.free_part(places(change), step.dt * step.dt * product<Dim>(step.mobility, way));
  };
  return equation;
}

template <int Dim>
void ForceEquation<Dim>::solve_at(const Step& step, double share, Points<Dim>& change, double& iterations) {
  double most = 0;
  for (const double sum : step.row_sums) most = std::max(most, sum);
  const double tolerance = step.tolerance / (step.dt * largest(step.all.comm(), most));
  blocks_are_old_ = true;
  iterations += static_cast<double>(solver_.solve(equation(step, share), tolerance, change));
}

template <int Dim>
bool ForceEquation<Dim>::is_free(const Step& step, const Points<Dim>& change) {
  return step.all.free_part(step.start, step.dt * velocities(step, 1, change)) == 1;
}

template <int Dim>
Points<Dim> ForceEquation<Dim>::solve(const Step& step, Points<Dim>& change, double& iterations) {
  const Points<Dim> none(change.size(), Point<Dim>::Zero());
  const bool guess_is_free = is_free(step, change), none_is_free = is_free(step, none);
  if (!guess_is_free || (none_is_free && potential(step, 1, none) < potential(step, 1, change))) change = none;
  if (guess_is_free || none_is_free)
    solve_at(step, 1, change, iterations);
  else
    solve_by_shares(step, change, iterations);
  return velocities(step, 1, change);
}

// From no motion at all, which is free, the water's velocity is raised as far as the way is free, and the forces that
// then keep apart what came near are solved for.
template <int Dim>
void ForceEquation<Dim>::solve_by_shares(const Step& step, Points<Dim>& change, double& iterations) {
  constexpr int most_raises = 30;
  double share = 0;
  for (int n = 0; n < most_raises && share < 1; ++n) {
    const double rest = 1 - share;
    const double part = step.all.free_part(step.start + step.dt * velocities(step, share, change),
                                           step.dt * rest * step.water_velocities);
    share = part == 1 ? 1 : share + part * rest;
    solve_at(step, share, change, iterations);
  }
  if (share < 1) throw DivergedError("cloth: the water presses cloths through each other; a shorter step may help");
}

template <int Dim>
bool is_packed(const Model<Dim>& model) {
  constexpr double many = 3;
  double cells_per_marker = 1 / static_cast<double>(std::max<PetscInt>(model.cloths.marker_count(), 1)), reached = 1;
  for (int d = 0; d < Dim; ++d) {
    cells_per_marker *= static_cast<double>(model.grid.cells()[d]);
    reached *= 2 * model.transfer.delta().spread_width;
  }
  return Dim == 3 && model.forces.limit_motion() && reached > many * cells_per_marker;
}

template <int Dim>
void check_symmetry(const Model<Dim>& model) {
  const DeltaOptions& delta = model.transfer.delta();
  if (model.forces.limit_motion() && delta.spread_width != delta.interpolate_width)
    throw InputError(
        "-contact barrier: needs -delta_spread_width equal to -delta_interpolate_width, or -coupling_mobility "
        "row_sums");
}

template void check_symmetry<2>(const Model<2>&);
template void check_symmetry<3>(const Model<3>&);
template bool is_packed<2>(const Model<2>&);
template bool is_packed<3>(const Model<3>&);
template class ForceEquation<2>;
template class ForceEquation<3>;

}  // namespace washfsi
