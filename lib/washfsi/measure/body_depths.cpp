// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/body_depths.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "washfsi/support/format_text.hpp"
#include "washfsi/support/of_all_ranks.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

namespace {

constexpr double least_part = 1e-3, part_inside = 0.1;  // tolerances over a face's size

template <int Dim, std::size_t Count>
Point<Dim> middle_of(const std::array<Point<Dim>, Count>& corners) {
  Point<Dim> sum = Point<Dim>::Zero();
  for (const auto& corner : corners) sum += corner;
  return sum / static_cast<double>(Count);
}

template <int Dim, std::size_t Count>
double reach_from(const Point<Dim>& middle, const std::array<Point<Dim>, Count>& corners) {
  double reach = 0;
  for (const auto& corner : corners) reach = std::max(reach, (corner - middle).norm());
  return reach;
}

// Halves a face across its longest side.
template <int Dim, std::size_t Count>
std::array<std::array<Point<Dim>, Count>, 2> halves(const std::array<Point<Dim>, Count>& corners) {
  std::size_t first = 0, second = 1;
  for (std::size_t i = 0; i < Count; ++i)
    for (std::size_t j = i + 1; j < Count; ++j)
      if ((corners[i] - corners[j]).norm() > (corners[first] - corners[second]).norm()) first = i, second = j;
  std::array<std::array<Point<Dim>, Count>, 2> parts{corners, corners};
  parts[0][second] = parts[1][first] = 0.5 * (corners[first] + corners[second]);
  return parts;
}

template <int Dim>
struct Depth {
  double depth = 0;  ///< [m]
  Point<Dim> place = Point<Dim>::Zero();
};

/// The deepest place of a face or an edge by distance(place), negative inside.
template <int Dim, std::size_t Count, class Distance>
Depth<Dim> depth_of(const std::array<Point<Dim>, Count>& face, const Distance& distance) {
  Depth<Dim> best;
  const double size = reach_from<Dim>(middle_of<Dim>(face), face);
  std::vector<std::array<Point<Dim>, Count>> parts{face};
  while (!parts.empty()) {
    const auto part = parts.back();
    parts.pop_back();
    const Point<Dim> middle = middle_of<Dim>(part);
    const double inside = -distance(middle), reach = reach_from<Dim>(middle, part);
    if (inside > best.depth) best = {inside, middle};
    if (inside + reach <= best.depth || reach <= (best.depth > 0 ? part_inside : least_part) * size) continue;
    for (const auto& half : halves<Dim>(part)) parts.push_back(half);
  }
  return best;
}

}  // namespace

template <int Dim>
BodyDepths<Dim>::BodyDepths(const Cloths<Dim>& cloths, const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies)
    : cloths_(cloths), grid_(grid), bodies_(bodies), mesh_(cloths), of_groups_(cloths.groups().size(), 0.0) {}

template <int Dim>
void BodyDepths<Dim>::look(const Points<Dim>& positions, double time) {
  if (bodies_.empty() || cloths_.marker_count() == 0) return;
  if (time == time_ && !any_rank(cloths_.comm(), positions != seen_)) return;
  seen_ = positions;
  time_ = time;
  total_ = 0;
  example_.clear();
  deepest_ = {};
  std::ranges::fill(of_groups_, 0.0);
  const Points<Dim> places = cloths_.lattices().with_halo(positions);
  const PosedBodies<Dim> posed(bodies_, time);
  const auto add_all = [&](const auto& faces, const auto& pieces, const auto& is_meant) {
    for (std::size_t n = 0; n < faces.size(); ++n) {
      std::array<Point<Dim>, std::tuple_size_v<std::remove_cvref_t<decltype(faces[n])>>> corners;
      std::ranges::transform(faces[n], corners.begin(), [&](std::size_t corner) { return places[corner]; });
      if (is_meant(pieces[n])) add(corners, pieces[n], posed);
    }
  };
  add_all(mesh_.faces, mesh_.piece_of_face, [](std::size_t) { return true; });
  if (Dim == 3)
    add_all(mesh_.edges, mesh_.piece_of_edge,
            [&](std::size_t piece) { return cloths_.group_of_piece(piece).sheet.width == 1; });
  total_ = ordered_sum(cloths_.comm(), total_);
  for (double& depth : of_groups_) depth = largest(cloths_.comm(), depth);
  share(deepest_);
}

template <int Dim>
template <std::size_t Count>
void BodyDepths<Dim>::add(const std::array<Point<Dim>, Count>& corners, std::size_t piece,
                          const PosedBodies<Dim>& posed) {
  bool is_inside = false;
  for (std::size_t b = 0; b < posed.size(); ++b) {
    const auto found =
        depth_of<Dim>(corners, [&](const Point<Dim>& place) { return posed.distance(b, grid_.folded(place)); });
    if (found.depth == 0) continue;
    is_inside = true;
    double& of_group = of_groups_[cloths_.pieces()[piece].group];
    of_group = std::max(of_group, found.depth);
    if (found.depth > deepest_.depth) deepest_ = {found.depth, piece, b, found.place};
  }
  if (is_inside) total_ += 1;
}

// Describes the deepest face of all ranks; of equal ones that of the first rank.
template <int Dim>
void BodyDepths<Dim>::share(const Deepest& mine) {
  Deepest deepest;
  for (const Deepest& other : of_all_ranks(cloths_.comm(), std::vector{mine}))
    if (other.depth > deepest.depth) deepest = other;
  if (deepest.depth == 0) return;
  example_ = cloths_.name_of(deepest.piece) + " reaches " + format_text("%.2g", deepest.depth) + " m into " +
             bodies_[deepest.body].name + " at (" + list_text<Dim>(deepest.place) + ") m";
}

template class BodyDepths<2>;
template class BodyDepths<3>;

}  // namespace washfsi
