// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_law/body_wall_law.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/fluid/wall_law.hpp"
#include "washfsi/grid/cell_share.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr double least_cover = 1e-3;                      // least weight by the deltas at which inner water slides
constexpr double viscous_layer = 5, turbulent_layer = 6;  // y+ at the matching place
constexpr double inner_number = 0.25;                     // viscous number nu dt/h^2 within bodies
constexpr double inside_below = 0.01;                     // share of fluid below which a cell is within a body

double smooth_step(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

double no_slip_share(double y_plus) {
  return smooth_step((y_plus - viscous_layer) / (turbulent_layer - viscous_layer));
}

}  // namespace

template <int Dim>
BodyWallLaw<Dim>::BodyWallLaw(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                              const std::vector<Body<Dim>>& bodies, const BodyMarkers<Dim>& markers)
    : BodyWallLaw(grid, boundary, bodies, markers.patches(),
                  wall_points<Dim>(bodies, markers, grid.spacing(), PlacedPoints<Dim>::matching_place)) {}

template <int Dim>
BodyWallLaw<Dim>::BodyWallLaw(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                              const std::vector<Body<Dim>>& bodies, std::size_t patches,
                              const std::vector<WallPoint<Dim>>& all)
    : grid_(grid),
      boundary_(boundary),
      bodies_(bodies),
      points_(grid, boundary, bodies, all),
      patch_normals_(patches, Point<Dim>::Zero()),
      patch_slides_(patches),
      filtered_(points_.size()),
      forces_(points_.size(), Point<Dim>::Zero()),
      slips_(forces_),
      friction_(grid.face_vector()),
      y_plus_(points_.size(), 0.0) {
  for (const auto& point : all) patch_normals_[point.patch] = point.normal;
}

template <int Dim>
void BodyWallLaw<Dim>::observe(const StepFlow& flow, const PureLiquid& liquid) {
  const petsc::LogPart part("viscosity");
  points_.place(flow.time);
  fluid_share_ = flow.fluid_share;
  const GhostedVelocity<Dim> local(boundary_, grid_.wide_face_dm(), flow.velocity, flow.time);
  const Points<Dim> at_near = points_.speeds_along(local, 0);
  const Points<Dim> at_far = points_.speeds_along(local, PlacedPoints<Dim>::matching_place);
  const double nu = liquid.viscosity / liquid.density;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    y_plus_[p] = 0;
    if (!points_.acts(p)) continue;
    const double distance = points_.matching_distance(p);
    filtered_.take(p, at_near[p], at_far[p], distance, flow.last_step);
    y_plus_[p] = wall_distance(filtered_.far(p).norm() * distance / nu);
  }
  tell_patches(flow.last_step);
  for (std::size_t p = 0; p < points_.size(); ++p) apply_friction(p, liquid);
  forces_ = points_.turned(std::move(forces_), true);
  slips_ = points_.turned(std::move(slips_), true);
  WASH_PETSC(VecZeroEntries(friction_));
  points_.transfer().spread(forces_, friction_);
  const double spacing = grid_.spacing().minCoeff();
  inner_viscosity_ = flow.last_step > 0 ? inner_number * liquid.density * spacing * spacing / flow.last_step : 0;
  filtered_.begin();
  observes_ = true;
}

// The sliding along a patch is that of the faster water on its two faces.
template <int Dim>
void BodyWallLaw<Dim>::tell_patches(double step) {
  const std::size_t faces = 2 * patch_slides_.size();  // sums of `part`, `passes` for each; then of all points
  std::vector<double> sums(2 * faces + 2, 0.0);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (!points_.acts(p)) continue;
    const double part = no_slip_share(y_plus_[p]);
    sums[2 * faces] += part;
    sums[2 * faces + 1] += 1;
    if (points_[p].at_edge) continue;
    sums[2 * points_.face(p)] = part;
    sums[2 * points_.face(p) + 1] = part * step * filtered_.far(p).norm() / points_[p].along;
  }
  sums = ordered_sum(grid_.comm(), sums);
  for (std::size_t p = 0; p < patch_slides_.size(); ++p)
    patch_slides_[p] = {std::max(sums[4 * p], sums[4 * p + 2]), std::max(sums[4 * p + 1], sums[4 * p + 3])};
  turbulent_ = sums[2 * faces + 1] > 0 ? sums[2 * faces] / sums[2 * faces + 1] : 0;
}

