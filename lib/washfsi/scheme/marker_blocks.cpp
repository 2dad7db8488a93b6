// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/scheme/marker_blocks.hpp"

#include <algorithm>
#include <numeric>

#include <Eigen/Sparse>

#include "washfsi/coupling/own_rows.hpp"

namespace washfsi {

namespace {

constexpr std::size_t most_markers = 96;  // of a block: more save few iterations and cost more than these

// s K between the rows of a block.
Eigen::SparseMatrix<double> part_of(const OwnRows& stiffness, double s, const std::vector<PetscInt>& rows,
                                    const std::vector<int>& numbers) {
  const auto size = static_cast<int>(rows.size());
  std::vector<Eigen::Triplet<double>> entries;
  stiffness.visit(rows, numbers, [&](int i, int j, double value) { entries.emplace_back(i, j, s * value); });
  Eigen::SparseMatrix<double> part(size, size);
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

}  // namespace

// In halves along the longest side, until they are small enough.
template <int Dim>
void MarkerBlocks<Dim>::split(const Points<Dim>& places, Markers markers, std::vector<Markers>& groups) {
  if (markers.empty()) return;
  if (markers.size() <= most_markers) return groups.push_back(std::move(markers));
  Point<Dim> lower = places[markers[0]], upper = lower;
  for (const std::size_t m : markers) {
    lower = lower.cwiseMin(places[m]);
    upper = upper.cwiseMax(places[m]);
  }
  Eigen::Index axis = 0;
  (upper - lower).maxCoeff(&axis);
  const auto middle = markers.begin() + static_cast<long>(markers.size() / 2);
  std::nth_element(markers.begin(), middle, markers.end(), [&](std::size_t a, std::size_t b) {
    return std::make_pair(places[a][axis], a) < std::make_pair(places[b][axis], b);
  });
  split(places, Markers(markers.begin(), middle), groups);
  split(places, Markers(middle, markers.end()), groups);
}

template <int Dim>
void MarkerBlocks<Dim>::factorise(const Points<Dim>& places, Mat stiffness, const MobilityBlock& mobility, double s) {
  const petsc::LogPart part("marker_blocks");
  Markers all(places.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<Markers> groups;
  split(places, std::move(all), groups);
  const OwnRows k(stiffness);
  std::vector<int> numbers(Dim * places.size(), -1);
  blocks_.clear();
  for (auto& group : groups) {
    std::vector<PetscInt> rows;
    for (const std::size_t marker : group)
      for (std::size_t c = 0; c < Dim; ++c) {
        numbers[Dim * marker + c] = static_cast<int>(rows.size());
        rows.push_back(static_cast<PetscInt>(Dim * marker + c));
      }
    Eigen::MatrixXd matrix = mobility(group) * part_of(k, s, rows, numbers);
    matrix.diagonal().array() += 1;
    blocks_.push_back({std::move(group), Eigen::PartialPivLU<Eigen::MatrixXf>(matrix.cast<float>())});
    for (const PetscInt row : rows) numbers[static_cast<std::size_t>(row)] = -1;
  }
}

template <int Dim>
Points<Dim> MarkerBlocks<Dim>::solve(const Points<Dim>& right) const {
  Points<Dim> result(right.size(), Point<Dim>::Zero());
  for (const Block& block : blocks_) {
    Eigen::VectorXf values(static_cast<int>(Dim * block.markers.size()));
    for (std::size_t i = 0; i < block.markers.size(); ++i)
      values.segment<Dim>(static_cast<int>(Dim * i)) = right[block.markers[i]].template cast<float>();
    const Eigen::VectorXf solved = block.factors.solve(values);
    for (std::size_t i = 0; i < block.markers.size(); ++i)
      result[block.markers[i]] = solved.segment<Dim>(static_cast<int>(Dim * i)).template cast<double>();
  }
  return result;
}

template class MarkerBlocks<2>;
template class MarkerBlocks<3>;

}  // namespace washfsi
