// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/wall_model.hpp"

#include <algorithm>

#include "washfsi/fluid/wall_law.hpp"
#include "washfsi/grid/field_slab.hpp"
#include "washfsi/grid/velocity_gradient.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

const ChoiceNames<WallTreatment>& names_of(WallTreatment) {
  static const ChoiceNames<WallTreatment> names{{"none", WallTreatment::none},
                                                {"equilibrium", WallTreatment::equilibrium}};
  return names;
}

namespace {

constexpr double first_place = 0.5, matching_place = 1.5;  // places of cells' middles, in spacings from the wall
constexpr double viscous_layer = 5;                        // y+

// Calls visit(cell, axis, inwards) for this rank's cells beside no-slip walls; from a cell to the second one it is one
// step inwards.
template <int Dim, class Visit>
void visit_wall_cells(const Grid<Dim>& grid, const Boundary<Dim>& boundary, Visit&& visit) {
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : {End::lower, End::upper})
      if (!grid.periodic(axis) && boundary.side(axis, end).kind == BoundaryKind::wall) {
        const int normal = axis, inwards = end == End::lower ? 1 : -1;  // names of their own, since a lambda takes them
        for_each<Dim>(grid.cells_beside(axis, end), [&](const Index<Dim>& cell) { visit(cell, normal, inwards); });
      }
}

// Velocity along the wall in the middle of a cell, relative to the wall, from the ghost, which is its mirror image.
template <int Dim>
Eigen::Matrix<double, Dim - 1, 1> slip(const ConstFaceView<Dim>& u, const Index<Dim>& first, const Index<Dim>& cell,
                                       int axis, int inwards) {
  Eigen::Matrix<double, Dim - 1, 1> result;
  const Index<Dim> ghost = shifted<Dim>(first, axis, -inwards);
  for (int k = 0; k < Dim - 1; ++k) {
    const int c = (axis + 1 + k) % Dim;
    const double wall = 0.5 * (cell_velocity<Dim>(u, ghost, c) + cell_velocity<Dim>(u, first, c));
    result[k] = cell_velocity<Dim>(u, cell, c) - wall;
  }
  return result;
}

double y_plus(double speed, double distance, const PureLiquid& liquid) {
  return wall_distance(speed * distance * liquid.density / liquid.viscosity);
}

}  // namespace

template <int Dim>
WallModel<Dim>::WallModel(const Grid<Dim>& grid, const Boundary<Dim>& boundary)
    : grid_(grid), boundary_(boundary), wall_viscosity_(grid.face_vector()) {
  for (auto& vector : filtered_) vector = grid.face_vector();
}

template <int Dim>
void WallModel<Dim>::observe(const ConstFaceView<Dim>& velocity, double dt, const PureLiquid& liquid,
                             const CellShare<Dim>& share) {
  const FaceView<Dim> wall(grid_.face_dm(), wall_viscosity_);
  visit_wall_cells(grid_, boundary_, [&](const Index<Dim>& cell, int axis, int inwards) {
    if (share(cell) > 0)
      observe_cell(velocity, cell, axis, inwards, dt, liquid);
    else
      wall(cell, axis) = 0;
  });
  begun_ = true;
}

template <int Dim>
void WallModel<Dim>::observe_cell(const ConstFaceView<Dim>& u, const Index<Dim>& cell, int axis, int inwards, double dt,
                                  const PureLiquid& liquid) {
  const double h = grid_.spacing()[axis], distance = matching_place * h, nu = liquid.viscosity / liquid.density;
  const Index<Dim> second = shifted<Dim>(cell, axis, inwards);
  const Tangential now = slip<Dim>(u, cell, second, axis, inwards);
  const double rate = now.norm() / distance;  // 1/T
  const double weight = begun_ ? dt * rate / (1 + dt * rate) : 1;
  const double speed = filter(second, axis, now, weight).norm();
  const double first = filter(cell, axis, slip<Dim>(u, cell, cell, axis, inwards), weight).norm();
  const FaceView<Dim> wall(grid_.face_dm(), wall_viscosity_);
  const double plus = y_plus(speed, distance, liquid), friction = plus * nu / distance;
  wall(cell, axis) = plus <= viscous_layer
                         ? 0
                         : std::max(liquid.viscosity, liquid.density * friction * friction * first_place * h /
                                                          std::max(first, speed * first_place / matching_place));
}

