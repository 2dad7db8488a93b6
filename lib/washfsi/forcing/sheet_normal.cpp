// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/sheet_normal.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "washfsi/grid/index.hpp"

namespace washfsi {

template <int Dim>
Point<Dim> sheet_normal(const Shape<Dim>& shape, const Point<Dim>& place, double step) {
  Eigen::Matrix<double, Dim, Dim> moments = Eigen::Matrix<double, Dim, Dim>::Zero();
  Box<Dim> around;
  around.lower.fill(-1);
  around.upper.fill(2);
  for_each<Dim>(around, [&](const Index<Dim>& to) {
    Point<Dim> way;
    for (int d = 0; d < Dim; ++d) way[d] = static_cast<double>(to[d]);
    if (way.isZero(0)) return;
    way.normalize();
    moments += std::max(0.0, shape.distance(place + step * way)) * way * way.transpose();
  });
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Dim, Dim>>(moments).eigenvectors().col(Dim - 1);
}

template Point<2> sheet_normal<2>(const Shape<2>&, const Point<2>&, double);
template Point<3> sheet_normal<3>(const Shape<3>&, const Point<3>&, double);

}  // namespace washfsi
