// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/friction.hpp"

#include <algorithm>

namespace washfsi {

namespace {

// Of a slide y, with g = y/f and F the integral of f from 0.
struct Creep {
  double g, rate, energy;  // g, dg/dy, F
};

Creep creep(double y, double e) {
  const double part = y / e;
  if (part >= 1) return {y, 1, y - e / 3};
  return {e / (2 - part), 1 / ((2 - part) * (2 - part)), y * part * (1 - part / 3)};
}

}  // namespace

template <int Dim>
void Friction<Dim>::begin(std::vector<Rub<Dim>> rubs, const Points<Dim>& all, double dt) {
  dt_ = dt;
  rubs_ = dt > 0 ? std::move(rubs) : std::vector<Rub<Dim>>{};
  starts_ = all;
  directions_.assign(rubs_.size(), Point<Dim>::Zero());
  slides_ = directions_;
}

template <int Dim>
Point<Dim> Friction<Dim>::slide(const Rub<Dim>& rub, const Points<Dim>& all) const {
  Point<Dim> slide = Point<Dim>::Zero();
  for (std::size_t i = 0; i < rub.pair.markers.size(); ++i)
    slide += rub.gap.shares[i] * (all[rub.pair.markers[i]] - starts_[rub.pair.markers[i]]);
  return slide - rub.gap.normal.dot(slide) * rub.gap.normal;
}

// A step of Newton's for  g q = u  in both of its unknowns, in which the slides have already been found.
template <int Dim>
void Friction<Dim>::linearise(const Points<Dim>& all) {
  for (std::size_t r = 0; r < rubs_.size(); ++r) {
    const Point<Dim> now = slide(rubs_[r], all), &before = slides_[r];
    if (now == before) continue;
    const double y = before.norm();
    const Creep law = creep(y, creep_speed * dt_);
    Point<Dim> direction = now / law.g;
    if (y > 0) direction -= law.rate / (law.g * y) * before.dot(now - before) * directions_[r];
    directions_[r] = direction / std::max(1.0, direction.norm());
    slides_[r] = now;
  }
}

template <int Dim>
std::vector<RubForce<Dim>> Friction<Dim>::forces(const Points<Dim>& all) const {
  std::vector<RubForce<Dim>> forces;
  forces.reserve(rubs_.size());
  for (std::size_t r = 0; r < rubs_.size(); ++r) forces.push_back(force(rubs_[r], directions_[r], all));
  return forces;
}

template <int Dim>
RubForce<Dim> Friction<Dim>::force(const Rub<Dim>& rub, const Point<Dim>& direction, const Points<Dim>& all) const {
  const Point<Dim> slide = this->slide(rub, all);
  const double y = slide.norm();
  const Creep law = creep(y, creep_speed * dt_);
  StiffnessBlock<Dim> stiffness = StiffnessBlock<Dim>::Identity() - rub.gap.normal * rub.gap.normal.transpose();
  if (y > 0) stiffness -= 0.5 * law.rate / y * (direction * slide.transpose() + slide * direction.transpose());
  const double strength = rub.limit / law.g;
  return {&rub, rub.limit * law.energy, strength * y * y, strength * slide, strength * stiffness};
}

template class Friction<2>;
template class Friction<3>;

}  // namespace washfsi
