// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_law/body_wall_law.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/fluid/wall_law.hpp"
#include "washfsi/grid/cell_share.hpp"
#include "washfsi/motion/turned.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr DeltaOptions delta{DeltaKernel::yang, 2, 2};

// Distances before the surface, in cells; behind it the constraint begins at 5/2. Of friction that acts at 1, up to a
// fifth falls on the water inside, depending on where the wall lies in its cell; at 3/2 up to 3 %.
constexpr double acting_place = 1.5, matching_place = 3, inner_place = -3;
constexpr double least_cover = 1e-3;                      // least weight by the deltas at which inner water slides
constexpr double viscous_layer = 5, turbulent_layer = 6;  // y+ at the matching place
constexpr double inner_number = 0.25;                     // viscous number nu dt/h^2 within bodies
constexpr double inside_below = 0.01;                     // share of fluid below which a cell is within a body

enum Filtered : std::size_t { far, near };

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
    : grid_(grid),
      boundary_(boundary),
      bodies_(bodies),
      transfer_(grid, boundary, delta),
      inner_(grid, boundary, delta),
      friction_(grid.face_vector()) {
  const auto all = wall_points<Dim>(bodies, markers, grid.spacing(), matching_place);
  patch_normals_.assign(markers.patches(), Point<Dim>::Zero());
  for (const auto& point : all) patch_normals_[point.patch] = point.normal;
  patch_slides_.resize(markers.patches());
  const auto ranks = static_cast<std::size_t>(ranks_of(grid.comm()));
  const auto rank = static_cast<std::size_t>(rank_of(grid.comm()));
  count_ = all.size();
  begin_ = count_ * rank / ranks;
  const std::size_t end = count_ * (rank + 1) / ranks;
  points_.assign(all.begin() + static_cast<std::ptrdiff_t>(begin_), all.begin() + static_cast<std::ptrdiff_t>(end));
  for (std::size_t p = begin_; p < end; ++p)
    faces_.push_back(2 * all[p].patch + (p > 0 && all[p - 1].patch == all[p].patch ? 1 : 0));
  filtered_.assign(of_each * points_.size(), Point<Dim>::Zero());
  forces_.assign(points_.size(), Point<Dim>::Zero());
  slips_ = forces_;
  y_plus_.assign(points_.size(), 0.0);
}

template <int Dim>
bool BodyWallLaw<Dim>::is_free(const PosedBodies<Dim>& posed, const WallPoint<Dim>& point,
                               const Point<Dim>& place) const {
  if (!grid_.contains(place)) return false;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if ((b != point.body || bodies_[b].repeats.any()) && posed.distance(b, place) < 0.5 * point.along) return false;
  return true;
}

template <int Dim>
void BodyWallLaw<Dim>::place() {
  const PosedBodies<Dim> posed(bodies_, time_);
  const Point<Dim> anywhere = 0.5 * (grid_.lower() + grid_.upper());
  places_.clear();
  normals_.clear();
  acts_.clear();
  covers_.clear();
  Points<Dim> inner;
  for (const WallPoint<Dim>& point : points_) {
    const Point<Dim> foot = posed.in_space(point.body, point.foot);
    normals_.push_back(posed.in_space(point.body, point.foot + point.normal) - foot);
    const Point<Dim> step = point.along * normals_.back(), acting = foot + acting_place * step;
    acts_.push_back(grid_.contains(acting) && is_free(posed, point, foot + matching_place * step));
    places_.push_back(acts_.back() ? acting : anywhere);
    inner.push_back(foot + inner_place * step);
    covers_.push_back(point.is_thick && grid_.contains(inner.back()) ? point.area * point.along : 0);
    if (covers_.back() == 0) inner.back() = anywhere;
  }
  transfer_.locate(places_);
  inner_.locate(inner);
}

// Velocities along the walls, relative to the bodies and in their frames, at a distance in cells before them.
template <int Dim>
Points<Dim> BodyWallLaw<Dim>::speeds_along(Vec local_velocity, double distance) const {
  static_assert(acting_place <= Transfer<Dim>::sample_reach &&
                matching_place - acting_place <= Transfer<Dim>::sample_reach);
  Points<Dim> offsets;
  for (std::size_t p = 0; p < points_.size(); ++p)
    offsets.push_back((distance - acting_place) * points_[p].along * normals_[p]);
  Points<Dim> velocities = transfer_.sample(local_velocity, offsets);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    velocities[p] -= motions_[points_[p].body].velocity_at(places_[p] + offsets[p]);
    velocities[p] -= velocities[p].dot(normals_[p]) * normals_[p];
  }
  return turned(std::move(velocities), false);
}

// Turns values from the bodies' frames into space, or back.
template <int Dim>
Points<Dim> BodyWallLaw<Dim>::turned(Points<Dim> values, bool into_space) const {
  return washfsi::turned<Dim>(std::move(values), bodies_, time_, into_space,
                              [this](std::size_t p) { return points_[p].body; });
}

