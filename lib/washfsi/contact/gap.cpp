// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/gap.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

template <int Dim>
double part_along(const Point<Dim>& from, const Point<Dim>& to, const Point<Dim>& place) {
  const Point<Dim> edge = to - from;
  const double length2 = edge.squaredNorm();
  return length2 > 0 ? std::clamp(edge.dot(place - from) / length2, 0.0, 1.0) : 0;
}

namespace {

template <int Dim>
using Shares = std::array<double, pair_markers<Dim>>;

template <int Dim>
Point<Dim> way_of(const Shares<Dim>& shares, const PairPoints<Dim>& places) {
  Point<Dim> way = Point<Dim>::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) way += shares[i] * places[i];
  return way;
}

// Shares of the first marker with the edge between two others.
template <int Dim>
Shares<Dim> point_edge(const PairPoints<Dim>& places, std::size_t from, std::size_t to) {
  const double part = part_along<Dim>(places[from], places[to], places[0]);
  Shares<Dim> shares{};
  shares[0] = 1;
  shares[from] = part - 1;
  shares[to] = -part;
  return shares;
}

template <int Dim>
void keep_shorter(const Shares<Dim>& shares, const PairPoints<Dim>& places, Shares<Dim>& best) {
  if (way_of<Dim>(shares, places).squaredNorm() < way_of<Dim>(best, places).squaredNorm()) best = shares;
}

// The foot on the triangle's plane if that lies inside, else the nearest of its edges.
Shares<3> point_triangle(const PairPoints<3>& x) {
  const Point<3> a = x[2] - x[1], b = x[3] - x[1], arm = x[0] - x[1], normal = a.cross(b);
  const double area2 = normal.squaredNorm();
  if (area2 > 0) {
    const double to_b = normal.dot(a.cross(arm)) / area2, to_a = normal.dot(arm.cross(b)) / area2;
    if (to_a >= 0 && to_b >= 0 && to_a + to_b <= 1) return {1, to_a + to_b - 1, -to_a, -to_b};
  }
  Shares<3> best = point_edge<3>(x, 1, 2);
  keep_shorter<3>(point_edge<3>(x, 2, 3), x, best);
  keep_shorter<3>(point_edge<3>(x, 3, 1), x, best);
  return best;
}

Shares<3> shares_along(double first, double second) {
  return {1 - first, first, second - 1, -second};
}

// The common perpendicular if both of its feet lie inside, else the nearest of the ends.
Shares<3> edge_edge(const PairPoints<3>& x) {
  const Point<3> e = x[1] - x[0], f = x[3] - x[2], arm = x[0] - x[2];
  const double ee = e.squaredNorm(), ff = f.squaredNorm(), ef = e.dot(f), determinant = ee * ff - ef * ef;
  if (determinant > 1e-12 * ee * ff) {
    const double first = (ef * f.dot(arm) - ff * e.dot(arm)) / determinant;
    const double second = (ee * f.dot(arm) - ef * e.dot(arm)) / determinant;
    if (first >= 0 && first <= 1 && second >= 0 && second <= 1) return shares_along(first, second);
  }
  Shares<3> best = shares_along(0, part_along<3>(x[2], x[3], x[0]));
  keep_shorter<3>(shares_along(1, part_along<3>(x[2], x[3], x[1])), x, best);
  keep_shorter<3>(shares_along(part_along<3>(x[0], x[1], x[2]), 0), x, best);
  keep_shorter<3>(shares_along(part_along<3>(x[0], x[1], x[3]), 1), x, best);
  return best;
}

template <int Dim>
Shares<Dim> shares_of(PairKind kind, const PairPoints<Dim>& places) {
  if constexpr (Dim == 2)
    return point_edge<2>(places, 1, 2);
  else
    return kind == PairKind::edge_edge ? edge_edge(places) : point_triangle(places);
}

}  // namespace

template <int Dim>
Gap<Dim> gap_of(PairKind kind, const PairPoints<Dim>& places) {
  const Shares<Dim> shares = shares_of<Dim>(kind, places);
  const Point<Dim> way = way_of<Dim>(shares, places);
  const double distance = way.norm();
  return {distance, distance > 0 ? Point<Dim>(way / distance) : Point<Dim>(Point<Dim>::Unit(0)), shares};
}

template double part_along<2>(const Point<2>&, const Point<2>&, const Point<2>&);
template double part_along<3>(const Point<3>&, const Point<3>&, const Point<3>&);
template Gap<2> gap_of<2>(PairKind, const PairPoints<2>&);
template Gap<3> gap_of<3>(PairKind, const PairPoints<3>&);

}  // namespace washfsi
