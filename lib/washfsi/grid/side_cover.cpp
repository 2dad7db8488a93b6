// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/side_cover.hpp"

#include <utility>

namespace washfsi {

template <int Dim>
SideCover<Dim>::SideCover(const Grid<Dim>& grid, int axis, End end, const Point<Dim>& own)
    : grid_(grid), axis_(axis), end_(end), own_(own), plane_(grid.local()) {
  plane_.lower[axis] = 0;
  plane_.upper[axis] = 1;
}

template <int Dim>
void SideCover<Dim>::set(double time, const Cover& cover) {
  const bool first = now_.velocities.empty();
  std::swap(before_, now_);
  now_ = {time, {}, {}};
  for_each<Dim>(plane_, [&](const Index<Dim>& face) { add(now_, face, cover); });
  if (first) before_ = now_;
}

template <int Dim>
void SideCover<Dim>::add(Moment& moment, const Index<Dim>& face, const Cover& cover) const {
  Point<Dim> velocity = own_, shares = Point<Dim>::Zero();
  for (int c = 0; c < Dim; ++c) {
    Point<Dim> place = grid_.face_center(face, c);
    place[axis_] = end_ == End::lower ? grid_.lower()[axis_] : grid_.upper()[axis_];
    const Covered<Dim> covered = cover(place, own_);
    if (c != axis_) velocity[c] = covered.velocity[c];
    shares[c] = covered.share;
  }
  moment.velocities.push_back(velocity);
  moment.shares.push_back(shares);
  moment.covers = moment.covers || !shares.isZero(0);
  moment.covers_all = moment.covers_all && shares.minCoeff() >= 1;
  moment.moves = moment.moves || velocity != own_;
}

template class SideCover<2>;
template class SideCover<3>;

}  // namespace washfsi
