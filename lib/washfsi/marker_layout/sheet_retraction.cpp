// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/marker_layout/sheet_retraction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "washfsi/marker_layout/sheet_normal.hpp"

namespace washfsi {

namespace {

constexpr double no_slip_edges = 0.15;  // reach of no-slip sheets beyond the shares of their outermost markers [cells]
constexpr double sliding_edges = 0.35;  // the same where water slides along them, calibrated by a turbine
constexpr int directions = 8;           // directions tried along a sheet, in half a turn

// Two edges that meet are a corner.
template <int Dim>
int sharpness(const Points<Dim>& edges) {
  for (const Point<Dim>& edge : edges)
    if (std::abs(edge.dot(edges.front())) < 0.8) return 2;
  return edges.empty() ? 0 : 1;
}

template <int Dim>
Points<Dim> tangents(const Point<Dim>& normal) {
  if constexpr (Dim == 2) return {turned_left<2>(normal)};
  Points<Dim> result;
  if constexpr (Dim == 3) {
    const Point<3> first = normal.unitOrthogonal(), second = normal.cross(first);
    for (int n = 0; n < directions; ++n) {
      const double angle = std::numbers::pi * n / directions;
      result.push_back(std::cos(angle) * first + std::sin(angle) * second);
    }
  }
  return result;
}

}  // namespace

// A sheet of markers acts beyond its edges as it acts before its faces: a place nearer to an edge than that, or found
// from the edge's own face, is moved to the outline that the sheet may fill, or to the middle of a narrower sheet.
template <int Dim>
Candidate<Dim> SheetRetraction<Dim>::retracted(Point<Dim> place, const Point<Dim>& out) const {
  place = centred(place, sheet_normal<Dim>(shape_, place, layout_.cell));  // off the middle the normal is uncertain
  const Point<Dim> normal = sheet_normal<Dim>(shape_, place, layout_.cell);
  place = centred(place, normal);
  const Point<Dim> along_sheet = out - out.dot(normal) * normal;
  Points<Dim> edges;  // ways to the edges
  if (along_sheet.norm() > 0.7 && keep_within(place, along_sheet.normalized(), true))
    edges.push_back(along_sheet.normalized());
  for (int corner = 0; corner < 3; ++corner) {
    const Point<Dim> way = to_nearest_edge(place, normal);
    if (!keep_within(place, way, false)) break;
    edges.push_back(way);
  }
  if (!edges.empty()) place = centred(place, normal);
  return {place, place, sharpness<Dim>(edges)};
}

// Finds the direction along a sheet in which it ends soonest.
template <int Dim>
Point<Dim> SheetRetraction<Dim>::to_nearest_edge(const Point<Dim>& place, const Point<Dim>& normal) const {
  Point<Dim> nearest = Point<Dim>::Zero();
  double least = std::numeric_limits<double>::max();
  const auto look = [&](const Point<Dim>& way) {
    const double along = way.cwiseProduct(layout_.cell).norm();
    const double ahead = extent(place, way, 2 * beyond_edges(along), along);
    if (ahead >= least) return;
    least = ahead;
    nearest = way;
  };
  for (const Point<Dim>& tangent : tangents<Dim>(normal)) {
    look(tangent);
    look(-tangent);
  }
  if constexpr (Dim == 3)
    for (int halvings = 1; halvings <= 3; ++halvings) {  // to a fortieth of a turn
      const Point<Dim> aside = std::tan(std::numbers::pi / directions / (1 << halvings)) * normal.cross(nearest);
      const Point<Dim> left = (nearest + aside).normalized(), right = (nearest - aside).normalized();
      look(left);
      look(right);
    }
  return nearest;
}

// Reach of the outermost markers of a sheet beyond themselves: half of their spacing, for which they stand, and more.
template <int Dim>
double SheetRetraction<Dim>::beyond_edges(double along) const {
  return (0.5 * sheet_mean_spacing<Dim> + (layout_.inner_water_slides ? sliding_edges : no_slip_edges)) * along;
}

// Moves a place back from an edge ahead, or from anywhere to it; returns whether it did.
template <int Dim>
bool SheetRetraction<Dim>::keep_within(Point<Dim>& place, const Point<Dim>& way, bool to_edge) const {
  const double along = way.cwiseProduct(layout_.cell).norm();
  const double sheet = beyond_edges(along), most = sheet + along * layout_.moments.sheet_reach();
  const double ahead = extent(place, way, most, along);
  if (to_edge ? ahead == most : ahead >= sheet) return false;
  if (ahead >= sheet) {
    place += (ahead - sheet) * way;
    return true;
  }
  const double behind = extent(place, -way, most, along);
  place -= std::min(sheet - ahead, std::max(0.0, behind - ahead) / 2) * way;
  return true;
}

// Moves a place midway between the two faces of a sheet.
template <int Dim>
Point<Dim> SheetRetraction<Dim>::centred(const Point<Dim>& place, const Point<Dim>& normal) const {
  const double along = normal.cwiseProduct(layout_.cell).norm();
  return place + 0.5 * (extent(place, normal, along, along) - extent(place, -normal, along, along)) * normal;
}

// Distance from a place in a sheet to the sheet's end in a direction.
template <int Dim>
double SheetRetraction<Dim>::extent(const Point<Dim>& place, const Point<Dim>& tangent, double most,
                                    double along) const {
  const double aside = 0.1 * along;  // allowance for a bent sheet
  double low = 0, high = most + aside;
  const auto beyond = [&](double way) { return shape_.distance(place + way * tangent) > aside; };
  for (int n = 1; n <= 8; ++n)
    if (beyond(n * high / 8)) {
      low = (n - 1) * high / 8;
      high = n * high / 8;
      for (int halving = 0; halving < 8; ++halving) {
        const double middle = 0.5 * (low + high);
        (beyond(middle) ? high : low) = middle;
      }
      return std::max(0.0, low - aside);
    }
  return most;
}

template class SheetRetraction<2>;
template class SheetRetraction<3>;

}  // namespace washfsi
