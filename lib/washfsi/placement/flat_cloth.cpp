// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/placement/flat_cloth.hpp"

#include <limits>
#include <vector>

#include <Eigen/QR>

namespace washfsi {

// |A u - c| is least with each coordinate u at -1, at 1 or free between them: the least over all such choices whose
// free coordinates stay within. Where free ones are not determined (parallel cloths) another choice is as good.
template <int Dim>
double distance(const FlatCloth<Dim>& a, const FlatCloth<Dim>& b) {
  constexpr int each = FlatCloth<Dim>::directions, unknowns = 2 * each;
  const Point<Dim> apart = b.middle - a.middle;
  const double reach = a.half.norm() + b.half.norm();
  if (apart.norm() > 4 * reach) return apart.norm() - reach;  // far: a lower bound will do
  Eigen::MatrixXd matrix(Dim, unknowns);
  for (int d = 0; d < each; ++d) {
    matrix.col(d) = a.half[d] * a.axes.col(d);
    matrix.col(each + d) = -b.half[d] * b.axes.col(d);
  }
  int choices = 1;
  for (int u = 0; u < unknowns; ++u) choices *= 3;
  double least = std::numeric_limits<double>::infinity();
  for (int choice = 0; choice < choices; ++choice) {
    Eigen::VectorXd rest = apart;
    std::vector<int> free;
    for (int u = 0, code = choice; u < unknowns; ++u, code /= 3)
      if (code % 3 == 2)
        free.push_back(u);
      else
        rest -= (code % 3 == 0 ? -1.0 : 1.0) * matrix.col(u);
    if (!free.empty()) {
      Eigen::MatrixXd columns(Dim, static_cast<Eigen::Index>(free.size()));
      for (std::size_t f = 0; f < free.size(); ++f) columns.col(static_cast<Eigen::Index>(f)) = matrix.col(free[f]);
      const Eigen::VectorXd place = columns.completeOrthogonalDecomposition().solve(rest);
      if (place.cwiseAbs().maxCoeff() > 1) continue;
      rest -= columns * place;
    }
    least = std::min(least, rest.norm());
  }
  return least;
}

template double distance<2>(const FlatCloth<2>&, const FlatCloth<2>&);
template double distance<3>(const FlatCloth<3>&, const FlatCloth<3>&);

}  // namespace washfsi
