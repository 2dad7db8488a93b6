// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/mask/mask_loads.hpp"

#include <algorithm>
#include <array>
#include <vector>

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

// The constraint force density of a step on the water acts on the bodies, less the inertia of the water inside them.
template <int Dim>
void add_constraint_force(const Mask<Dim>& mask, Vec constraint_force, Vec density, double time, Loads<Dim>& loads) {
  const Grid<Dim>& grid = mask.grid();
  const ConstFaceView<Dim> f(grid.face_dm(), constraint_force), rho(grid.face_dm(), density);
  const ConstFaceView<Dim> holder(grid.face_dm(), mask.body_of_faces()), fraction(grid.face_dm(), mask.fluid_share());
  const PosedBodies<Dim> posed(mask.bodies(), time);
  std::vector<char> move;
  for (const auto& body : mask.bodies()) move.push_back(body.motion.at_rest() ? 0 : 1);
  FaceForces<Dim> forces(grid, posed);
  grid.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (holder(face, c) < 0) return;
    const auto b = static_cast<std::size_t>(holder(face, c));
    double force = -f(face, c);
    if (move[b] && fraction(face, c) < 1)
      force += (1 - fraction(face, c)) * rho(face, c) * posed[b].acceleration(grid.face_center(face, c))[c];
    forces.add(b, face, c, grid.cell_volume() * force);
  });
  forces.add_to(loads);
}

// A drum reaches to the sides of the box, which take a part of its load: the pressure of the cells beside them.
template <int Dim>
void add_wall_pressure(const Mask<Dim>& mask, Vec pressure, double time, Loads<Dim>& loads) {
  const Grid<Dim>& grid = mask.grid();
  const ConstCellView<Dim> p(grid.cell_dm(), pressure);
  const PosedBodies<Dim> posed(mask.bodies(), time);
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : {End::lower, End::upper}) {
      const double area = (end == End::upper ? 1 : -1) * grid.cell_volume() / grid.spacing()[axis];
      for_each<Dim>(grid.cells_beside(axis, end), [&](const Index<Dim>& cell) {
        const Point<Dim> place = grid.cell_center(cell);
        const std::size_t b = posed.holder(place);
        if (b == mask.bodies().size()) return;
        Point<Dim> force = Point<Dim>::Zero();
        force[axis] = area * p(cell);
        loads[b].add(posed[b].arm(place), force);
      });
    }
}

template <int Dim, class Form>
void add_hidden_shear(const Mask<Dim>& mask, const Boundary<Dim>& boundary, const SideName& side,
                      const ConstFaceView<Dim>& u, const Form& viscosity, double time, Loads<Dim>& loads) {
  const Grid<Dim>& grid = mask.grid();
  const auto [axis, end] = side;
  const bool covers_sides = mask.fluid_share() != mask.fluid_fraction();  // direct forcing
  const ConstFaceView<Dim> holder(grid.face_dm(), mask.body_of_faces()), fraction(grid.face_dm(), mask.fluid_share());
  const double spacing = grid.spacing()[axis], area = grid.cell_volume() / spacing;
  const PosedBodies<Dim> posed(mask.bodies(), time);
  const int outwards = end == End::upper ? 1 : -1;
  for (int c = 0; c < Dim; ++c) {
    if (c == axis) continue;
    Box<Dim> faces = grid.cells_beside(axis, end);
    faces.lower[c] = std::max(faces.lower[c], grid.inner_faces(c).lower[c]);  // others take no part in the load
    for_each<Dim>(faces, [&](const Index<Dim>& face) {
      if (holder(face, c) < 0) return;
      const auto b = static_cast<std::size_t>(holder(face, c));
      Point<Dim> place = grid.face_center(face, c), force = Point<Dim>::Zero();
      place[axis] += 0.5 * outwards * spacing;
      const double share = covers_sides ? boundary.covers().share(axis, end, face, c, time) : 1 - fraction(face, c);
      const double mu = viscosity.scale * viscosity.on_side(face, c, axis, outwards);
      const double rate = (u(face, c) - u(shifted<Dim>(face, axis, outwards), c)) / spacing;
      force[c] = share * area * mu * rate;  // on water beside the body it is a force on the water
      loads[b].add(posed[b].arm(place), force);
    });
  }
}

}  // namespace

