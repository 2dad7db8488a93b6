// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/mobility.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/coupling/overlap.hpp"
#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

template <int Dim>
std::vector<typename MobilityMatrix<Dim>::Stencils> MobilityMatrix<Dim>::stencils_at(
    const Points<Dim>& positions) const {
  const AxisDelta spread(delta_.kernel, delta_.spread_width), interpolate(delta_.kernel, delta_.interpolate_width);
  std::vector<Stencils> stencils;
  stencils.reserve(positions.size());
  for (const auto& position : positions) {
    const FaceStencil<Dim> stencil(grid_, spread, position);
    stencils.push_back({stencil, is_symmetric() ? stencil : FaceStencil<Dim>(grid_, interpolate, position)});
  }
  return stencils;
}

// The overlaps of this rank's markers with others, in ascending order: so the matrix takes them several times faster.
// Between two markers of this rank they are worked out once if both deltas are the same.
template <int Dim>
std::vector<std::vector<typename MobilityMatrix<Dim>::Entry>> MobilityMatrix<Dim>::overlaps(
    const Points<Dim>& positions, std::size_t first, std::size_t count) const {
  const Point<Dim> reach = (delta_.spread_width + delta_.interpolate_width) * grid_.spacing();
  const auto round = [&](std::size_t marker, const Point<Dim>& margin) {
    return Bounds<Dim>::round(grid_.folded(positions[marker]), margin);
  };
  std::vector<Bounds<Dim>> places, reached;
  for (std::size_t marker = 0; marker < positions.size(); ++marker) places.push_back(round(marker, Point<Dim>::Zero()));
  for (std::size_t marker = first; marker < first + count; ++marker) reached.push_back(round(marker, reach));
  const NearSearch<Dim> search(std::move(places), reach, hull(reached), periods_of<Dim>(grid_));
  const std::vector<Stencils> stencils = stencils_at(positions);
  std::vector<std::vector<Entry>> rows(count);
  for (std::size_t marker = first; marker < first + count; ++marker)
    search.visit_near(reached[marker - first], [&](std::size_t other) {
      const bool mirrored = is_symmetric() && other >= first && other < first + count && other != marker;
      if (mirrored && other < marker) return;
      const Point<Dim> value = overlap(grid_, stencils[marker].interpolate, stencils[other].spread);
      if (value == Point<Dim>::Zero()) return;
      rows[marker - first].push_back({other, value});
      if (mirrored) rows[other - first].push_back({marker, value});
    });
  for (auto& row : rows)
    std::sort(row.begin(), row.end(), [](const Entry& a, const Entry& b) { return a.other < b.other; });
  return rows;
}

template <int Dim>
void MobilityMatrix<Dim>::assemble(const Points<Dim>& positions, PetscInt first, const std::vector<double>& row_sums,
                                   double own_share) {
  const auto begin = static_cast<std::size_t>(first);
  const std::vector<std::vector<Entry>> rows = overlaps(positions, begin, row_sums.size());
  std::vector<double> scales(positions.size(), 0.0);  // what the row sums of the overlaps must be multiplied with
  std::vector<PetscInt> own(Dim * rows.size(), 0), foreign(Dim * rows.size(), 0);  // entries of each matrix row
  for (std::size_t m = 0; m < rows.size(); ++m) {
    Point<Dim> sum = Point<Dim>::Zero();
    for (const Entry& entry : rows[m]) {
      sum += entry.value;
      const bool is_own = entry.other >= begin && entry.other < begin + rows.size();
      for (int c = 0; c < Dim; ++c) ++(is_own ? own : foreign)[Dim * m + c];
    }
    scales[begin + m] = row_sums[m] / sum.maxCoeff();
  }
  MPI_Allreduce(MPI_IN_PLACE, scales.data(), static_cast<int>(scales.size()), MPI_DOUBLE, MPI_SUM, grid_.comm());

  const auto owned = static_cast<PetscInt>(Dim * rows.size());
  WASH_PETSC(MatCreateAIJ(grid_.comm(), owned, owned, PETSC_DETERMINE, PETSC_DETERMINE, 0, own.data(), 0,
                          foreign.data(), matrix_.put()));
  std::vector<PetscInt> columns;
  std::vector<double> values;
  for (std::size_t m = 0; m < rows.size(); ++m)
    for (int c = 0; c < Dim; ++c) {
      const PetscInt row = (first + static_cast<PetscInt>(m)) * Dim + c;
      columns.clear();
      values.clear();
      for (const Entry& entry : rows[m]) {
        columns.push_back(static_cast<PetscInt>(entry.other) * Dim + c);
        const double share = entry.other == begin + m ? 1 + own_share : 1;
        values.push_back(share * std::sqrt(scales[begin + m] * scales[entry.other]) * entry.value[c]);
      }
      WASH_PETSC(MatSetValues(matrix_, 1, &row, static_cast<PetscInt>(columns.size()), columns.data(), values.data(),
                              INSERT_VALUES));
    }
  WASH_PETSC(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
  WASH_PETSC(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
}

template class MobilityMatrix<2>;
template class MobilityMatrix<3>;

}  // namespace washfsi
