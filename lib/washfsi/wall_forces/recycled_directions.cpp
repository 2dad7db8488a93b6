// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_forces/recycled_directions.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Tikhonov's regularisation, added to the diagonal of the normal equations: combinations of nearly equal directions
// would be large forces to which the water hardly responds.
constexpr double regularisation = 0.1;

template <int Dim>
double product(const Points<Dim>& a, const Points<Dim>& b) {
  double sum = 0;
  for (std::size_t p = 0; p < a.size(); ++p) sum += a[p].dot(b[p]);
  return sum;
}

}  // namespace

template <int Dim>
void RecycledDirections<Dim>::add(Direction direction) {
  Points<Dim> filtered = overlap_.means_about(direction.responses);
  directions_.push_front({std::move(direction), std::move(filtered)});
  if (directions_.size() > most) directions_.pop_back();
}

// Least squares by the normal equations, with responses scaled to unit norm. LDLT reads their lower half only.
template <int Dim>
std::vector<double> RecycledDirections<Dim>::weights_for(const Points<Dim>& slips) const {
  const Points<Dim> filtered = overlap_.means_about(slips);
  const std::size_t size = directions_.size();
  std::vector<double> products(size * (size + 1), 0.0);
  for (std::size_t k = 0; k < size; ++k) {
    double* row = &products[k * (size + 1)];
    for (std::size_t other = 0; other <= k; ++other)
      row[other] = product<Dim>(directions_[k].responses, directions_[other].responses);
    row[size] = product<Dim>(directions_[k].responses, filtered);
  }
  products = ordered_sum(comm_, products);
  const auto count = static_cast<Eigen::Index>(size);
  using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Table> table(products.data(), count, count + 1);
  const Eigen::VectorXd scale =
      table.leftCols(count).diagonal().unaryExpr([](double square) { return square > 0 ? 1 / std::sqrt(square) : 0; });
  Eigen::MatrixXd normal = scale.asDiagonal() * table.leftCols(count) * scale.asDiagonal();
  normal.diagonal().array() += regularisation;
  const Eigen::VectorXd weights = scale.cwiseProduct(normal.ldlt().solve(scale.cwiseProduct(table.col(count))));
  return {weights.begin(), weights.end()};
}

template <int Dim>
typename RecycledDirections<Dim>::Direction RecycledDirections<Dim>::best_for(const Points<Dim>& slips) const {
  Direction best{Points<Dim>(slips.size(), Point<Dim>::Zero()), Points<Dim>(slips.size(), Point<Dim>::Zero())};
  if (directions_.empty()) return best;
  const std::vector<double> weights = weights_for(slips);
  for (std::size_t k = 0; k < directions_.size(); ++k) {
    best.impulses += weights[k] * directions_[k].direction.impulses;
    best.responses += weights[k] * directions_[k].direction.responses;
  }
  return best;
}

// Returns `most` directions for each patch, missing ones as zeros.
template <int Dim>
Points<Dim> RecycledDirections<Dim>::stored(std::size_t patches) const {
  Points<Dim> stored(2 * most * patches, Point<Dim>::Zero());
  for (std::size_t p = 0; p < patches; ++p)
    for (std::size_t k = 0; k < directions_.size(); ++k) {
      stored[2 * (most * p + k)] = directions_[k].direction.impulses[p];
      stored[2 * (most * p + k) + 1] = directions_[k].direction.responses[p];
    }
  return stored;
}

template <int Dim>
void RecycledDirections<Dim>::restore(const Points<Dim>& stored) {
  directions_.clear();
  for (std::size_t k = stored_size_; k-- > 0;) {
    Direction direction;
    for (std::size_t n = 2 * k; n < stored.size(); n += 2 * most) {
      direction.impulses.push_back(stored[n]);
      direction.responses.push_back(stored[n + 1]);
    }
    add(std::move(direction));
  }
}

template <int Dim>
void RecycledDirections<Dim>::register_state(StateList& state, PatchRange own, std::size_t patches) {
  StateEntry& size = state.add_number("/walls/direction_count", stored_size_);
  size.get = [this] { return StateEntry::Values{static_cast<double>(directions_.size())}; };
  size.if_other = StateEntry::IfOther::begin_anew;
  constexpr std::size_t rows = 2 * most;
  state.add({.name = "/walls/directions",
             .slab = row_slab(rows * patches, rows * own.begin, rows * own.end, Dim),
             .get = [this, own] { return flattened<Dim>(stored(own.size())); },
             .set = [this](const StateEntry::Values& values) { restore(as_points<Dim>(values)); },
             .if_other = StateEntry::IfOther::begin_anew});
}

template class RecycledDirections<2>;
template class RecycledDirections<3>;

}  // namespace washfsi
