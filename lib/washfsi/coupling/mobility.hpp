// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/transfer.hpp"

namespace washfsi {

/// The mobility of markers before projection, J H S / rho, as a sparse matrix over all coordinates of all markers: the
/// velocity of marker k per unit time under a unit nodal force on marker l [1/kg; m/kg in the plane]. Overlaps of two
/// deltas are exact; what the density and solids change of them is taken from the row sums, alike for both markers.
template <int Dim>
class MobilityMatrix {
 public:
  MobilityMatrix(const Grid<Dim>& grid, const DeltaOptions& delta) : grid_(grid), delta_(delta) {}

  /// Makes the matrix anew. `positions` are those of all markers, on every rank; `row_sums` those of this rank's
  /// markers, which are the ones from `first` on. The diagonal is raised by a share of itself: where two markers are in
  /// one place, the matrix would be singular. Collective.
  void assemble(const Points<Dim>& positions, PetscInt first, const std::vector<double>& row_sums,
                double own_share = 0);

  operator Mat() const { return matrix_; }

 private:
  struct Stencils {
    FaceStencil<Dim> spread, interpolate;
  };
  struct Entry {
    std::size_t other;
    Point<Dim> value;
  };
  bool is_symmetric() const { return delta_.spread_width == delta_.interpolate_width; }
  std::vector<std::vector<Entry>> overlaps(const Points<Dim>& positions, std::size_t first, std::size_t count) const;
  std::vector<Stencils> stencils_at(const Points<Dim>& positions) const;

  const Grid<Dim>& grid_;
  DeltaOptions delta_;
  petsc::Matrix matrix_;
};

extern template class MobilityMatrix<2>;
extern template class MobilityMatrix<3>;

}  // namespace washfsi
