// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/immersed_boundary/transfer.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "washfsi/grid/interpolate.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

template <int Dim>
Transfer<Dim>::Transfer(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const DeltaOptions& delta)
    : grid_(grid),
      boundary_(boundary),
      delta_(delta),
      exchange_(grid),
      spread_stencils_(AxisDelta(delta.kernel, delta.spread_width)) {
  if (delta.interpolate_width != delta.spread_width)
    interpolate_stencils_.emplace(AxisDelta(delta.kernel, delta.interpolate_width));
}

template <int Dim>
void Transfer<Dim>::check_inside(const Points<Dim>& positions) const {
  Located outside;
  for (const auto& position : positions)
    if (!position.allFinite() || !grid_.contains(position)) {
      outside.value = 1;
      std::copy_n(position.data(), Dim, outside.place);
    }
  outside = largest(grid_.comm(), outside);
  if (outside.value == 0) return;
  throw DivergedError("cloth: a marker has left the grid at (" + list_text<Dim>(Point<Dim>(outside.place)) + ") m");
}

template <int Dim>
void Transfer<Dim>::locate(const Points<Dim>& positions) {
  const petsc::LogPart part("spread");
  check_inside(positions);
  exchange_.update(positions);
  const Points<Dim> before = std::exchange(here_, exchange_.to_cells(positions));
  for (auto& position : here_) position = grid_.folded(position);
  find_stencils(before);
  find_beside_sides();
}

// Reuses the stencils of markers at rest, which may be most of a drum's.
template <int Dim>
void Transfer<Dim>::find_stencils(const Points<Dim>& before) {
  const auto fill = [&](FaceStencils<Dim>& stencils) {
    stencils.resize(here_.size());
    for (std::size_t m = 0; m < here_.size(); ++m)
      if (m >= before.size() || here_[m] != before[m]) stencils.set(m, grid_, here_[m]);
  };
  fill(spread_stencils_);
  if (interpolate_stencils_) fill(*interpolate_stencils_);
}

template <int Dim>
void Transfer<Dim>::find_beside_sides() {
  beside_sides_.clear();
  reached_sides_ = {};
  interpolate_stencils().visit([&](const auto& stencils) {
    for (std::size_t m = 0; m < stencils.size(); ++m) {
      typename Boundary<Dim>::SideSet reached{};
      if (!stencils[m].find_reached(grid_.cells(), reached)) continue;
      beside_sides_.push_back({m, reached});
      for (int d = 0; d < Dim; ++d)
        for (int end = 0; end < 2; ++end) reached_sides_[d][end] = reached_sides_[d][end] || reached[d][end];
    }
  });
}

template <int Dim>
void Transfer<Dim>::add_to_local(const Points<Dim>& values, Vec local) const {
  WASH_PETSC(VecZeroEntries(local));
  const FaceView<Dim> field(grid_.wide_face_dm(), local);
  const double per_volume = 1 / grid_.cell_volume();
  spread_stencils_.visit([&](const auto& stencils) {
    for (std::size_t m = 0; m < stencils.size(); ++m)
      if (!values[m].isZero(0))
        for_each_component<Dim>([&](auto c) { stencils[m].add(c, per_volume * values[m][c], field); });
  });
}

// Returns the reaction of the box's sides on this rank.
template <int Dim>
Point<Dim> Transfer<Dim>::spread_of_rank(const Points<Dim>& forces, Vec force) const {
  const petsc::LogPart part("spread");
  const petsc::LocalVector local(grid_.wide_face_dm());
  add_to_local(exchange_.to_cells(forces), local);
  Point<Dim> kept = grid_.cell_volume() * boundary_.fold(local);
  WASH_PETSC(DMLocalToGlobal(grid_.wide_face_dm(), local, ADD_VALUES, force));
  return kept;
}

template <int Dim>
void Transfer<Dim>::spread(const Points<Dim>& forces, Vec force) const {
  (void)spread_of_rank(forces, force);
}

template <int Dim>
Point<Dim> Transfer<Dim>::spread_with_reaction(const Points<Dim>& forces, Vec force) const {
  const Point<Dim> mine = spread_of_rank(forces, force);
  const std::vector<double> reaction = ordered_sum(grid_.comm(), std::vector<double>(mine.data(), mine.data() + Dim));
  return Point<Dim>(reaction.data());
}

