// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// Carries marker data between the ranks that own the markers (by their place in the cloths) and the ranks that
/// own the cells the markers are in. A PetscSF, rebuilt when a marker enters another rank's cells.
template <int Dim>
class MarkerExchange {
 public:
  explicit MarkerExchange(const Grid<Dim>& grid) : grid_(grid) {}

  /// Takes this rank's marker positions. Collective.
  void update(const Points<Dim>& positions);

  /// Sends values from the markers' owners to the cells' owners. Collective.
  Points<Dim> to_cells(const Points<Dim>& values) const;
  std::vector<double> to_cells(const std::vector<double>& values) const;
  /// Sends values back from the cells' owners to the markers' owners. Collective.
  Points<Dim> to_owners(const Points<Dim>& values) const;

 private:
  void rebuild();

  const Grid<Dim>& grid_;
  PointType<Dim> point_type_;
  std::vector<int> cell_owner_;  ///< rank of the cell of each of this rank's markers
  std::size_t here_ = 0;
  petsc::StarForest forest_;
};

extern template class MarkerExchange<2>;
extern template class MarkerExchange<3>;

}  // namespace washfsi
