// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/immersed_boundary/transfer.hpp"

namespace washfsi {

/// The mobility of markers before projection, J H S / rho, as a sparse matrix over all coordinates of all markers: the
/// velocity of marker k per unit time under a unit nodal force on marker l [1/kg; m/kg in the plane]. Overlaps of two
/// deltas are exact; what the density and solids change of them is taken from the row sums, alike for both markers.
template <int Dim>
class MobilityMatrix {
 public:
  MobilityMatrix(const Grid<Dim>& grid, const DeltaOptions& delta) : grid_(grid), delta_(delta) {}

  /// Assembles the matrix. `positions` are those of the markers with these numbers, in ascending order: this rank's,
  /// from `first` on, and all within their reach; `row_sums` are of this rank's markers. The diagonal is raised by a
  /// share of itself, since two markers at one position would make the matrix singular. Collective.
  void assemble(const Points<Dim>& positions, const std::vector<std::size_t>& numbers, std::size_t first,
                const std::vector<double>& row_sums, double own_share = 0);

  /// Its product with forces on this rank's markers. Collective.
  Points<Dim> times(const Points<Dim>& forces) const;

 private:
  struct Entry {
    std::size_t other;
    Point<Dim> value;
  };
  bool is_symmetric() const { return delta_.spread_width == delta_.interpolate_width; }
  std::vector<std::vector<Entry>> overlaps(const Points<Dim>& positions, std::size_t first, std::size_t count) const;
  template <class Use>
  void with_stencils(const Points<Dim>& positions, const Use& use) const;
  /// A sparse matrix between this rank's markers and some others; by coordinate, as none is between two of them.
  struct Rows {
    std::vector<std::size_t> starts{0};  ///< first entry of each marker, and the end
    std::vector<PetscInt> columns;
    Points<Dim> values;

    void add(std::size_t column, const Point<Dim>& value) {
      columns.push_back(static_cast<PetscInt>(column));
      values.push_back(value);
    }
    void end_row() { starts.push_back(columns.size()); }
  };
  /// `column_of` is the column of each marker of another rank, counted among these.
  void fill(const std::vector<std::vector<Entry>>& rows, std::size_t begin, const std::vector<std::size_t>& column_of,
            const std::vector<double>& scales, double own_share);
  static std::vector<std::size_t> others_in(const std::vector<std::vector<Entry>>& rows, std::size_t begin,
                                            std::size_t all);
  void find_others(std::size_t own, const std::vector<PetscInt>& others);
  std::size_t count_of_others() const;
  void add_of_own(const Points<Dim>& forces, Points<Dim>& result) const;

  const Grid<Dim>& grid_;
  DeltaOptions delta_;
  PointType<Dim> point_type_;
  Rows own_;     ///< between this rank's markers; from each marker on if the matrix is symmetric
  Rows others_;  ///< between this rank's markers and those of other ranks, in ascending order
  petsc::StarForest from_others_;
};

extern template class MobilityMatrix<2>;
extern template class MobilityMatrix<3>;

}  // namespace washfsi
