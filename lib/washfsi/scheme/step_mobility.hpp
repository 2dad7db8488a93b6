// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/mobility.hpp"
#include "washfsi/scheme/model.hpp"

namespace washfsi {

/// What stands for the mobility of the markers in a step: a sparse matrix, or the sums of its rows.
template <int Dim>
class StepMobility {
 public:
  explicit StepMobility(const Model<Dim>& model) : matrix_(model.grid, model.transfer.delta()) {}

  /// At the places where the cloths were located last, times a factor. Where contact limits the markers' motion, those
  /// that are in the same water get a little mobility of their own. Collective.
  void find(const Model<Dim>& model, const Points<Dim>& places, double factor, bool with_matrix);

  const std::vector<double>& row_sums() const { return row_sums_; }
  const MobilityMatrix<Dim>& matrix() const { return matrix_; }

 private:
  MobilityMatrix<Dim> matrix_;
  std::vector<double> row_sums_;  ///< of each of this rank's markers
};

extern template class StepMobility<2>;
extern template class StepMobility<3>;

}  // namespace washfsi