template <int Dim>
void BodyWallLaw<Dim>::observe(const StepFlow& flow, const PureLiquid& liquid) {
  const petsc::LogPart part("viscosity");
  time_ = flow.time;
  motions_ = motions_at(bodies_, time_);
  place();
  fluid_share_ = flow.fluid_share;
  const GhostedVelocity<Dim> local(boundary_, grid_.wide_face_dm(), flow.velocity, flow.time);
  const Points<Dim> at_near = speeds_along(local, 0), at_far = speeds_along(local, matching_place);
  const double nu = liquid.viscosity / liquid.density;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    y_plus_[p] = 0;
    if (!acts_[p]) continue;
    filter(p, at_near[p], at_far[p], flow.last_step);
    const double distance = matching_place * points_[p].along;
    y_plus_[p] = wall_distance(filtered_[of_each * p + far].norm() * distance / nu);
  }
  tell_patches(flow.last_step);
  for (std::size_t p = 0; p < points_.size(); ++p) apply_friction(p, liquid);
  forces_ = turned(std::move(forces_), true);
  slips_ = turned(std::move(slips_), true);
  WASH_PETSC(VecZeroEntries(friction_));
  transfer_.spread(forces_, friction_);
  const double spacing = grid_.spacing().minCoeff();
  inner_viscosity_ = flow.last_step > 0 ? inner_number * liquid.density * spacing * spacing / flow.last_step : 0;
  begun_ = observes_ = true;
}

// The sliding along a patch is that of the faster water on its two faces.
template <int Dim>
void BodyWallLaw<Dim>::tell_patches(double step) {
  const std::size_t faces = 2 * patch_slides_.size();  // sums of `part`, `passes` for each; then of all points
  std::vector<double> sums(2 * faces + 2, 0.0);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (!acts_[p]) continue;
    const double part = no_slip_share(y_plus_[p]);
    sums[2 * faces] += part;
    sums[2 * faces + 1] += 1;
    if (points_[p].at_edge) continue;
    sums[2 * faces_[p]] = part;
    sums[2 * faces_[p] + 1] = part * step * filtered_[of_each * p + far].norm() / points_[p].along;
  }
  sums = ordered_sum(grid_.comm(), sums);
  for (std::size_t p = 0; p < patch_slides_.size(); ++p)
    patch_slides_[p] = {std::max(sums[4 * p], sums[4 * p + 2]), std::max(sums[4 * p + 1], sums[4 * p + 3])};
  turbulent_ = sums[2 * faces + 1] > 0 ? sums[2 * faces] / sums[2 * faces + 1] : 0;
}

template <int Dim>
void BodyWallLaw<Dim>::filter(std::size_t p, const Point<Dim>& at_near, const Point<Dim>& at_far, double dt) {
  const double distance = matching_place * points_[p].along;
  const double rate = at_far.norm() / distance, weight = begun_ ? dt * rate / (1 + dt * rate) : 1;
  Point<Dim>* mean = &filtered_[of_each * p];
  mean[far] += weight * (at_far - mean[far]);
  mean[near] += weight * (at_near - mean[near]);
}

// In the bodies' frames. Where a patch slides, slow water on one of its faces has friction by the law's laminar part.
template <int Dim>
void BodyWallLaw<Dim>::apply_friction(std::size_t p, const PureLiquid& liquid) {
  const WallPoint<Dim>& point = points_[p];
  const Point<Dim>* mean = &filtered_[of_each * p];
  const double speed = mean[far].norm(), part = patch_slides_[point.patch].part;
  forces_[p].setZero();
  slips_[p].setZero();
  if (!acts_[p] || part == 0 || speed == 0) return;
  const double friction = y_plus_[p] * liquid.viscosity / liquid.density / (matching_place * point.along);
  forces_[p] = -part * liquid.density * friction * friction * point.area / speed * mean[far];
  slips_[p] = part * mean[near];
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
  for (std::size_t p = 0; p < weighted.size(); ++p) weighted[p] *= covers_[p];
  inner_.spread_mass(covers_, cover);
  inner_.spread_amounts(weighted, covered);  // folded at sides as the cover is
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
    loads[b].add(places_[p] - motions_[b].center, -forces_[p]);
  }
  return loads;
}

// Power of the friction, summed over faces, where spreading is the adjoint of interpolation.
template <int Dim>
double BodyWallLaw<Dim>::dissipation(Vec velocity_before, Vec velocity, double time) const {
  if (!observes_) return 0;
  const double middle = 0.5 * (time_ + time);
  const petsc::LocalVector sides(grid_.wide_face_dm());
  WASH_PETSC(VecZeroEntries(sides));
  boundary_.fill(sides, middle);
  const Points<Dim> of_sides = transfer_.interpolate_from_sides(sides);
  const auto motions = motions_at(bodies_, middle);
  double lost = 0;
  for (std::size_t p = 0; p < points_.size(); ++p)
    lost += forces_[p].dot(motions[points_[p].body].velocity_at(places_[p]) - of_sides[p]);
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
    plus[points_[p].body] = std::max(plus[points_[p].body], 0.5 / matching_place * y_plus_[p]);
  for (double& value : plus) value = largest(grid_.comm(), value);
  return plus;
}

template <int Dim>
void BodyWallLaw<Dim>::register_state(StateList& state) {
  const Slab slab = row_slab(of_each * count_, of_each * begin_, of_each * (begin_ + points_.size()), Dim);
  StateEntry& entry = state.add(points_entry<Dim>("/walls/filtered", slab, filtered_));
  entry.if_other = StateEntry::IfOther::begin_anew;
  entry.use = StateEntry::Use::restart;
  entry.set = [this, copy = entry.set](StateEntry::Values values) {
    copy(std::move(values));
    begun_ = true;
  };
}

template class BodyWallLaw<2>;
template class BodyWallLaw<3>;

}  // namespace washfsi
