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
  Eigen::SparseMatrix<double> overlaps;
  Eigen::VectorXd sums;  ///< of their rows
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky;

  static Values values(const Points<Dim>& points) {
    Values result(static_cast<Eigen::Index>(points.size()), Dim);
    for (std::size_t p = 0; p < points.size(); ++p) result.row(static_cast<Eigen::Index>(p)) = points[p];
    return result;
  }
  static Points<Dim> points(const Values& values) {
    Points<Dim> result(static_cast<std::size_t>(values.rows()));
    for (std::size_t p = 0; p < result.size(); ++p) result[p] = values.row(static_cast<Eigen::Index>(p));
    return result;
  }
};

template <int Dim>
OverlapInverse<Dim>::OverlapInverse(const MarkerPatches<Dim>& patches, const MarkerLayout<Dim>& layout)
    : factor_(std::make_unique<Factor>()) {
  const PatchOverlap<Dim> overlap(patches, layout);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const auto& [other, value] : overlap.row(p))
      entries.emplace_back(static_cast<int>(p), static_cast<int>(other), value);
  const auto size = static_cast<Eigen::Index>(patches.size());
  factor_->overlaps.resize(size, size);
  factor_->overlaps.setFromTriplets(entries.begin(), entries.end());
  factor_->sums = factor_->overlaps * Eigen::VectorXd::Ones(size);
  Eigen::SparseMatrix<double> raised = factor_->overlaps;
  for (Eigen::Index p = 0; p < size; ++p) raised.coeffRef(p, p) += added * factor_->sums[p];
  factor_->cholesky.compute(raised);
}

template <int Dim>
OverlapInverse<Dim>::~OverlapInverse() = default;
template <int Dim>
OverlapInverse<Dim>::OverlapInverse(OverlapInverse&&) noexcept = default;

namespace {

Eigen::Index first(PatchRange range) {
  return static_cast<Eigen::Index>(range.begin);
}

Eigen::Index count(PatchRange range) {
  return static_cast<Eigen::Index>(range.end - range.begin);
}

}  // namespace

template <int Dim>
Points<Dim> OverlapInverse<Dim>::operator()(const Points<Dim>& velocities, PatchRange wanted) const {
  const typename Factor::Values forces = factor_->cholesky.solve(Factor::values(velocities));
  return Factor::points(forces.middleRows(first(wanted), count(wanted)));
}

template <int Dim>
Points<Dim> OverlapInverse<Dim>::means_about(const Points<Dim>& values, PatchRange wanted) const {
  const auto columns = factor_->overlaps.middleCols(first(wanted), count(wanted));  // which are rows too
  const typename Factor::Values sums = columns.transpose() * Factor::values(values);
  return Factor::points(factor_->sums.segment(first(wanted), count(wanted)).asDiagonal().inverse() * sums);
}

template class OverlapInverse<2>;
template class OverlapInverse<3>;

}  // namespace washfsi
