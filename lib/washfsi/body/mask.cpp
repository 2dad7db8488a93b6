// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/body/mask.hpp"

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
Mask<Dim>::Mask(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies)
    : grid_(grid), bodies_(bodies), fraction_(grid.face_vector()), solid_velocity_(grid.face_vector()),
      body_(grid.face_vector()) {
  update(0);
}

template <int Dim>
void Mask<Dim>::update(double time) {
  const FaceView<Dim> fraction(grid_.face_dm(), fraction_), solid(grid_.face_dm(), solid_velocity_);
  const FaceView<Dim> holder(grid_.face_dm(), body_);
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
    for (int c = 0; c < Dim; ++c) {
      fraction(face, c) = 1;
      solid(face, c) = 0;
      holder(face, c) = -1;
      const Point<Dim> place = grid_.face_center(face, c);
      for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const double distance = bodies_[b].distance(place, time);
        if (distance > 0) continue;
        fraction(face, c) = distance < 0 ? 0 : 0.5;
        solid(face, c) = bodies_[b].motion.velocity(place, time)[c];
        holder(face, c) = static_cast<double>(b);
        break;
      }
    }
  });
}

template <int Dim>
void Mask<Dim>::hold(Vec velocity) const {
  if (empty()) return;
  const FaceView<Dim> u(grid_.face_dm(), velocity);
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fraction_), solid(grid_.face_dm(), solid_velocity_);
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
    for (int c = 0; c < Dim; ++c) u(face, c) = fraction(face, c) * u(face, c) + (1 - fraction(face, c)) * solid(face, c);
  });
}

template <int Dim>
std::vector<Load<Dim>> Mask<Dim>::loads(Vec constraint_force, Vec density, double time) const {
  constexpr std::size_t width = Dim + rotation_components<Dim>;
  std::vector<double> sums(width * bodies_.size(), 0.0);
  {
    const ConstFaceView<Dim> f(grid_.face_dm(), constraint_force), rho(grid_.face_dm(), density);
    const ConstFaceView<Dim> holder(grid_.face_dm(), body_), fraction(grid_.face_dm(), fraction_);
    for (int c = 0; c < Dim; ++c)
      for_each<Dim>(grid_.inner_faces(c), [&](const Index<Dim>& face) {
        if (holder(face, c) < 0) return;
        const auto b = static_cast<std::size_t>(holder(face, c));
        const Point<Dim> place = grid_.face_center(face, c);
        const RigidMotion<Dim>& motion = bodies_[b].motion;
        const double inertia = (1 - fraction(face, c)) * rho(face, c) * motion.acceleration(place, time)[c];
        Point<Dim> force = Point<Dim>::Zero();
        force[c] = grid_.cell_volume() * (inertia - f(face, c));
        const Rotation<Dim> torque = cross<Dim>(place - motion.center, force);
        double* sum = &sums[width * b];
        sum[c] += force[c];
        for (int r = 0; r < rotation_components<Dim>; ++r) sum[Dim + r] += torque[r];
      });
  }
  sums = ordered_sum(grid_.comm(), sums);
  std::vector<Load<Dim>> loads(bodies_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    loads[b].force = Point<Dim>(&sums[width * b]);
    loads[b].torque = Eigen::Map<const Rotation<Dim>>(&sums[width * b + Dim]);
  }
  return loads;
}

template class Mask<2>;
template class Mask<3>;

}  // namespace washfsi
