// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/step_mobility.hpp"

#include <algorithm>

#include "washfsi/support/collective.hpp"

namespace washfsi {

// Within solids, where nothing moves a marker, the row sums have a floor; where all markers are there, any does.
template <int Dim>
void StepMobility<Dim>::find(const Model<Dim>& model, const Points<Dim>& places, double factor, bool with_matrix) {
  const petsc::LogPart part("mobility");
  constexpr double floor = 1e-3;
  constexpr double own_share = 1e-2;  // in the machine like a permeance of 1e-7 m/(s Pa), a hundredth of a towel's
  row_sums_ = row_sum_mobility<Dim>(model.transfer, model.grid, model.boundary, model.liquid.density(),
                                    model.bodies.fluid_fraction(), std::vector<double>(places.size(), 1.0));
  double most = 0;
  for (const double sum : row_sums_) most = std::max(most, sum);
  most = largest(model.grid.comm(), most);
  if (most == 0) most = 1;
  for (double& sum : row_sums_) sum = factor * std::max(sum, floor * most);
  parts_.clear();
  own_.clear();
  share_ = 1;
  if (!with_matrix) return;
  const double share = model.forces.have_step_limit() ? own_share : 0;
  const DeltaOptions& delta = model.transfer.delta();
  const double reach = (delta.spread_width + delta.interpolate_width) * model.grid.spacing().maxCoeff();
  near_.choose(places, std::vector<double>(places.size(), 0.0), 2 * reach);
  const Points<Dim> all = near_.values(places);
  by_faces_ = faces_.is_faster(all, near_.begin(), places.size());
  if (by_faces_)
    faces_.locate(places, row_sums_, share);
  else
    matrix_.assemble(all, near_.numbers(), near_.begin(), row_sums_, share);
}

template <int Dim>
Points<Dim> StepMobility<Dim>::times(const Points<Dim>& forces) const {
  Points<Dim> result = by_faces_ ? faces_.times(forces) : matrix_.times(forces);
  if (share_ != 1) result = share_ * result;
  for (const Mat part : parts_) result += product_(part, forces);
  for (std::size_t m = 0; m < own_.size(); ++m) result[m] += own_[m] * forces[m];
  return result;
}

template <int Dim>
std::vector<double> StepMobility<Dim>::row_sums(double factor) const {
  std::vector<double> sums = row_sums_;
  for (double& sum : sums) sum *= factor;
  return sums;
}

template <int Dim>
void StepMobility<Dim>::precondition(double factor, Mat matrix) const {
  if (own_.empty()) {
    scale_and_shift<Dim>(row_sums(factor), std::vector<double>(row_sums_.size(), 1.0), matrix);
    return;
  }
  std::vector<Block<Dim>> blocks;
  for (std::size_t m = 0; m < own_.size(); ++m)
    blocks.push_back(factor * (row_sums_[m] * Block<Dim>::Identity() + own_[m]));
  scale_by_blocks_and_shift<Dim>(blocks, 1, matrix);
}

template class StepMobility<2>;
template class StepMobility<3>;

}  // namespace washfsi
