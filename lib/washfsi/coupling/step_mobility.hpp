// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/near_markers.hpp"
#include "washfsi/coupling/model.hpp"
#include "washfsi/immersed_boundary/face_mobility.hpp"
#include "washfsi/immersed_boundary/mobility.hpp"
#include "washfsi/support/point_vectors.hpp"

namespace washfsi {

/// The approximate mobility of the markers in a step: M, symmetric, or its row sums. M is a sparse matrix or, where so
/// many markers are near each other that it is faster, a product through the faces of the grid. Parts may be added to
/// either.
template <int Dim>
class StepMobility {
 public:
  /// Collective.
  explicit StepMobility(const Model<Dim>& model)
      : near_(model.cloths, periods_of<Dim>(model.grid)),
        matrix_(model.grid, model.transfer.delta()),
        faces_(model.grid, model.transfer.delta()) {}

  /// Computes the mobility where the cloths were located last, times a factor. Where contact limits the motion of
  /// markers, the diagonal of M is raised by 10^-2 of itself, so that M is not singular. Collective.
  void find(const Model<Dim>& model, const Points<Dim>& places, double factor, bool with_matrix);
  /// Adds a symmetric matrix to M. No communication.
  void add(petsc::Matrix part) { parts_.push_back(std::move(part)); }
  /// Adds a block for each of this rank's markers to the diagonal of M, in place of those that it added before.
  void add_own(std::vector<Block<Dim>> blocks) { own_ = std::move(blocks); }
  /// Multiplies M, without what was added, with a share; its row sums stay.
  void set_share(double share) { share_ = share; }

  const std::vector<double>& row_sums() const { return row_sums_; }
  /// The row sums times a factor.
  std::vector<double> row_sums(double factor) const;
  /// Replaces a matrix K of the cloths' lattice by  1 + factor D K, D having the row sums and the blocks that were
  /// added on its diagonal. Collective.
  void precondition(double factor, Mat matrix) const;
  /// M F for forces F. Collective.
  Points<Dim> times(const Points<Dim>& forces) const;

 private:
  NearMarkers<Dim> near_;  ///< this rank's markers and all within twice the distance at which deltas overlap
  MobilityMatrix<Dim> matrix_;
  FaceMobility<Dim> faces_;
  bool by_faces_ = false;
  double share_ = 1;
  std::vector<petsc::Matrix> parts_;
  std::vector<Block<Dim>> own_;  ///< empty, or of each of this rank's markers
  MatrixProduct<Dim> product_;
  std::vector<double> row_sums_;  ///< row sums D of this rank's markers
};

extern template class StepMobility<2>;
extern template class StepMobility<3>;

}  // namespace washfsi