template <int Dim>
void Transfer<Dim>::spread_mass(const std::vector<double>& masses, Vec density) const {
  Points<Dim> amounts;
  for (const double mass : masses) amounts.push_back(Point<Dim>::Constant(mass));
  spread_amounts(amounts, density);
}

template <int Dim>
void Transfer<Dim>::spread_amounts(const Points<Dim>& amounts, Vec density) const {
  const petsc::LogPart part("spread");
  const petsc::LocalVector local(grid_.wide_face_dm());
  add_to_local(exchange_.to_cells(amounts), local);
  boundary_.fold_mass(local);
  WASH_PETSC(DMLocalToGlobal(grid_.wide_face_dm(), local, ADD_VALUES, density));
}

template <int Dim>
Points<Dim> Transfer<Dim>::interpolate(Vec local_velocity) const {
  const petsc::LogPart part("interpolate");
  const ConstFaceView<Dim> u(grid_.wide_face_dm(), local_velocity);
  Points<Dim> velocities;
  interpolate_stencils().visit([&](const auto& stencils) {
    for (const auto& stencil : stencils) velocities.push_back(stencil.mean(u));
  });
  return exchange_.to_owners(velocities);
}

template <int Dim>
Points<Dim> Transfer<Dim>::interpolate_from_sides(Vec local_velocity, const std::optional<SideName>& side) const {
  const petsc::LogPart part("interpolate");
  const ConstFaceView<Dim> u(grid_.wide_face_dm(), local_velocity);
  Points<Dim> velocities(here_.size(), Point<Dim>::Zero());
  interpolate_stencils().visit([&](const auto& stencils) {
    for (const auto& [m, reached] : beside_sides_)
      if (!side || reached[side->axis][side->end == End::upper ? 1 : 0]) velocities[m] = stencils[m].mean(u);
  });
  return exchange_.to_owners(velocities);
}

template <int Dim>
Points<Dim> Transfer<Dim>::sample(Vec local_velocity, const Points<Dim>& offsets) const {
  const ConstFaceView<Dim> u(grid_.wide_face_dm(), local_velocity);
  Points<Dim> velocities = exchange_.to_cells(offsets);
  for (std::size_t m = 0; m < velocities.size(); ++m) {
    Point<Dim> place = here_[m] + velocities[m];
    for (int d = 0; d < Dim; ++d)
      if (!grid_.periodic(d)) place[d] = std::clamp(place[d], grid_.lower()[d], grid_.upper()[d]);
    for (int c = 0; c < Dim; ++c) velocities[m][c] = interpolate_face<Dim>(grid_, u, place, c);
  }
  return exchange_.to_owners(velocities);
}

template <int Dim>
std::vector<double> row_sum_mobility(const Transfer<Dim>& transfer, const Grid<Dim>& grid,
                                     const Boundary<Dim>& boundary, Vec density, Vec fluid_fraction,
                                     const std::vector<double>& weights) {
  Points<Dim> forces;
  for (const double weight : weights) forces.push_back(Point<Dim>::Constant(weight));
  const petsc::GlobalVector acceleration(grid.face_dm());
  WASH_PETSC(VecZeroEntries(acceleration));
  transfer.spread(forces, acceleration);
  WASH_PETSC(VecPointwiseDivide(acceleration, acceleration, density));
  if (fluid_fraction) WASH_PETSC(VecPointwiseMult(acceleration, acceleration, fluid_fraction));
  const petsc::LocalVector local(grid.wide_face_dm(), acceleration);
  boundary.fill_homogeneous(local);
  std::vector<double> mobility;
  for (const auto& velocity : transfer.interpolate(local)) mobility.push_back(velocity.maxCoeff());
  return mobility;
}

template class Transfer<2>;
template class Transfer<3>;
template std::vector<double> row_sum_mobility<2>(const Transfer<2>&, const Grid<2>&, const Boundary<2>&, Vec, Vec,
                                                 const std::vector<double>&);
template std::vector<double> row_sum_mobility<3>(const Transfer<3>&, const Grid<3>&, const Boundary<3>&, Vec, Vec,
                                                 const std::vector<double>&);

}  // namespace washfsi
