// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/immersed_boundary/mobility.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/geometry/near_search.hpp"
#include "washfsi/immersed_boundary/overlap.hpp"
#include "washfsi/support/broadcast.hpp"

namespace washfsi {

// Calls use(spread, interpolate), one and the same object if the two deltas are equal.
template <int Dim>
template <class Use>
void MobilityMatrix<Dim>::with_stencils(const Points<Dim>& positions, const Use& use) const {
  const FaceStencils<Dim> spread({delta_.kernel, delta_.spread_width}, grid_, positions);
  if (is_symmetric()) {
    spread.visit([&](const auto& of_both) { use(of_both, of_both); });
    return;
  }
  const FaceStencils<Dim> interpolate({delta_.kernel, delta_.interpolate_width}, grid_, positions);
  spread.visit([&](const auto& s) { interpolate.visit([&](const auto& i) { use(s, i); }); });
}

// The overlaps of this rank's markers with others, in ascending order, so that sums do not depend on how they are
// found. Between two markers of this rank they are computed once if both deltas are the same.
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
  std::vector<std::vector<Entry>> rows(count);
  with_stencils(positions, [&](const auto& spread, const auto& interpolate) {
    for (std::size_t marker = first; marker < first + count; ++marker)
      search.visit_near(reached[marker - first], [&](std::size_t other) {
        const bool mirrored = is_symmetric() && other >= first && other < first + count && other != marker;
        if (mirrored && other < marker) return;
        const Point<Dim> value = overlap(grid_, interpolate[marker], spread[other]);
        if (value == Point<Dim>::Zero()) return;
        rows[marker - first].push_back({other, value});
        if (mirrored) rows[other - first].push_back({marker, value});
      });
  });
  for (auto& row : rows)
    std::sort(row.begin(), row.end(), [](const Entry& a, const Entry& b) { return a.other < b.other; });
  return rows;
}

template <int Dim>
void MobilityMatrix<Dim>::assemble(const Points<Dim>& positions, const std::vector<std::size_t>& numbers,
                                   std::size_t first, const std::vector<double>& row_sums, double own_share) {
  const std::vector<std::vector<Entry>> rows = overlaps(positions, first, row_sums.size());
  std::vector<double> scales;  // factors by which the row sums of the overlaps are multiplied
  for (std::size_t m = 0; m < rows.size(); ++m) {
    Point<Dim> sum = Point<Dim>::Zero();
    for (const Entry& entry : rows[m]) sum += entry.value;
    scales.push_back(row_sums[m] / sum.maxCoeff());
  }
  const std::vector<std::size_t> others = others_in(rows, first, positions.size());
  std::vector<PetscInt> numbers_of_others;
  for (const std::size_t other : others) numbers_of_others.push_back(static_cast<PetscInt>(numbers[other]));
  find_others(rows.size(), numbers_of_others);
  std::vector<std::size_t> column_of(positions.size());
  for (std::size_t n = 0; n < others.size(); ++n) column_of[others[n]] = n;
  fill(rows, first, column_of, scales, own_share);
}

template <int Dim>
void MobilityMatrix<Dim>::fill(const std::vector<std::vector<Entry>>& rows, std::size_t begin,
                               const std::vector<std::size_t>& column_of, const std::vector<double>& scales,
                               double own_share) {
  const std::vector<double> scales_of_others = petsc::broadcast(from_others_, MPI_DOUBLE, scales, count_of_others());
  own_ = others_ = {};
  for (std::size_t m = 0; m < rows.size(); ++m) {
    for (const auto& [other, value] : rows[m]) {
      const bool is_own = other >= begin && other < begin + rows.size();
      const double share = other == begin + m ? 1 + own_share : 1,
                   scale = is_own ? scales[other - begin] : scales_of_others[column_of[other]];
      const Point<Dim> entry = share * std::sqrt(scales[m] * scale) * value;
      if (!is_own)
        others_.add(column_of[other], entry);
      else if (other >= begin + m || !is_symmetric())
        own_.add(other - begin, entry);
    }
    own_.end_row();
    others_.end_row();
  }
}

// The markers of other ranks, in ascending order.
template <int Dim>
std::vector<std::size_t> MobilityMatrix<Dim>::others_in(const std::vector<std::vector<Entry>>& rows, std::size_t begin,
                                                        std::size_t all) {
  std::vector<char> is_met(all, 0);
  for (const auto& row : rows)
    for (const Entry& entry : row) is_met[entry.other] = 1;
  std::vector<std::size_t> others;
  for (std::size_t marker = 0; marker < all; ++marker)
    if (is_met[marker] && (marker < begin || marker >= begin + rows.size())) others.push_back(marker);
  return others;
}

template <int Dim>
void MobilityMatrix<Dim>::find_others(std::size_t own, const std::vector<PetscInt>& others) {
  petsc::Layout markers;
  WASH_PETSC(PetscLayoutCreateFromSizes(grid_.comm(), static_cast<PetscInt>(own), PETSC_DETERMINE, 1, markers.put()));
  WASH_PETSC(PetscSFCreate(grid_.comm(), from_others_.put()));
  WASH_PETSC(PetscSFSetGraphLayout(from_others_, markers, static_cast<PetscInt>(others.size()), nullptr,
                                   PETSC_COPY_VALUES, others.data()));
  WASH_PETSC(PetscSFSetUp(from_others_));
}

template <int Dim>
std::size_t MobilityMatrix<Dim>::count_of_others() const {
  PetscInt count = 0;
  WASH_PETSC(PetscSFGetGraph(from_others_, nullptr, &count, nullptr, nullptr));
  return static_cast<std::size_t>(count);
}

template <int Dim>
Points<Dim> MobilityMatrix<Dim>::times(const Points<Dim>& forces) const {
  Points<Dim> forces_of_others(count_of_others()), result(forces.size(), Point<Dim>::Zero());
  WASH_PETSC(PetscSFBcastBegin(from_others_, point_type_, forces.data(), forces_of_others.data(), MPI_REPLACE));
  add_of_own(forces, result);
  WASH_PETSC(PetscSFBcastEnd(from_others_, point_type_, forces.data(), forces_of_others.data(), MPI_REPLACE));
  for (std::size_t m = 0; m < result.size(); ++m)
    for (std::size_t k = others_.starts[m]; k < others_.starts[m + 1]; ++k)
      result[m] += others_.values[k].cwiseProduct(forces_of_others[others_.columns[k]]);
  return result;
}

template <int Dim>
void MobilityMatrix<Dim>::add_of_own(const Points<Dim>& forces, Points<Dim>& result) const {
  const bool mirrors = is_symmetric();
  for (std::size_t m = 0; m < forces.size(); ++m) {
    Point<Dim> sum = Point<Dim>::Zero();
    for (std::size_t k = own_.starts[m]; k < own_.starts[m + 1]; ++k) {
      const auto other = static_cast<std::size_t>(own_.columns[k]);
      sum += own_.values[k].cwiseProduct(forces[other]);
      if (mirrors && other != m) result[other] += own_.values[k].cwiseProduct(forces[m]);
    }
    result[m] += sum;
  }
}

template class MobilityMatrix<2>;
template class MobilityMatrix<3>;

}  // namespace washfsi
