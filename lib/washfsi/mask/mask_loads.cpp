// SPDX-License-Identifier: BSD-3-Clause
//
// Loads of the water on the bodies, from the faces of the grid.
#include <array>
#include <vector>

#include "washfsi/mask/mask.hpp"

namespace washfsi {

namespace {

/// Sums forces on faces body by body. Arms are in cells from the grid's lower corner until all is summed; faces beside
/// a periodic image of a body count as if they were beside the body itself.
template <int Dim>
class FaceForces {
 public:
  FaceForces(const Grid<Dim>& grid, const PosedBodies<Dim>& posed) : grid_(grid), posed_(posed), sums_(posed.size()) {}

  void add(std::size_t body, const Index<Dim>& face, int axis, double force) {
    Sum& sum = sums_[body][axis];
    sum.force += force;
    const Index<Dim> image = posed_[body].image(grid_.face_center(face, axis));
    for (int d = 0; d < Dim; ++d) sum.moments[d] += static_cast<double>(face[d] - image[d] * grid_.cells()[d]) * force;
  }

  // Adds the sums, with torques about the bodies' centres.
  void add_to(Loads<Dim>& loads) const {
    for (std::size_t b = 0; b < sums_.size(); ++b)
      for (int axis = 0; axis < Dim; ++axis) {
        const auto& [force, moments] = sums_[b][axis];
        const Point<Dim> arm = grid_.face_center(Index<Dim>{}, axis) - posed_.motion(b).center;
        const Point<Dim> leverage = force * arm + grid_.spacing().cwiseProduct(moments);
        loads[b].force[axis] += force;
        loads[b].torque += cross<Dim>(leverage, Point<Dim>::Unit(axis));
      }
  }

 private:
  struct Sum {
    double force = 0;
    Point<Dim> moments = Point<Dim>::Zero();  ///< moments, with arms in cells
  };
  const Grid<Dim>& grid_;
  const PosedBodies<Dim>& posed_;
  std::vector<std::array<Sum, Dim>> sums_;
};

}  // namespace

template <int Dim>
void Mask<Dim>::add_constraint_force(Vec constraint_force, Vec density, double time, Loads<Dim>& loads) const {
  const ConstFaceView<Dim> f(grid_.face_dm(), constraint_force), rho(grid_.face_dm(), density);
  const ConstFaceView<Dim> holder(grid_.face_dm(), body_), fraction(grid_.face_dm(), fluid_share());
  const PosedBodies<Dim> posed(bodies_, time);
  std::vector<char> move;
  for (const auto& body : bodies_) move.push_back(body.motion.at_rest() ? 0 : 1);
  FaceForces<Dim> forces(grid_, posed);
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (holder(face, c) < 0) return;
    const auto b = static_cast<std::size_t>(holder(face, c));
    double force = -f(face, c);
    if (move[b] && fraction(face, c) < 1)
      force += (1 - fraction(face, c)) * rho(face, c) * posed[b].acceleration(grid_.face_center(face, c))[c];
    forces.add(b, face, c, grid_.cell_volume() * force);
  });
  forces.add_to(loads);
}

template <int Dim>
Loads<Dim> Mask<Dim>::inner_momentum(Vec velocity, Vec density, double time) const {
  Loads<Dim> momenta(bodies_.size());
  const ConstFaceView<Dim> u(grid_.face_dm(), velocity), rho(grid_.face_dm(), density);
  const ConstFaceView<Dim> holder(grid_.face_dm(), body_), fraction(grid_.face_dm(), fluid_share());
  const ConstFaceView<Dim> solid(grid_.face_dm(), solid_velocity_);
  const PosedBodies<Dim> posed(bodies_, time);
  FaceForces<Dim> sums(grid_, posed);
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (holder(face, c) < 0 || fraction(face, c) == 1) return;
    const double speed = u(face, c) - solid(face, c);
    const double inside = grid_.cell_volume() * (1 - fraction(face, c)) * rho(face, c);
    sums.add(static_cast<std::size_t>(holder(face, c)), face, c, inside * speed);
  });
  sums.add_to(momenta);
  return ordered_sum<Dim>(grid_.comm(), momenta);
}

// A drum reaches to the sides of the box, which take a part of its load: the pressure of the cells beside them.
template <int Dim>
void Mask<Dim>::add_wall_pressure(Vec pressure, double time, Loads<Dim>& loads) const {
  const ConstCellView<Dim> p(grid_.cell_dm(), pressure);
  const PosedBodies<Dim> posed(bodies_, time);
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : {End::lower, End::upper}) {
      const double area = (end == End::upper ? 1 : -1) * grid_.cell_volume() / grid_.spacing()[axis];
      for_each<Dim>(grid_.cells_beside(axis, end), [&](const Index<Dim>& cell) {
        const Point<Dim> place = grid_.cell_center(cell);
        const std::size_t b = posed.holder(place);
        if (b == bodies_.size()) return;
        Point<Dim> force = Point<Dim>::Zero();
        force[axis] = area * p(cell);
        loads[b].add(posed[b].arm(place), force);
      });
    }
}

