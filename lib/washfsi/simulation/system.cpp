// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/system.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

// Ghost layers that hold the stencil of a marker anywhere in an owned cell.
template <int Dim>
GridShape<Dim> with_ghosts_for(GridShape<Dim> shape, const SystemOptions<Dim>& options) {
  const DeltaOptions& delta = options.delta;
  shape.ghost_width = static_cast<PetscInt>(std::ceil(std::max(delta.spread_width, delta.interpolate_width))) + 1;
  // a probe lies at most two spacings from the face that it serves
  if (options.treatment.method == BodyMethod::ghost) shape.ghost_width = std::max<PetscInt>(shape.ghost_width, 3);
  return shape;
}

// Whether a body holds all of a pair of opposite sides of the box at the start, as a drum does.
template <int Dim>
bool fills_the_sides(const Body<Dim>& body, const GridShape<Dim>& shape, std::size_t axis) {
  const Point<Dim> extent = shape.upper - shape.lower;
  Box<Dim> side{{}, shape.cells};
  side.upper[axis] = 2;  // both ends
  bool filled = true;
  for_each<Dim>(side, [&](const Index<Dim>& face) {
    Point<Dim> place;
    for (std::size_t e = 0; e < Dim; ++e) {
      const auto d = static_cast<int>(e);
      const double cells = e == axis ? 1 : static_cast<double>(shape.cells[e]);
      const double position = e == axis ? static_cast<double>(face[e]) : static_cast<double>(face[e]) + 0.5;
      place[d] = shape.lower[d] + extent[d] * position / cells;
    }
    filled = filled && body.distance(place, 0) <= 0;
  });
  return filled;
}

// The axes along which a motion may carry material through the sides of the box; turning is about z.
template <int Dim>
std::vector<std::size_t> axes_moved_along(const RigidMotion<Dim>& motion) {
  std::vector<std::size_t> axes{0, 1};
  if (Dim == 3 && (motion.table || motion.translation[Dim - 1] != 0)) axes.push_back(2);
  return axes;
}

// A turning drum that fills the box up to its walls takes them along: they have its velocity.
template <int Dim>
typename Boundary<Dim>::Sides sides_with_drum(const SystemOptions<Dim>& options, const std::vector<Body<Dim>>& bodies) {
  typename Boundary<Dim>::Sides sides = options.grid.sides;
  const auto periodic = [&](std::size_t axis) { return sides[axis][0].kind == BoundaryKind::periodic; };
  for (const auto& body : bodies) {
    if (body.motion.at_rest()) continue;
    const std::vector<std::size_t> axes = axes_moved_along(body.motion);
    const auto passes = [&](std::size_t axis) {
      return periodic(axis) || fills_the_sides(body, options.grid.shape, axis);
    };
    if (!std::all_of(axes.begin(), axes.end(), passes)) continue;
    for (const std::size_t axis : axes)
      for (auto& side : sides[axis]) {
        if (side.kind != BoundaryKind::wall) continue;
        if (!side.velocity.isZero(0))
          throw InputError("-bc_" + std::string(1, "xyz"[axis]) + "_..._velocity: this wall moves with the body " +
                           body.name + ", which fills the box up to it");
        side.motion = [motion = body.motion](const Point<Dim>& place, double time) {
          return motion.velocity(place, time);
        };
      }
  }
  return sides;
}

// The radius of a circle or cylinder: the distance of its centre from its surface.
template <int Dim>
double radius_of(const Body<Dim>& body) {
  const Point<Dim> center = body.motion.center;
  const double radius = std::abs(body.distance(center, 0));
  if (std::abs(body.distance(center + radius * Point<Dim>::Unit(0), 0)) > 1e-9 * radius)
    throw InputError("-fluid_initial couette: body " + body.name + " is no circle, or a cylinder shorter than wide");
  return radius;
}

// Steady circular flow between two concentric bodies that turn steadily: u = (A r + B/r) e_theta (4.3-1).
template <int Dim>
void start_couette(System<Dim>& system) {
  const auto& bodies = system.bodies;
  if (bodies.size() != 2 || bodies[0].motion.center != bodies[1].motion.center || !bodies[0].motion.turns_steadily() ||
      !bodies[1].motion.turns_steadily())
    throw InputError(
        "-fluid_initial couette: needs two -bodies with one centre, a drum and a cylinder, that turn steadily");
  const Point<Dim> center = bodies[0].motion.center;
  const bool drum_first = bodies[0].distance(center, 0) > 0;
  const auto &drum = bodies[drum_first ? 0 : 1], &cylinder = bodies[drum_first ? 1 : 0];
  const double ro = radius_of(drum), ri = radius_of(cylinder);
  if (cylinder.distance(center, 0) >= 0 || ro <= ri)
    throw InputError("-fluid_initial couette: needs a drum (-..._inverted) and in it a cylinder with the same centre");
  const double wo = drum.motion.angular_speed, wi = cylinder.motion.angular_speed;
  const double a = (wo * ro * ro - wi * ri * ri) / (ro * ro - ri * ri);
  const double b = (wi - wo) * ri * ri * ro * ro / (ro * ro - ri * ri);
  const FaceView<Dim> u(system.grid.face_dm(), system.fluid.velocity());
  for (int c = 0; c < 2; ++c)
    for_each<Dim>(system.grid.owned(), [&](const Index<Dim>& face) {
      const Point<Dim> arm = system.grid.face_center(face, c) - center;
      const double r = arm.template head<2>().norm();
      const double turning = r < ri ? wi : r > ro ? wo : a + b / (r * r);
      u(face, c) = turning * (c == 0 ? -arm[1] : arm[0]);
    });
}

}  // namespace

