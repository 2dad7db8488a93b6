// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/friction.hpp"

namespace washfsi {

template <int Dim>
void Friction<Dim>::begin(std::vector<Rub<Dim>> rubs, const Points<Dim>& all, double dt) {
  dt_ = dt;
  rubs_ = dt > 0 ? std::move(rubs) : std::vector<Rub<Dim>>{};
  starts_ = all;
}

template <int Dim>
std::vector<RubForce<Dim>> Friction<Dim>::forces(const Points<Dim>& all) const {
  std::vector<RubForce<Dim>> forces;
  forces.reserve(rubs_.size());
  for (const auto& rub : rubs_) forces.push_back(force(rub, all));
  return forces;
}

// With F the integral of f from 0:  F = y^2/e - y^3/(3 e^2) below e, y - e/3 beyond.
template <int Dim>
RubForce<Dim> Friction<Dim>::force(const Rub<Dim>& rub, const Points<Dim>& all) const {
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  const Matrix tangential = Matrix::Identity() - rub.gap.normal * rub.gap.normal.transpose();
  Point<Dim> slide = Point<Dim>::Zero();
  for (std::size_t i = 0; i < rub.pair.markers.size(); ++i)
    slide += rub.gap.shares[i] * (all[rub.pair.markers[i]] - starts_[rub.pair.markers[i]]);
  slide = tangential * slide;
  const double y = slide.norm(), e = creep_speed * dt_, part = y / e;
  const bool sticks = part < 1;
  const double energy = sticks ? y * part * (1 - part / 3) : y - e / 3;
  const double over_slide = sticks ? (2 - part) / e : 1 / y;  // f/y
  return {&rub, rub.limit * energy, rub.limit * over_slide * y * y, rub.limit * over_slide * slide,
          rub.limit * over_slide * tangential};
}

template class Friction<2>;
template class Friction<3>;

}  // namespace washfsi
