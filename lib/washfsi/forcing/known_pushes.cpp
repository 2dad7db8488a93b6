// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/known_pushes.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Added to the squares: what pushes that are nearly alike differ by says little, and a combination that makes much of
// it is a large force that the water hardly feels.
constexpr double doubt = 0.1;

template <int Dim>
double product(const Points<Dim>& a, const Points<Dim>& b) {
  double sum = 0;
  for (std::size_t p = 0; p < a.size(); ++p) sum += a[p].dot(b[p]);
  return sum;
}

}  // namespace

template <int Dim>
void KnownPushes<Dim>::add(Push push) {
  Points<Dim> felt = overlap_.means_about(push.answers);
  known_.push_front({std::move(push), std::move(felt)});
  if (known_.size() > most) known_.pop_back();
}

// Least squares, by the normal equations of answers of unit size. The solver looks at their lower half alone.
template <int Dim>
std::vector<double> KnownPushes<Dim>::weights_for(const Points<Dim>& slips) const {
  const Points<Dim> felt = overlap_.means_about(slips);
  const std::size_t size = known_.size();
  std::vector<double> products(size * (size + 1), 0.0);
  for (std::size_t k = 0; k < size; ++k) {
    double* row = &products[k * (size + 1)];
    for (std::size_t other = 0; other <= k; ++other) row[other] = product<Dim>(known_[k].felt, known_[other].felt);
    row[size] = product<Dim>(known_[k].felt, felt);
  }
  products = ordered_sum(comm_, products);
  const auto count = static_cast<Eigen::Index>(size);
  using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Table> table(products.data(), count, count + 1);
  const Eigen::VectorXd scale =
      table.leftCols(count).diagonal().unaryExpr([](double square) { return square > 0 ? 1 / std::sqrt(square) : 0; });
  Eigen::MatrixXd normal = scale.asDiagonal() * table.leftCols(count) * scale.asDiagonal();
  normal.diagonal().array() += doubt;
  const Eigen::VectorXd weights = scale.cwiseProduct(normal.ldlt().solve(scale.cwiseProduct(table.col(count))));
  return {weights.begin(), weights.end()};
}

template <int Dim>
typename KnownPushes<Dim>::Push KnownPushes<Dim>::best_for(const Points<Dim>& slips) const {
  Push best{Points<Dim>(slips.size(), Point<Dim>::Zero()), Points<Dim>(slips.size(), Point<Dim>::Zero())};
  if (known_.empty()) return best;
  const std::vector<double> weights = weights_for(slips);
  for (std::size_t k = 0; k < known_.size(); ++k) {
    best.impulses += weights[k] * known_[k].push.impulses;
    best.answers += weights[k] * known_[k].push.answers;
  }
  return best;
}

template <int Dim>
Points<Dim> KnownPushes<Dim>::kept() const {
  Points<Dim> kept;
  const std::size_t patches = known_.empty() ? 0 : known_[0].felt.size();
  for (std::size_t p = 0; p < patches; ++p)
    for (const Known& known : known_) kept.insert(kept.end(), {known.push.impulses[p], known.push.answers[p]});
  return kept;
}

template <int Dim>
void KnownPushes<Dim>::take(const Points<Dim>& kept, std::size_t pushes) {
  known_.clear();
  for (std::size_t k = pushes; k-- > 0;) {
    Push push;
    for (std::size_t n = 2 * k; n < kept.size(); n += 2 * pushes) {
      push.impulses.push_back(kept[n]);
      push.answers.push_back(kept[n + 1]);
    }
    add(std::move(push));
  }
}

template class KnownPushes<2>;
template class KnownPushes<3>;

}  // namespace washfsi
