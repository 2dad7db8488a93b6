// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/overlap_inverse.hpp"

#include <map>

#include <Eigen/SparseCholesky>

#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

namespace {

constexpr double added = 0.3;  // to the diagonal, over the sum of its row

/// The mean overlap of the deltas of two patches' markers.
template <int Dim>
class PatchOverlap {
 public:
  PatchOverlap(const MarkerPatches<Dim>& patches, const MarkerLayout<Dim>& layout)
      : patches_(patches),
        layout_(layout),
        reach_(2 * layout.moments.width() * layout.cell),
        search_(bounds_of(patches.markers), reach_, hull(bounds_of(patches.markers))) {
    for (std::size_t p = 0; p < patches.size(); ++p) patch_of_.resize(patches.starts[p + 1], p);
  }

  /// With all patches that it touches.
  std::map<std::size_t, double> row(std::size_t patch) const {
    std::map<std::size_t, double> row;
    for (std::size_t m = patches_.starts[patch]; m < patches_.starts[patch + 1]; ++m)
      for (const std::size_t other : search_.near(Bounds<Dim>::round(patches_.markers[m], reach_))) {
        const double value = share(patch) * share(patch_of_[other]) * of_markers(m, other);
        if (value != 0) row[patch_of_[other]] += value;
      }
    return row;
  }

 private:
  double share(std::size_t patch) const {
    return 1.0 / static_cast<double>(patches_.starts[patch + 1] - patches_.starts[patch]);
  }
  double of_markers(std::size_t a, std::size_t b) const {
    const Point<Dim> shift = (patches_.markers[a] - patches_.markers[b]).cwiseQuotient(layout_.cell);
    double value = 1;
    for (int d = 0; d < Dim; ++d) value *= layout_.moments.overlap(shift[d]);
    return value;
  }

  const MarkerPatches<Dim>& patches_;
  const MarkerLayout<Dim>& layout_;
  Point<Dim> reach_;
  NearSearch<Dim> search_;
  std::vector<std::size_t> patch_of_;  ///< of each marker
};

}  // namespace

template <int Dim>
struct OverlapInverse<Dim>::Factor {
  using Values = Eigen::Matrix<double, Eigen::Dynamic, Dim>;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky;
};

template <int Dim>
OverlapInverse<Dim>::OverlapInverse(const MarkerPatches<Dim>& patches, const MarkerLayout<Dim>& layout)
    : factor_(std::make_unique<Factor>()) {
  const PatchOverlap<Dim> overlap(patches, layout);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    double sum = 0;
    for (const auto& [other, value] : overlap.row(p)) {
      sum += value;
      entries.emplace_back(static_cast<int>(p), static_cast<int>(other), value);
    }
    entries.emplace_back(static_cast<int>(p), static_cast<int>(p), added * sum);
  }
  const auto size = static_cast<Eigen::Index>(patches.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_->cholesky.compute(matrix);
}

template <int Dim>
OverlapInverse<Dim>::~OverlapInverse() = default;
template <int Dim>
OverlapInverse<Dim>::OverlapInverse(OverlapInverse&&) noexcept = default;

template <int Dim>
Points<Dim> OverlapInverse<Dim>::operator()(const Points<Dim>& velocities) const {
  typename Factor::Values right(static_cast<Eigen::Index>(velocities.size()), Dim);
  for (std::size_t m = 0; m < velocities.size(); ++m) right.row(static_cast<Eigen::Index>(m)) = velocities[m];
  const typename Factor::Values solution = factor_->cholesky.solve(right);
  Points<Dim> forces(velocities.size());
  for (std::size_t m = 0; m < forces.size(); ++m) forces[m] = solution.row(static_cast<Eigen::Index>(m));
  return forces;
}

template class OverlapInverse<2>;
template class OverlapInverse<3>;

}  // namespace washfsi
