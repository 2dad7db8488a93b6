// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/side_cover.hpp"

#include <utility>

#include "washfsi/grid/subdivide.hpp"

namespace washfsi {

template <int Dim>
SideCover<Dim>::SideCover(const Grid<Dim>& grid, int axis, End end, const Point<Dim>& own)
    : grid_(grid), axis_(axis), end_(end), own_(own), plane_(grid.local()) {
  plane_.lower[axis] = 0;
  plane_.upper[axis] = 1;
}

template <int Dim>
Point<Dim> SideCover<Dim>::on_side(Point<Dim> place) const {
  place[axis_] = end_ == End::lower ? grid_.lower()[axis_] : grid_.upper()[axis_];
  return place;
}

template <int Dim>
void SideCover<Dim>::set(double time, const Cover& cover) {
  const bool first = now_.velocities.empty();
  if (first) resting_ = resting(cover);
  std::swap(before_, now_);
  now_ = resting_;
  now_.time = time;
  const auto reconsider = [&](const Index<Dim>& face) { find(now_, face, cover.by_all); };
  subdivide<Dim>(
      grid_, plane_, cover.reach, [&](const Point<Dim>& place) { return cover.to_moving(on_side(place)); },
      [&](const Box<Dim>& part, int sign) {
        if (sign < 0) for_each<Dim>(part, reconsider);
      },
      reconsider);
  if (first) before_ = now_;
}

template <int Dim>
typename SideCover<Dim>::Moment SideCover<Dim>::resting(const Cover& cover) const {
  Moment moment;
  for_each<Dim>(plane_, [&](const Index<Dim>&) { ++moment.open_places; });
  moment.velocities.assign(moment.open_places, own_);
  moment.shares.assign(moment.open_places, Point<Dim>::Zero());
  for_each<Dim>(plane_, [&](const Index<Dim>& face) { find(moment, face, cover.by_resting); });
  return moment;
}

template <int Dim>
void SideCover<Dim>::find(Moment& moment, const Index<Dim>& face, const typename Cover::At& cover) const {
  Point<Dim>&velocity = moment.velocities[number(face)], &shares = moment.shares[number(face)];
  const bool was_open = shares.minCoeff() < 1;
  for (int c = 0; c < Dim; ++c) {
    const Covered<Dim> covered = cover(on_side(grid_.face_center(face, c)), own_);
    velocity[c] = c == axis_ ? own_[c] : covered.velocity[c];
    shares[c] = covered.share;
  }
  if (was_open && shares.minCoeff() >= 1) --moment.open_places;
  moment.covers = moment.covers || !shares.isZero(0);
  moment.moves = moment.moves || velocity != own_;
}

template class SideCover<2>;
template class SideCover<3>;

}  // namespace washfsi
