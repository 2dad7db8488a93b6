// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/marker_layout/sheet_normal.hpp"

#include <algorithm>

#include "washfsi/grid/index.hpp"
#include "washfsi/support/eigensystem.hpp"

namespace washfsi {

namespace {

constexpr double step = 1.5;  // to either side [cells]

// Uses the ways out on both sides: on one side alone they may lead over an edge.
template <int Dim>
Point<Dim> main_way_out(const Shape<Dim>& shape, const Point<Dim>& place, const Point<Dim>& cell) {
  Eigen::Matrix<double, Dim, Dim> moments = Eigen::Matrix<double, Dim, Dim>::Zero();
  Box<Dim> around;
  around.lower.fill(-1);
  around.upper.fill(2);
  for_each<Dim>(around, [&](const Index<Dim>& to) {
    Point<Dim> way;
    for (int d = 0; d < Dim; ++d) way[d] = static_cast<double>(to[d]);
    if (way.isZero(0)) return;
    way = way.normalized().cwiseProduct(cell);
    const double outside = std::min(shape.distance(place + step * way), shape.distance(place - step * way));
    way.normalize();
    moments += std::max(0.0, outside) * way * way.transpose();
  });
  return eigensystem<Dim>(moments).vectors.col(Dim - 1);
}

}  // namespace

template <int Dim>
Point<Dim> sheet_normal(const Shape<Dim>& shape, const Point<Dim>& place, const Point<Dim>& cell) {
  const Point<Dim> way = main_way_out(shape, place, cell), out = step * way.cwiseProduct(cell).norm() * way;
  const double fine = 0.01 * cell.minCoeff();
  const Point<Dim> normal =
      distance_gradient<Dim>(shape, place + out, fine) - distance_gradient<Dim>(shape, place - out, fine);
  constexpr double opposite = 1.4;  // 2 where both ends lie before opposite faces
  return normal.dot(way) > opposite ? normal.normalized() : way;
}

template Point<2> sheet_normal<2>(const Shape<2>&, const Point<2>&, const Point<2>&);
template Point<3> sheet_normal<3>(const Shape<3>&, const Point<3>&, const Point<3>&);

}  // namespace washfsi