// The new filtered velocity of a cell.
template <int Dim>
typename WallModel<Dim>::Tangential WallModel<Dim>::filter(const Index<Dim>& cell, int axis, const Tangential& now,
                                                           double weight) {
  Tangential result;
  for (int k = 0; k < Dim - 1; ++k) {
    const FaceView<Dim> kept(grid_.face_dm(), filtered_[static_cast<std::size_t>(k)]);
    double& value = kept(cell, axis);
    value += weight * (now[k] - value);
    result[k] = value;
  }
  return result;
}

template <int Dim>
void WallModel<Dim>::set_ghosts(Vec local_viscosity) const {
  const petsc::LocalVector local(grid_.face_dm());
  WASH_PETSC(VecZeroEntries(local));  // beyond the box
  WASH_PETSC(DMGlobalToLocal(grid_.face_dm(), wall_viscosity_, INSERT_VALUES, local));
  const ConstFaceView<Dim> wall(grid_.face_dm(), local);
  const CellView<Dim> mu(grid_.cell_dm(), local_viscosity);
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : {End::lower, End::upper}) {
      if (grid_.periodic(axis) || boundary_.side(axis, end).kind != BoundaryKind::wall) continue;
      Box<Dim> cells = grid_.cells_beside(axis, end);
      for (int d = 0; d < Dim; ++d)
        if (d != axis) --cells.lower[d], ++cells.upper[d];  // edges need a neighbour's
      for_each<Dim>(cells, [&, normal = axis, out = end == End::lower ? -1 : 1](const Index<Dim>& cell) {
        if (wall(cell, normal) > 0) mu(shifted<Dim>(cell, normal, out)) = 2 * wall(cell, normal) - mu(cell);
      });
    }
}

template <int Dim>
void WallModel<Dim>::register_state(StateList& state) {
  for (std::size_t k = 0; k < filtered_.size(); ++k) {
    StateEntry& entry =
        state.add(vector_entry("/fluid/wall_velocity_" + std::to_string(k + 1), field_slab(grid_, Dim), filtered_[k]));
    entry.if_other = StateEntry::IfOther::begin_anew;
    entry.use = StateEntry::Use::restart;
    entry.set = [this, copy = entry.set](const StateEntry::Values& values) {
      copy(values);
      begun_ = true;
    };
  }
}

// y+ grows with the speed, so the fastest cell of each spacing has the largest.
template <int Dim>
double largest_y_plus(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const ConstFaceView<Dim>& velocity,
                      const PureLiquid& liquid) {
  Point<Dim> fastest = Point<Dim>::Zero();
  visit_wall_cells(grid, boundary, [&](const Index<Dim>& cell, int axis, int inwards) {
    const Index<Dim> second = shifted<Dim>(cell, axis, inwards);
    fastest[axis] = std::max(fastest[axis], slip<Dim>(velocity, cell, second, axis, inwards).norm());
  });
  double plus = 0;
  for (int d = 0; d < Dim; ++d)
    plus =
        std::max(plus, y_plus(fastest[d], matching_place * grid.spacing()[d], liquid) * first_place / matching_place);
  return largest(grid.comm(), plus);
}

template class WallModel<2>;
template class WallModel<3>;
template double largest_y_plus(const Grid<2>&, const Boundary<2>&, const ConstFaceView<2>&, const PureLiquid&);
template double largest_y_plus(const Grid<3>&, const Boundary<3>&, const ConstFaceView<3>&, const PureLiquid&);

}  // namespace washfsi