// In the bodies' frames. Where a patch slides, slow water on one of its faces has friction by the law's laminar part.
template <int Dim>
void BodyWallLaw<Dim>::apply_friction(std::size_t p, const PureLiquid& liquid) {
  const WallPoint<Dim>& point = points_[p];
  const double speed = filtered_.far(p).norm(), part = patch_slides_[point.patch].part;
  forces_[p].setZero();
  slips_[p].setZero();
  if (!points_.acts(p) || part == 0 || speed == 0) return;
  const double friction = y_plus_[p] * liquid.viscosity / liquid.density / points_.matching_distance(p);
  forces_[p] = -part * liquid.density * friction * friction * point.area / speed * filtered_.far(p);
  slips_[p] = part * filtered_.near(p);
}

template <int Dim>
void BodyWallLaw<Dim>::add_friction(Vec force) const {
  WASH_PETSC(VecAXPY(force, 1.0, friction_));
}

template <int Dim>
void BodyWallLaw<Dim>::add_inner_slip(Vec fluid_fraction, Vec velocity) const {
  const petsc::GlobalVector cover(grid_.face_dm()), covered(grid_.face_dm());
  WASH_PETSC(VecZeroEntries(cover));
  WASH_PETSC(VecZeroEntries(covered));
  Points<Dim> weighted = slips_;
  for (std::size_t p = 0; p < weighted.size(); ++p) weighted[p] *= points_.covers()[p];
  points_.inner().spread_mass(points_.covers(), cover);
  points_.inner().spread_amounts(weighted, covered);  // folded at sides as the cover is
  const ConstFaceView<Dim> weight(grid_.face_dm(), cover), slip(grid_.face_dm(), covered);
  const ConstFaceView<Dim> fraction(grid_.face_dm(), fluid_fraction);
  const FaceView<Dim> u(grid_.face_dm(), velocity);
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (fraction(face, c) < 1 && weight(face, c) > least_cover) u(face, c) += slip(face, c) / weight(face, c);
  });
}

template <int Dim>
void BodyWallLaw<Dim>::replace(Vec viscosity) const {
  const CellShare<Dim> share(grid_, fluid_share_);
  const CellView<Dim> mu(grid_.cell_dm(), viscosity);
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
    const double inside = turbulent_ * smooth_step(1 - share(cell) / inside_below);
    mu(cell) += inside * std::max(0.0, inner_viscosity_ - mu(cell));
  });
}

template <int Dim>
Loads<Dim> BodyWallLaw<Dim>::loads_here() const {
  Loads<Dim> loads(bodies_.size());
  if (!observes_) return loads;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const std::size_t b = points_[p].body;
    loads[b].add(points_.place_of(p) - points_.motions()[b].center, -forces_[p]);
  }
  return loads;
}

// Power of the friction, summed over faces, where spreading is the adjoint of interpolation.
template <int Dim>
double BodyWallLaw<Dim>::dissipation(Vec velocity_before, Vec velocity, double time) const {
  if (!observes_) return 0;
  const double middle = 0.5 * (points_.time() + time);
  const petsc::LocalVector sides(grid_.wide_face_dm());
  WASH_PETSC(VecZeroEntries(sides));
  boundary_.fill(sides, middle);
  const Points<Dim> of_sides = points_.transfer().interpolate_from_sides(sides);
  const auto motions = motions_at(bodies_, middle);
  double lost = 0;
  for (std::size_t p = 0; p < points_.size(); ++p)
    lost += forces_[p].dot(points_.body_velocity(p, motions) - of_sides[p]);
  const ConstFaceView<Dim> f(grid_.face_dm(), friction_), before(grid_.face_dm(), velocity_before),
      now(grid_.face_dm(), velocity);
  double given = 0;
  grid_.for_each_inner_face(
      [&](const Index<Dim>& face, auto c) { given += f(face, c) * 0.5 * (before(face, c) + now(face, c)); });
  return ordered_sum(grid_.comm(), lost - given * grid_.cell_volume());
}

template <int Dim>
std::vector<double> BodyWallLaw<Dim>::largest_y_plus() const {
  std::vector<double> plus(bodies_.size(), 0.0);
  for (std::size_t p = 0; p < points_.size(); ++p)
    plus[points_[p].body] = std::max(plus[points_[p].body], 0.5 / PlacedPoints<Dim>::matching_place * y_plus_[p]);
  for (double& value : plus) value = largest(grid_.comm(), value);
  return plus;
}

template <int Dim>
void BodyWallLaw<Dim>::register_state(StateList& state) {
  filtered_.register_state(state, points_.begin(), points_.count());
}

template class BodyWallLaw<2>;
template class BodyWallLaw<3>;

}  // namespace washfsi
