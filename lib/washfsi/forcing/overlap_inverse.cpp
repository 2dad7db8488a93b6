// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/overlap_inverse.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/SparseCholesky>

#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

namespace {

constexpr int places_a_cell = 50;  // of a table

constexpr double least_eigenvalue = 0.3;  // of the overlap, over its largest row sum

}  // namespace

AxisOverlap::AxisOverlap(const DeltaOptions& delta) {
  constexpr int points = 20;
  const double reach = delta.spread_width + delta.interpolate_width;
  for (int n = 0; n <= static_cast<int>(reach) * places_a_cell; ++n) {
    const double shift = static_cast<double>(n) / places_a_cell;
    double sum = 0;
    for (int i = -points * 4; i <= points * 4; ++i) {
      const double s = static_cast<double>(i) / points;
      sum += regularised_delta(delta.kernel, s, delta.spread_width) *
             regularised_delta(delta.kernel, s + shift, delta.interpolate_width) / points;
    }
    values_.push_back(sum);
  }
}

double AxisOverlap::operator()(double shift) const {
  const double place = std::abs(shift) * places_a_cell;
  const auto n = static_cast<std::size_t>(place);
  if (n + 1 >= values_.size()) return 0;
  return values_[n] + (place - static_cast<double>(n)) * (values_[n + 1] - values_[n]);
}

template <int Dim>
struct OverlapInverse<Dim>::Factor {
  using Values = Eigen::Matrix<double, Eigen::Dynamic, Dim>;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky;
};

template <int Dim>
OverlapInverse<Dim>::OverlapInverse(const MarkerPatches<Dim>& patches, const Point<Dim>& cell,
                                    const DeltaOptions& delta)
    : factor_(std::make_unique<Factor>()) {
  const AxisOverlap overlap(delta);
  const Point<Dim> reach = (delta.spread_width + delta.interpolate_width) * cell;
  std::vector<Bounds<Dim>> places;
  std::vector<std::size_t> patch_of;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t m = patches.starts[p]; m < patches.starts[p + 1]; ++m) {
      places.push_back(Bounds<Dim>::round(patches.markers[m], Point<Dim>::Zero()));
      patch_of.push_back(p);
    }
  const auto share = [&](std::size_t p) {
    return 1.0 / static_cast<double>(patches.starts[p + 1] - patches.starts[p]);
  };
  const NearSearch<Dim> search(places, reach, hull(places));
  std::vector<Eigen::Triplet<double>> entries;
  double largest_sum = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    std::map<std::size_t, double> row;
    for (std::size_t m = patches.starts[p]; m < patches.starts[p + 1]; ++m)
      for (const std::size_t other : search.near(Bounds<Dim>::round(patches.markers[m], reach))) {
        double value = share(p) * share(patch_of[other]);
        for (int d = 0; d < Dim; ++d) value *= overlap((patches.markers[m][d] - patches.markers[other][d]) / cell[d]);
        if (value != 0) row[patch_of[other]] += value;
      }
    double sum = 0;
    for (const auto& [other, value] : row) {
      sum += value;
      entries.emplace_back(static_cast<int>(p), static_cast<int>(other), value);
    }
    largest_sum = std::max(largest_sum, sum);
  }
  for (std::size_t p = 0; p < patches.size(); ++p)
    entries.emplace_back(static_cast<int>(p), static_cast<int>(p), least_eigenvalue * largest_sum);
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
