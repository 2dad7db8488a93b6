// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/friction.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

namespace {

// Of a slide y, with g = y/f and F the integral of f from 0.
struct Creep {
  double g, rate, energy;  // g, dg/dy, F
};

template <int Dim>
Creep creep(double y, const Rub<Dim>& rub, double dt) {
  const double e = std::max(Friction<Dim>::creep_speed * dt, rub.stops), part = y / e;
  if (part >= 1) return {y, 1, y - e / 3};
  return {e / (2 - part), 1 / ((2 - part) * (2 - part)), y * part * (1 - part / 3)};
}

template <int Dim>
Point<Dim> slide(const Rub<Dim>& rub, const Point<Dim>& way) {
  return way - rub.normal.dot(way) * rub.normal;
}

}  // namespace

double contact_damping(double share, double stiffness, double mass) {
  return 2 * share * std::sqrt(std::max(stiffness, 0.0) * mass);
}

template <int Dim>
void Friction<Dim>::begin(std::vector<Rub<Dim>> rubs, double dt, double share) {
  dt_ = dt;
  share_ = share;
  rubs_ = dt > 0 ? std::move(rubs) : std::vector<Rub<Dim>>{};
  directions_.assign(rubs_.size(), Point<Dim>::Zero());
  slides_ = directions_;
}

// A step of Newton's for  g q = u  in both of its unknowns, in which the slides have already been found.
template <int Dim>
void Friction<Dim>::linearise(const Points<Dim>& ways) {
  for (std::size_t r = 0; r < rubs_.size(); ++r) {
    const Point<Dim> now = slide(rubs_[r], ways[r]), &before = slides_[r];
    if (now == before) continue;
    const double y = before.norm();
    const Creep law = creep(y, rubs_[r], dt_);
    Point<Dim> direction = now / law.g;
    if (y > 0) direction -= law.rate / (law.g * y) * before.dot(now - before) * directions_[r];
    directions_[r] = direction / std::max(1.0, direction.norm());
    slides_[r] = now;
  }
}

template <int Dim>
std::vector<RubForce<Dim>> Friction<Dim>::forces(const Points<Dim>& ways) const {
  std::vector<RubForce<Dim>> forces;
  forces.reserve(rubs_.size());
  for (std::size_t r = 0; r < rubs_.size(); ++r) forces.push_back(force(rubs_[r], directions_[r], ways[r]));
  return forces;
}

template <int Dim>
RubForce<Dim> Friction<Dim>::force(const Rub<Dim>& rub, const Point<Dim>& direction, const Point<Dim>& way) const {
  const Point<Dim> slid = slide(rub, way);
  const double y = slid.norm();
  const Creep law = creep(y, rub, dt_);
  StiffnessBlock<Dim> stiffness = StiffnessBlock<Dim>::Identity() - rub.normal * rub.normal.transpose();
  if (y > 0) stiffness -= 0.5 * law.rate / y * (direction * slid.transpose() + slid * direction.transpose());
  const double limit = rub.limit / share_, strength = limit / law.g;
  RubForce<Dim> force{limit * law.energy, share_ * strength * y * y, strength * slid, strength * stiffness};
  add_damping(rub, way, force);
  return force;
}

template <int Dim>
void Friction<Dim>::add_damping(const Rub<Dim>& rub, const Point<Dim>& way, RubForce<Dim>& force) const {
  const double apart = rub.normal.dot(way), strength = rub.damping / (share_ * dt_);
  if (strength == 0) return;
  force.energy += 0.5 * strength * apart * apart;
  force.work += share_ * strength * apart * apart;
  force.pull += strength * apart * rub.normal;
  force.stiffness += strength * rub.normal * rub.normal.transpose();
}

template class Friction<2>;
template class Friction<3>;

}  // namespace washfsi
