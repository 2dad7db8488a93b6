// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/mobility.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace washfsi {

namespace {

/// Which markers may overlap: those in the same or a neighbouring bin, bins being as long as two deltas' half widths.
template <int Dim>
class Bins {
 public:
  Bins(const Grid<Dim>& grid, const Points<Dim>& positions, double reach) {
    for (int d = 0; d < Dim; ++d) {
      const double length = grid.upper()[d] - grid.lower()[d];
      const auto axis = static_cast<std::size_t>(d);
      count_[axis] = std::max<PetscInt>(1, static_cast<PetscInt>(length / (reach * grid.spacing()[d])));
      periodic_[axis] = grid.periodic(d);
    }
    for (std::size_t m = 0; m < positions.size(); ++m) {
      Index<Dim> bin{};
      for (int d = 0; d < Dim; ++d) {
        const auto axis = static_cast<std::size_t>(d);
        const double place = (positions[m][d] - grid.lower()[d]) / (grid.upper()[d] - grid.lower()[d]);
        const double folded = periodic_[axis] ? place - std::floor(place) : place;
        bin[axis] = static_cast<PetscInt>(std::floor(folded * static_cast<double>(count_[axis])));
      }
      bins_.push_back(bin);
      markers_[bin].push_back(m);
    }
  }

  template <class Visit>
  void visit_near(std::size_t marker, Visit&& visit) const {
    std::vector<Index<Dim>> seen;
    Box<Dim> box;
    for (std::size_t d = 0; d < Dim; ++d) {
      box.lower[d] = bins_[marker][d] - 1;
      box.upper[d] = bins_[marker][d] + 2;
    }
    for_each<Dim>(box, [&](Index<Dim> bin) {
      for (std::size_t d = 0; d < Dim; ++d)
        if (periodic_[d]) bin[d] = (bin[d] + count_[d]) % count_[d];
      if (std::find(seen.begin(), seen.end(), bin) != seen.end()) return;  // a short period
      seen.push_back(bin);
      const auto found = markers_.find(bin);
      if (found == markers_.end()) return;
      for (const std::size_t other : found->second) visit(other);
    });
  }

 private:
  Index<Dim> count_{};
  std::array<bool, Dim> periodic_{};
  std::vector<Index<Dim>> bins_;
  std::map<Index<Dim>, std::vector<std::size_t>> markers_;
};

}  // namespace

// Sum of the products of two markers' weights along one axis, with all periodic images.
template <int Dim>
double MobilityMatrix<Dim>::axis_overlap(int axis, const AxisStencil& a, const AxisStencil& b) const {
  const auto with_shift = [&](PetscInt shift) {
    double sum = 0;
    for (PetscInt i = std::max<PetscInt>(0, shift); i < std::min<PetscInt>(a.count, b.count + shift); ++i)
      sum += a.weight[static_cast<std::size_t>(i)] * b.weight[static_cast<std::size_t>(i - shift)];
    return sum;
  };
  PetscInt shift = b.first - a.first;
  if (!grid_.periodic(axis)) return with_shift(shift);
  const PetscInt cells = grid_.cells()[static_cast<std::size_t>(axis)];
  shift -= cells * static_cast<PetscInt>(std::llround(static_cast<double>(shift) / static_cast<double>(cells)));
  const double nearest = with_shift(shift);
  return cells >= a.count + b.count ? nearest : nearest + with_shift(shift - cells) + with_shift(shift + cells);
}

// J S of one marker on another, for each component, per cell volume.
template <int Dim>
Point<Dim> MobilityMatrix<Dim>::overlap(const Stencils& moved, const Stencils& pushed) const {
  Point<Dim> result = Point<Dim>::Ones();
  for (int d = 0; d < Dim; ++d) {
    const auto along = [&](int component) {
      return axis_overlap(d, moved.interpolate.along(d, component), pushed.spread.along(d, component));
    };
    const double normal = along(d), between = along((d + 1) % Dim);
    for (int c = 0; c < Dim; ++c) result[c] *= c == d ? normal : between;
    if (normal == 0 && between == 0) break;
  }
  return result;
}

// Whether two markers' deltas may overlap: quickly, since most markers of neighbouring bins do not.
template <int Dim>
bool MobilityMatrix<Dim>::may_overlap(const Point<Dim>& a, const Point<Dim>& b) const {
  const double reach = delta_.spread_width + delta_.interpolate_width;
  for (int d = 0; d < Dim; ++d)
    if (!grid_.periodic(d) && std::abs(a[d] - b[d]) >= reach * grid_.spacing()[d]) return false;
  return true;
}

// The overlaps of this rank's markers with others, in ascending order: so the matrix takes them several times faster.
// Between two markers of this rank they are worked out once if both deltas are the same.
template <int Dim>
std::vector<std::vector<typename MobilityMatrix<Dim>::Entry>> MobilityMatrix<Dim>::overlaps(
    const Points<Dim>& positions, std::size_t first, std::size_t count) const {
  const Bins<Dim> bins(grid_, positions, delta_.spread_width + delta_.interpolate_width);
  const AxisDelta spread(delta_.kernel, delta_.spread_width), interpolate(delta_.kernel, delta_.interpolate_width);
  std::vector<Stencils> stencils;
  stencils.reserve(positions.size());
  for (const auto& position : positions)
    stencils.push_back({FaceStencil<Dim>(grid_, spread, position), FaceStencil<Dim>(grid_, interpolate, position)});
  const bool symmetric = delta_.spread_width == delta_.interpolate_width;
  std::vector<std::vector<Entry>> rows(count);
  for (std::size_t marker = first; marker < first + count; ++marker)
    bins.visit_near(marker, [&](std::size_t other) {
      const bool mirrored = symmetric && other >= first && other < first + count && other != marker;
      if ((mirrored && other < marker) || !may_overlap(positions[marker], positions[other])) return;
      const Point<Dim> value = overlap(stencils[marker], stencils[other]);
      if (value == Point<Dim>::Zero()) return;
      rows[marker - first].push_back({other, value});
      if (mirrored) rows[other - first].push_back({marker, value});
    });
  for (auto& row : rows)
    std::sort(row.begin(), row.end(), [](const Entry& a, const Entry& b) { return a.other < b.other; });
  return rows;
}

template <int Dim>
void MobilityMatrix<Dim>::assemble(const Points<Dim>& positions, PetscInt first, const std::vector<double>& row_sums) {
  const auto begin = static_cast<std::size_t>(first);
  const std::vector<std::vector<Entry>> rows = overlaps(positions, begin, row_sums.size());
  std::vector<double> scales(positions.size(), 0.0);  // what the row sums of the overlaps must be multiplied with
  std::vector<PetscInt> own(Dim * rows.size(), 0), foreign(Dim * rows.size(), 0);  // entries of each matrix row
  for (std::size_t m = 0; m < rows.size(); ++m) {
    Point<Dim> sum = Point<Dim>::Zero();
    for (const Entry& entry : rows[m]) {
      sum += entry.value;
      const bool is_own = entry.other >= begin && entry.other < begin + rows.size();
      for (std::size_t c = 0; c < Dim; ++c) ++(is_own ? own : foreign)[Dim * m + c];
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
        values.push_back(std::sqrt(scales[begin + m] * scales[entry.other]) * entry.value[c]);
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