template <int Dim>
Loads<Dim> inner_momentum(const Mask<Dim>& mask, Vec velocity, Vec density, double time) {
  const Grid<Dim>& grid = mask.grid();
  Loads<Dim> momenta(mask.bodies().size());
  const ConstFaceView<Dim> u(grid.face_dm(), velocity), rho(grid.face_dm(), density);
  const ConstFaceView<Dim> holder(grid.face_dm(), mask.body_of_faces()), fraction(grid.face_dm(), mask.fluid_share());
  const ConstFaceView<Dim> solid(grid.face_dm(), mask.solid_velocity());
  const PosedBodies<Dim> posed(mask.bodies(), time);
  FaceForces<Dim> sums(grid, posed);
  grid.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (holder(face, c) < 0 || fraction(face, c) == 1) return;
    const double speed = u(face, c) - solid(face, c);
    const double inside = grid.cell_volume() * (1 - fraction(face, c)) * rho(face, c);
    sums.add(static_cast<std::size_t>(holder(face, c)), face, c, inside * speed);
  });
  sums.add_to(momenta);
  return ordered_sum<Dim>(grid.comm(), momenta);
}

template <int Dim>
Loads<Dim> constraint_loads(const Mask<Dim>& mask, Vec constraint_force, Vec density, Vec pressure, double time) {
  Loads<Dim> loads(mask.bodies().size());
  if (constraint_force) add_constraint_force(mask, constraint_force, density, time, loads);
  add_wall_pressure(mask, pressure, time, loads);
  return ordered_sum<Dim>(mask.grid().comm(), loads);
}

template <int Dim>
double mask_dissipation(const Mask<Dim>& mask, Vec velocity_before, Vec density, double dt) {
  if (std::ranges::all_of(mask.bodies(), [](const auto& body) { return body.motion.at_rest(); })) return 0;
  const Grid<Dim>& grid = mask.grid();
  const ConstFaceView<Dim> u(grid.face_dm(), velocity_before), rho(grid.face_dm(), density);
  const ConstFaceView<Dim> fraction(grid.face_dm(), mask.fluid_fraction()),
      solid(grid.face_dm(), mask.solid_velocity());
  double lost = 0;
  grid.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    const double change = solid(face, c) - u(face, c);
    lost += 0.5 * (1 - fraction(face, c)) * rho(face, c) * change * change;
  });
  return ordered_sum(grid.comm(), lost * grid.cell_volume() / dt);
}

template <int Dim>
Loads<Dim> hidden_wall_shear(const Mask<Dim>& mask, const Boundary<Dim>& boundary, Vec local_velocity,
                             const Viscosity& viscosity, double time) {
  const Grid<Dim>& grid = mask.grid();
  Loads<Dim> loads(mask.bodies().size());
  with_viscosity<Dim>(grid, viscosity, [&](const auto& mu) {
    for (int axis = 0; axis < Dim; ++axis)
      for (const End end : {End::lower, End::upper}) {
        const auto& side = boundary.side(axis, end);
        if (side.kind == BoundaryKind::wall && !side.motion)
          add_hidden_shear(mask, boundary, {axis, end}, ConstFaceView<Dim>(grid.face_dm(), local_velocity), mu, time,
                           loads);
      }
  });
  return ordered_sum<Dim>(grid.comm(), loads);
}

template Loads<2> constraint_loads(const Mask<2>&, Vec, Vec, Vec, double);
template Loads<3> constraint_loads(const Mask<3>&, Vec, Vec, Vec, double);
template Loads<2> inner_momentum(const Mask<2>&, Vec, Vec, double);
template Loads<3> inner_momentum(const Mask<3>&, Vec, Vec, double);
template double mask_dissipation(const Mask<2>&, Vec, Vec, double);
template double mask_dissipation(const Mask<3>&, Vec, Vec, double);
template Loads<2> hidden_wall_shear(const Mask<2>&, const Boundary<2>&, Vec, const Viscosity&, double);
template Loads<3> hidden_wall_shear(const Mask<3>&, const Boundary<3>&, Vec, const Viscosity&, double);

}  // namespace washfsi
