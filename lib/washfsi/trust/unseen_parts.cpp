// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/trust/unseen_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

template <int Dim>
using Parts = std::vector<typename Shape<Dim>::Part>;

// Least distance of the middles of cells from the surface of any of some parts, with the body in a pose [m].
template <int Dim>
double nearest_to(const Grid<Dim>& grid, const Pose<Dim>& pose, const Parts<Dim>& parts) {
  double nearest = std::numeric_limits<double>::max();
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    const Point<Dim> place = pose.in_body_frame(grid.cell_center(cell));
    for (const auto& part : parts)
      nearest = std::min(nearest, std::abs(part.shape->distance(part.pose.in_body_frame(place))));
  });
  return -largest(grid.comm(), -nearest);
}

// The poses of a turning body that are checked.
template <int Dim>
std::vector<Pose<Dim>> poses_of(const Body<Dim>& body, double time) {
  constexpr int directions = 16;
  std::vector<Pose<Dim>> poses{body.motion.pose(time)};
  for (int n = 1; n < directions && !body.motion.at_rest(); ++n)
    poses.push_back(
        Pose<Dim>::at(body.motion.center_at(time), body.motion.angle(time) + 2 * std::numbers::pi * n / directions));
  return poses;
}

}  // namespace

template <int Dim>
std::vector<UnseenPart> unseen_parts(const Grid<Dim>& grid, const Body<Dim>& body, double time) {
  if (!body.motion.only_turns()) return {};
  Parts<Dim> all;
  body.shape->add_parts({}, all);
  std::map<std::string, Parts<Dim>> by_name;  // copies of a part are checked together
  for (const auto& part : all) by_name[part.shape->name].push_back(part);
  std::vector<UnseenPart> unseen;
  const double beside = 0.5 * grid.spacing().norm();
  for (const auto& [name, parts] : by_name) {
    double nearest = std::numeric_limits<double>::max();
    for (const Pose<Dim>& pose : poses_of(body, time)) {
      nearest = std::min(nearest, nearest_to<Dim>(grid, pose, parts));
      if (nearest <= beside) break;
    }
    if (nearest > beside) unseen.push_back({name, parts.front().shape->is_inverted(), nearest});
  }
  return unseen;
}

template std::vector<UnseenPart> unseen_parts<2>(const Grid<2>&, const Body<2>&, double);
template std::vector<UnseenPart> unseen_parts<3>(const Grid<3>&, const Body<3>&, double);

}  // namespace washfsi
