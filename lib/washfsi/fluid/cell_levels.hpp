// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// Cells along one axis, of any widths, distributed over the parts of a grid.
struct CellLine {
  std::vector<double> edges;        ///< edges of cells [m], one more than there are cells
  std::vector<PetscInt> part_ends;  ///< end of each part's range of cells
  bool periodic = false;

  /// A place as seen from the middles of the two cells that are nearest to it: cells and their weights, of sum 1.
  /// Beyond the outermost middles, where the line is not periodic, only the outermost cell has weight.
  struct Place {
    std::array<PetscInt, 2> cells;
    std::array<double, 2> weights;
  };

  PetscInt cells() const { return static_cast<PetscInt>(edges.size()) - 1; }
  double width(PetscInt cell) const { return edges[cell + 1] - edges[cell]; }
  double middle(PetscInt cell) const { return 0.5 * (edges[cell] + edges[cell + 1]); }
  /// The cell that contains a place within the line.
  PetscInt cell_at(double x) const;
  Place place(double x) const;
  /// Distance between the middles of a cell and its upper neighbour, the first after the last.
  double to_next(PetscInt cell) const { return 0.5 * (width(cell) + width((cell + 1) % cells())); }
  /// Merges pairs of these cells; where their number is odd, the last one is three of them, or the last one alone,
  /// whichever is nearer to the others in width. A coarse cell belongs to the part that has its first cell.
  CellLine coarsened() const;
};

/// The cells of one level of multigrid, a product of lines, numbered as in the grid's vectors: rank by rank, of each
/// rank x first.
template <int Dim>
class CellLevel {
 public:
  explicit CellLevel(const Grid<Dim>& grid);

  const CellLine& line(int axis) const { return lines_[axis]; }
  Index<Dim> cells() const;
  double cell_count() const;
  Box<Dim> owned_by(int rank) const;
  PetscInt number(const Index<Dim>& cell) const;
  /// The number of cells on a rank.
  PetscInt count(int rank) const { return starts_[rank + 1] - starts_[rank]; }
  /// The next coarser level: axes along which cells are narrow are coarsened, so that cells become as wide as high. For
  /// levels of more than one cell.
  CellLevel coarsened() const;

 private:
  void count_cells();

  std::array<CellLine, Dim> lines_;
  std::vector<PetscInt> starts_;  ///< the first number of each rank, and the end
};

extern template class CellLevel<2>;
extern template class CellLevel<3>;

}  // namespace washfsi
