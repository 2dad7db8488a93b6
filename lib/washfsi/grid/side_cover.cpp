// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/side_cover.hpp"

#include <cmath>
#include <utility>

namespace washfsi {

// One layer of the local faces along the side.
template <int Dim>
Box<Dim> SideCover<Dim>::plane() const {
  Box<Dim> plane = grid_.local();
  plane.lower[axis_] = 0;
  plane.upper[axis_] = 1;
  return plane;
}

template <int Dim>
std::size_t SideCover<Dim>::number(const Index<Dim>& face) const {
  const Box<Dim> box = plane();
  PetscInt number = 0;
  for (int d = Dim; d-- > 0;)
    if (d != axis_) number = number * (box.upper[d] - box.lower[d]) + face[d] - box.lower[d];
  return static_cast<std::size_t>(number);
}

template <int Dim>
void SideCover<Dim>::set(double time, const Velocity& velocity) {
  const bool first = now_.velocities.empty();
  std::swap(before_, now_);
  now_.time = time;
  now_.velocities.clear();
  for_each<Dim>(plane(), [&](const Index<Dim>& face) {
    Point<Dim> values = Point<Dim>::Zero();
    for (int c = 0; c < Dim; ++c) {
      if (c == axis_) continue;
      Point<Dim> place = grid_.face_center(face, c);
      place[axis_] = end_ == End::lower ? grid_.lower()[axis_] : grid_.upper()[axis_];
      values[c] = velocity(place, own_)[c];
    }
    now_.velocities.push_back(values);
  });
  if (first) before_ = now_;
}

template <int Dim>
double SideCover<Dim>::operator()(const Index<Dim>& face, int component, double time) const {
  const Moment& nearest = std::abs(time - now_.time) <= std::abs(time - before_.time) ? now_ : before_;
  return nearest.velocities[number(face)][component];
}

template class SideCover<2>;
template class SideCover<3>;

}  // namespace washfsi