MachineAxis MachineAxis::from_options(Options& options, const GridShape<3>& shape) {
  MachineAxis machine;
  const Point<3> middle = 0.5 * (shape.lower + shape.upper);
  machine.axis = middle.head<2>();
  machine.orbit_center = {0.25 * (shape.upper - shape.lower).head<2>().minCoeff(), middle[2]};
  options.block("machine_", "Machine", [&](OptionBlock& block) {
    block.point<2>("axis", machine.axis, "m", "x,y of the vertical axis; default: the middle of the box");
    block.point<2>("orbit_center", machine.orbit_center, "m",
                   "distance from the axis and height of what tumbling cloths go round; default: half-way between axis"
                   " and sides, half the height");
  });
  return machine;
}

template <int Dim>
SystemOptions<Dim> SystemOptions<Dim>::from_options(Options& options) {
  SystemOptions<Dim> system;
  system.grid = GridOptions<Dim>::from_options(options);
  system.fluid = FluidOptions<Dim>::from_options(options);
  std::string fluid = "water";
  options.block("", "Fluid or none", [&](OptionBlock& block) {
    block.choice("fluid", fluid, {"water", "none"}, "none: cloth alone, as in a vacuum or with a linear drag");
    block.real("cloth_drag", system.cloth_drag, "kg/(m2 s)", non_negative,
               "without fluid: force per undeformed area and speed");
  });
  system.has_fluid = fluid == "water";
  options.block("", "Gravity", [&](OptionBlock& block) {
    block.template point<Dim>("gravity", system.gravity, "m/s2", "acceleration by gravity, acting on excess mass");
  });
  system.cloths = cloth_groups_from_options<Dim>(options);
  for (const ClothGroup<Dim>& group : system.cloths)
    system.placements.push_back(PlacementOptions<Dim>::from_options(options, group.name));
  system.treatment = BodyTreatment::from_options(options);
  options.block("", "Loads", [&](OptionBlock& block) {
    block.boolean("body_balance", system.balance_loads,
                  "measure the loads on bodies by the balance of momentum round them too: a check");
  });
  system.delta = DeltaOptions::from_options(options);
  system.contact = ContactOptions::from_options(options);
  if constexpr (Dim == 3) system.machine = MachineAxis::from_options(options, system.grid.shape);
  return system;
}

template <int Dim>
System<Dim>::System(MPI_Comm comm, const SystemOptions<Dim>& options, std::vector<Body<Dim>> rigid_bodies)
    : grid(comm, with_ghosts_for(options.grid.shape, options)),
      boundary(grid, sides_with_drum(options, rigid_bodies)),
      bodies(std::move(rigid_bodies)),
      mask(grid, bodies, options.treatment),
      fluid(grid, boundary, options.fluid),
      cloths(comm, options.cloths),
      transfer(grid, boundary, options.delta),
      fluid_density(options.fluid.density),
      has_fluid(options.has_fluid),
      cloth_drag(options.cloth_drag),
      balance_loads(options.balance_loads),
      contact(options.contact),
      machine(options.machine),
      gravity(options.gravity),
      density(grid.face_vector()),
      force(grid.face_vector()) {
  WASH_PETSC(VecSet(density, fluid_density));
  const Points<Dim> all = place_cloths<Dim>(cloths, options.placements, bodies, grid.lower(), grid.upper());
  positions.assign(all.begin() + cloths.begin(), all.begin() + cloths.end());
  velocities.assign(positions.size(), Point<Dim>::Zero());
  contact_loads.bodies.resize(bodies.size());
  cloths.hold_at(positions);
  locate_cloth(positions);
  if (options.fluid.initial == "couette") start_couette(*this);
}

template <int Dim>
void System<Dim>::locate_cloth(const Points<Dim>& places) {
  transfer.locate(places);
  if (cloths.marker_count() == 0) return;
  WASH_PETSC(VecSet(density, fluid_density));
  transfer.spread_mass(cloths.marker_masses(), density);
}

template struct SystemOptions<2>;
template struct SystemOptions<3>;
template struct System<2>;
template struct System<3>;

}  // namespace washfsi
