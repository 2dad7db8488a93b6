// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/marker_layout/marker_retraction.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/eigensystem.hpp"

namespace washfsi {

namespace {

constexpr double no_slip_from = 0.3;  // mean depth of constrained faces beyond the constrained depth [cells]
constexpr double smooth_bend = 0.25;  // bend above which a place belongs to an edge [cells]
constexpr double eddies = 2.1;        // factor of stirred stress, from drag in creeping flow (cylinder, sphere)
constexpr double narrow = 1.5;        // radius in cells up to which eddies are left out
constexpr double most_stress = 0.6;   // largest stress, over that of the water before the markers
constexpr double farthest = 2;        // depth that is searched [cells]: deeper places do not matter

template <int Dim>
double largest_of(const Eigen::Matrix<double, Dim, Dim>& symmetric) {
  return eigensystem<Dim>(symmetric).values[Dim - 1];
}

}  // namespace

template <int Dim>
std::optional<Candidate<Dim>> MarkerRetraction<Dim>::retracted(const Point<Dim>& seed) const {
  const auto found = behind(seed, farthest);
  if (!found) return {};
  return is_in_sheet(*found) ? sheet_.retracted(found->inmost, found->normal) : on_face(*found);
}

template <int Dim>
std::optional<Candidate<Dim>> MarkerRetraction<Dim>::retracted_without_face(const Point<Dim>& seed) const {
  const auto found = behind(seed, layout_.moments.sheet_reach());
  if (!found) return {};
  if (is_in_sheet(*found)) return sheet_.retracted(found->inmost, found->normal);
  if (bending(curvatures(found->foot)) >= 0) return {};
  const auto in_corner = retracted(seed);
  return in_corner && in_corner->place == in_corner->foot ? in_corner : std::nullopt;
}

// Searches down to a depth in cells.
template <int Dim>
std::optional<typename MarkerRetraction<Dim>::Behind> MarkerRetraction<Dim>::behind(const Point<Dim>& seed,
                                                                                    double deepest) const {
  const double from_surface = shape_.distance(seed);
  if (from_surface < 0 || from_surface > reach * layout_.cell.maxCoeff()) return {};
  const Point<Dim> out = distance_gradient<Dim>(shape_, seed, fine * cell_);
  const std::optional<Point<Dim>> foot = foot_of(seed);
  if (!foot || out.norm() < 0.5) return {};
  const Point<Dim> normal = out.normalized();
  const double along = normal.cwiseProduct(layout_.cell).norm();
  const auto [inmost, depth] = inmost_behind(*foot, normal, along, deepest);
  return Behind{*foot, normal, inmost, depth, along};
}

template <int Dim>
Candidate<Dim> MarkerRetraction<Dim>::on_face(const Behind& behind) const {
  const auto& [foot, normal, inmost, depth, along] = behind;
  // at an edge the way is that between its faces
  const Point<Dim> inwards = -distance_gradient<Dim>(shape_, foot, coarse * cell_).normalized();
  const Curvatures bent = curvatures(foot);
  const double bend = bending(bent);
  double flat = along * layout_.moments.retraction(depth / along);
  const double inside = has_no_slip_behind(foot, inwards) ? no_slip_stress(flat, bend) : 0;
  const double stirred = layout_.inside.turns ? 0 : stirred_stress(largest_of<Dim>(bent), along);
  flat /= 1 - std::min(most_stress, flat * std::max(inside, stirred));
  return {foot + std::clamp(flat + bend, 0.0, depth) * inwards, foot,
          static_cast<int>(std::clamp(bend / (smooth_bend * cell_), 0.0, 2.0))};
}

template <int Dim>
bool MarkerRetraction<Dim>::has_no_slip_behind(const Point<Dim>& foot, const Point<Dim>& inwards) const {
  if (std::isinf(layout_.inside.constrained_depth)) return false;
  return -shape_.distance(foot + (layout_.inside.constrained_depth + no_slip_from * cell_) * inwards) >
         layout_.inside.constrained_depth;
}

// gamma for inner water that is sheared over the distance d = `straight` from the markers to the constrained water.
// Water behind markers slips at them as that before them does. Its shear stress, mu gamma times the slip, bends the
// velocity at the markers too, so that they act from farther off. With R = 1/`curvature` and y_m = `flat`,
//   gamma = (1 - d/R_m)^2/(d (1 - d/(2 R_m))),    R_m = R - y_m at the markers,    d/R_m = `bent`, at most 0.9
template <int Dim>
double MarkerRetraction<Dim>::no_slip_stress(double flat, double bend) const {
  const double curvature = 2 * bend / (layout_.moments.variance() * cell_ * cell_);
  const double straight = layout_.inside.constrained_depth + no_slip_from * cell_ - flat;
  const double bent = std::min(straight * curvature / (1 - flat * curvature), 0.9);
  return (1 - bent) * (1 - bent) / (straight * (1 - 0.5 * bent));  // stiffness of the equivalent plane layer
}

// gamma for a slip that varies round a bent surface and so stirs the water within: two eddies in a cylinder of radius R
// in creeping flow have gamma = 2/R. Left out for narrow bodies, whose markers act on each other's water.
template <int Dim>
double MarkerRetraction<Dim>::stirred_stress(double curvature, double along) const {
  if (curvature <= 0) return 0;
  return eddies * curvature * std::clamp(1 / (curvature * along) - narrow, 0.0, 1.0);
}

// Finds the foot by Newton's method; nothing where the shape's distance is no true distance.
template <int Dim>
std::optional<Point<Dim>> MarkerRetraction<Dim>::foot_of(const Point<Dim>& seed) const {
  Point<Dim> place = seed;
  for (int step = 0; step < 6; ++step) {
    const double distance = shape_.distance(place);
    if (std::abs(distance) < 1e-3 * cell_) return place;
    const Point<Dim> slope = distance_gradient<Dim>(shape_, place, fine * cell_);
    if (slope.norm() < 0.3) return {};
    place -= distance / slope.squaredNorm() * slope;
  }
  if (std::abs(shape_.distance(place)) < 0.02 * cell_) return place;
  return {};
}

// The deepest place on the way of steepest growth of the depth, and its depth; or a place at least so many cells deep.
template <int Dim>
std::pair<Point<Dim>, double> MarkerRetraction<Dim>::inmost_behind(const Point<Dim>& foot, const Point<Dim>& normal,
                                                                   double along, double deepest) const {
  constexpr double slowest = 0.3;  // least growth of the depth; below, the way runs along a sheet's middle
  const double step = 0.1 * along;
  Point<Dim> inmost = foot, way = -normal;
  double depth = 0;
  bool slow = false;
  for (int n = 0; n * step < farthest * along && depth < deepest * along; ++n) {
    const Point<Dim> next = inmost + step * way;
    const double deeper = -shape_.distance(next);
    const bool slower = deeper <= depth + slowest * step;
    if (slow && slower) break;
    slow = slower;
    inmost = slow ? refined(inmost, way, step) : next;  // at a ridge, along which the way may continue
    depth = std::max(depth, -shape_.distance(inmost));
    const Point<Dim> slope = distance_gradient<Dim>(shape_, inmost, coarse * cell_);
    if (slope.norm() > 0.1) way = -slope.normalized();
  }
  return {inmost, depth};
}

// The place of largest depth between a place and the next step, where both sides are equally near.
template <int Dim>
Point<Dim> MarkerRetraction<Dim>::refined(const Point<Dim>& place, const Point<Dim>& way, double step) const {
  const double here = -shape_.distance(place), there = -shape_.distance(place + step * way);
  return place + std::clamp(0.5 * (step + there - here), 0.0, step) * way;
}

// Second differences of the distance over a cell [1/m].
template <int Dim>
typename MarkerRetraction<Dim>::Curvatures MarkerRetraction<Dim>::curvatures(const Point<Dim>& foot) const {
  const auto distance = [&](const Point<Dim>& aside) { return shape_.distance(foot + aside); };
  Curvatures result;
  for (int d = 0; d < Dim; ++d)
    for (int e = 0; e <= d; ++e) {
      const Point<Dim> a = layout_.cell[d] * Point<Dim>::Unit(d), b = layout_.cell[e] * Point<Dim>::Unit(e);
      const double sum = d == e ? distance(a) + distance(-a) - 2 * distance(Point<Dim>::Zero())
                                : (distance(a + b) + distance(-a - b) - distance(a - b) - distance(b - a)) / 4;
      result(d, e) = result(e, d) = sum / (layout_.cell[d] * layout_.cell[e]);
    }
  return result;
}

// 1/2 sum_d var phi h_d^2 d2Phi/dx_d2 [m]
template <int Dim>
double MarkerRetraction<Dim>::bending(const Curvatures& curvatures) const {
  double sum = 0;
  for (int d = 0; d < Dim; ++d) sum += layout_.cell[d] * layout_.cell[d] * curvatures(d, d);
  return 0.5 * layout_.moments.variance() * sum;
}

template class MarkerRetraction<2>;
template class MarkerRetraction<3>;

}  // namespace washfsi
