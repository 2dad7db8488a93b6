// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/friction.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

namespace {

// The regularisation at a slide |xi| = y: Xi = y/eta, and the integral of eta over the slide from 0.
struct Creep {
  double g, rate, energy;  // Xi, dXi/dy, the integral
};

template <int Dim>
Creep creep(double y, const FrictionPair<Dim>& pair, double dt) {
  const double e = std::max(Friction<Dim>::creep_speed * dt, pair.stops), part = y / e;
  if (part >= 1) return {y, 1, y - e / 3};
  return {e / (2 - part), 1 / ((2 - part) * (2 - part)), y * part * (1 - part / 3)};
}

template <int Dim>
Point<Dim> slide(const FrictionPair<Dim>& pair, const Point<Dim>& way) {
  return way - pair.normal.dot(way) * pair.normal;
}

}  // namespace

double contact_damping(double share, double stiffness, double mass) {
  return 2 * share * std::sqrt(std::max(stiffness, 0.0) * mass);
}

template <int Dim>
void Friction<Dim>::begin(std::vector<FrictionPair<Dim>> pairs, double dt, double share) {
  dt_ = dt;
  share_ = share;
  pairs_ = dt > 0 ? std::move(pairs) : std::vector<FrictionPair<Dim>>{};
  directions_.assign(pairs_.size(), Point<Dim>::Zero());
  slides_ = directions_;
}

// A Newton step for  Xi xi^ = xi  in both of its unknowns, of which the slides xi have already been found.
template <int Dim>
void Friction<Dim>::linearise(const Points<Dim>& ways) {
  for (std::size_t r = 0; r < pairs_.size(); ++r) {
    const Point<Dim> now = slide(pairs_[r], ways[r]), &before = slides_[r];
    if (now == before) continue;
    const double y = before.norm();
    const Creep law = creep(y, pairs_[r], dt_);
    Point<Dim> direction = now / law.g;
    if (y > 0) direction -= law.rate / (law.g * y) * before.dot(now - before) * directions_[r];
    directions_[r] = direction / std::max(1.0, direction.norm());
    slides_[r] = now;
  }
}

template <int Dim>
std::vector<FrictionForce<Dim>> Friction<Dim>::forces(const Points<Dim>& ways) const {
  std::vector<FrictionForce<Dim>> forces;
  forces.reserve(pairs_.size());
  for (std::size_t r = 0; r < pairs_.size(); ++r) forces.push_back(force(pairs_[r], directions_[r], ways[r]));
  return forces;
}

template <int Dim>
FrictionForce<Dim> Friction<Dim>::force(const FrictionPair<Dim>& pair, const Point<Dim>& direction,
                                        const Point<Dim>& way) const {
  const Point<Dim> slid = slide(pair, way);
  const double y = slid.norm();
  const Creep law = creep(y, pair, dt_);
  StiffnessBlock<Dim> stiffness = StiffnessBlock<Dim>::Identity() - pair.normal * pair.normal.transpose();
  if (y > 0) stiffness -= 0.5 * law.rate / y * (direction * slid.transpose() + slid * direction.transpose());
  const double limit = pair.limit / share_, strength = limit / law.g;
  FrictionForce<Dim> force{limit * law.energy, share_ * strength * y * y, strength * slid, strength * stiffness};
  add_damping(pair, way, force);
  return force;
}

template <int Dim>
void Friction<Dim>::add_damping(const FrictionPair<Dim>& pair, const Point<Dim>& way, FrictionForce<Dim>& force) const {
  const double apart = pair.normal.dot(way), strength = pair.damping / (share_ * dt_);
  if (strength == 0) return;
  force.energy += 0.5 * strength * apart * apart;
  force.work += share_ * strength * apart * apart;
  force.pull += strength * apart * pair.normal;
  force.stiffness += strength * pair.normal * pair.normal.transpose();
}

template class Friction<2>;
template class Friction<3>;

}  // namespace washfsi