template <int Dim>
Loads<Dim> Mask<Dim>::loads(Vec constraint_force, Vec density, Vec pressure, double time) const {
  Loads<Dim> loads(bodies_.size());
  if (constraint_force) add_constraint_force(constraint_force, density, time, loads);
  add_wall_pressure(pressure, time, loads);
  return ordered_sum<Dim>(grid_.comm(), loads);
}

template <int Dim>
double Mask<Dim>::dissipation(Vec velocity_before, Vec density, double dt) const {
  if (!any_moves_) return 0;
  const ConstFaceView<Dim> u(grid_.face_dm(), velocity_before), rho(grid_.face_dm(), density);
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fraction_), solid(grid_.face_dm(), solid_velocity_);
  double lost = 0;
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    const double change = solid(face, c) - u(face, c);
    lost += 0.5 * (1 - fraction(face, c)) * rho(face, c) * change * change;
  });
  return ordered_sum(grid_.comm(), lost * grid_.cell_volume() / dt);
}

template <int Dim>
Loads<Dim> Mask<Dim>::hidden_wall_shear(const Boundary<Dim>& boundary, Vec local_velocity, const Viscosity& viscosity,
                                        double time) const {
  Loads<Dim> loads(bodies_.size());
  with_viscosity<Dim>(grid_, viscosity, [&](const auto& mu) {
    for (int axis = 0; axis < Dim; ++axis)
      for (const End end : {End::lower, End::upper}) {
        const auto& side = boundary.side(axis, end);
        if (side.kind == BoundaryKind::wall && !side.motion)
          add_hidden_shear(boundary, axis, end, ConstFaceView<Dim>(grid_.face_dm(), local_velocity), mu, time, loads);
      }
  });
  return ordered_sum<Dim>(grid_.comm(), loads);
}

template <int Dim>
template <class Form>
void Mask<Dim>::add_hidden_shear(const Boundary<Dim>& boundary, int axis, End end, const ConstFaceView<Dim>& u,
                                 const Form& viscosity, double time, Loads<Dim>& loads) const {
  const ConstFaceView<Dim> holder(grid_.face_dm(), body_), fraction(grid_.face_dm(), fluid_share());
  const double spacing = grid_.spacing()[axis], area = grid_.cell_volume() / spacing;
  const PosedBodies<Dim> posed(bodies_, time);
  const int outwards = end == End::upper ? 1 : -1;
  for (int c = 0; c < Dim; ++c) {
    if (c == axis) continue;
    Box<Dim> faces = grid_.cells_beside(axis, end);
    faces.lower[c] = std::max(faces.lower[c], grid_.inner_faces(c).lower[c]);  // others take no part in the load
    for_each<Dim>(faces, [&](const Index<Dim>& face) {
      if (holder(face, c) < 0) return;
      const auto b = static_cast<std::size_t>(holder(face, c));
      Point<Dim> place = grid_.face_center(face, c), force = Point<Dim>::Zero();
      place[axis] += 0.5 * outwards * spacing;
      const double share = share_ ? boundary.covered_share(axis, end, face, c, time) : 1 - fraction(face, c);
      const double mu = viscosity.scale * viscosity.on_side(face, c, axis, outwards);
      const double rate = (u(face, c) - u(shifted<Dim>(face, axis, outwards), c)) / spacing;
      force[c] = share * area * mu * rate;  // on water beside the body it is a force on the water
      loads[b].add(posed[b].arm(place), force);
    });
  }
}

template void Mask<2>::add_constraint_force(Vec, Vec, double, Loads<2>&) const;
template void Mask<3>::add_constraint_force(Vec, Vec, double, Loads<3>&) const;
template void Mask<2>::add_wall_pressure(Vec, double, Loads<2>&) const;
template void Mask<3>::add_wall_pressure(Vec, double, Loads<3>&) const;
template Loads<2> Mask<2>::inner_momentum(Vec, Vec, double) const;
template Loads<3> Mask<3>::inner_momentum(Vec, Vec, double) const;
template Loads<2> Mask<2>::loads(Vec, Vec, Vec, double) const;
template Loads<3> Mask<3>::loads(Vec, Vec, Vec, double) const;
template double Mask<2>::dissipation(Vec, Vec, double) const;
template double Mask<3>::dissipation(Vec, Vec, double) const;
template Loads<2> Mask<2>::hidden_wall_shear(const Boundary<2>&, Vec, const Viscosity&, double) const;
template Loads<3> Mask<3>::hidden_wall_shear(const Boundary<3>&, Vec, const Viscosity&, double) const;

}  // namespace washfsi
