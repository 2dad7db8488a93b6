// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/body_wall_law.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/fluid/wall_law.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr DeltaOptions delta{DeltaKernel::yang, 2, 2};

// Places before the surface, in cells.
constexpr double acting_place = 1, low_place = 0.5, high_place = 1.5, matching_place = 2.5;
constexpr double full_cover = 0.15;  // of the delta across the wall; a cell from its middle it has 0.2
constexpr double viscous_layer = 5, turbulent_layer = 10;  // y+ at the matching place
constexpr double longer = 3;            // filter of stresses, which fluctuate more than the mean velocity
constexpr double lost_in_sampling = 2;  // of the eddies' stress, as velocities are interpolated
constexpr double most_by_eddies = 0.8;  // of the law's stress
constexpr double inner_number = 0.25;   // of viscosity, step and spacing within bodies
constexpr double inside_below = 0.1;    // share of fluid in a cell within a body

enum Kept : std::size_t { far, low, high, flux_low, flux_high };

double smooth_step(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

double holds_by(double y_plus) {
  return smooth_step((y_plus - viscous_layer) / (turbulent_layer - viscous_layer));
}

// Copies a global face vector, if there is one, with its ghosts; what lies beyond the box is `beyond`.
template <int Dim>
void fill_local(const Grid<Dim>& grid, Vec global, double beyond, Vec local) {
  WASH_PETSC(VecSet(local, beyond));
  if (global) WASH_PETSC(DMGlobalToLocal(grid.face_dm(), global, INSERT_VALUES, local));
}

// Calls visit(face, d) for the faces of a cell.
template <int Dim, class Visit>
void visit_faces(const Index<Dim>& cell, Visit&& visit) {
  for (int d = 0; d < Dim; ++d) {
    visit(cell, d);
    visit(shifted<Dim>(cell, d, 1), d);
  }
}

}  // namespace

template <int Dim>
BodyWallLaw<Dim>::BodyWallLaw(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                              const std::vector<Body<Dim>>& bodies, const BodyMarkers<Dim>& markers)
    : grid_(grid), boundary_(boundary), bodies_(bodies), transfer_(grid, boundary, delta) {
  const auto all = wall_points<Dim>(bodies, markers, grid.spacing(), matching_place);
  patch_normals_.assign(markers.patches(), Point<Dim>::Zero());
  for (const auto& point : all)
    if (point.is_thick) patch_normals_[point.patch] = point.normal;
  const auto ranks = static_cast<std::size_t>(ranks_of(grid.comm()));
  const auto rank = static_cast<std::size_t>(rank_of(grid.comm()));
  count_ = all.size();
  begin_ = count_ * rank / ranks;
  const std::size_t end = count_ * (rank + 1) / ranks;
  points_.assign(all.begin() + static_cast<std::ptrdiff_t>(begin_), all.begin() + static_cast<std::ptrdiff_t>(end));
  kept_.assign(kept_of_each * points_.size(), Point<Dim>::Zero());
  weights_.assign(points_.size(), 0.0);
  viscosities_ = y_plus_ = weights_;
}

template <int Dim>
bool BodyWallLaw<Dim>::is_free(const PosedBodies<Dim>& posed, const WallPoint<Dim>& point,
                               const Point<Dim>& place) const {
  if (!grid_.contains(place)) return false;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (b != point.body && posed.distance(b, place) < 0.5 * point.along) return false;
  return true;
}

template <int Dim>
void BodyWallLaw<Dim>::place(double time) {
  const PosedBodies<Dim> posed(bodies_, time);
  places_.clear();
  normals_.clear();
  acts_.clear();
  for (const WallPoint<Dim>& point : points_) {
    const Point<Dim> foot = posed.in_space(point.body, point.foot);
    normals_.push_back(posed.in_space(point.body, point.foot + point.normal) - foot);
    const Point<Dim> step = point.along * normals_.back(), acting = foot + acting_place * step;
    acts_.push_back(grid_.contains(acting) && is_free(posed, point, foot + matching_place * step));
    places_.push_back(acts_.back() ? acting : Point<Dim>(0.5 * (grid_.lower() + grid_.upper())));
  }
  transfer_.locate(places_);
}

template <int Dim>
Points<Dim> BodyWallLaw<Dim>::relative_velocities(Vec local_velocity, double distance, double time) const {
  Points<Dim> offsets;
  for (std::size_t p = 0; p < points_.size(); ++p)
    offsets.push_back((distance - acting_place) * points_[p].along * normals_[p]);
  Points<Dim> velocities = transfer_.sample(local_velocity, offsets);
  for (std::size_t p = 0; p < points_.size(); ++p)
    velocities[p] -= bodies_[points_[p].body].motion.velocity(places_[p] + offsets[p], time);
  return in_bodies_frames(std::move(velocities), time);
}

template <int Dim>
Points<Dim> BodyWallLaw<Dim>::in_bodies_frames(Points<Dim> values, double time) const {
  std::vector<Pose<Dim>> turns;
  for (const auto& body : bodies_) turns.push_back(Pose<Dim>::at(Point<Dim>::Zero(), body.motion.angle(time)));
  for (std::size_t p = 0; p < values.size(); ++p) values[p] = turns[points_[p].body].in_body_frame(values[p]);
  return values;
}

template <int Dim>
void BodyWallLaw<Dim>::observe(const StepFlow& flow, const PureLiquid& liquid) {
  const petsc::LogPart part("viscosity");
  place(flow.time);
  fluid_share_ = flow.fluid_share;
  const GhostedVelocity<Dim> local(boundary_, grid_.wide_face_dm(), flow.velocity, flow.time);
  const Probes seen{relative_velocities(local, low_place, flow.time), relative_velocities(local, high_place, flow.time),
                    relative_velocities(local, matching_place, flow.time)};
  std::vector<double> sums{0, 0};
  for (std::size_t p = 0; p < points_.size(); ++p) {
    weights_[p] = viscosities_[p] = y_plus_[p] = 0;
    if (!acts_[p]) continue;
    filter(p, seen, flow.last_step, liquid.viscosity / liquid.density);
    set_viscosity(p, liquid);
    sums[0] += holds_by(y_plus_[p]);
    sums[1] += 1;
  }
  sums = ordered_sum(grid_.comm(), sums);
  turbulent_ = sums[1] > 0 ? sums[0] / sums[1] : 0;
  const double spacing = grid_.spacing().minCoeff();
  inner_viscosity_ = flow.last_step > 0 ? inner_number * liquid.density * spacing * spacing / flow.last_step : 0;
  begun_ = true;
}

template <int Dim>
void BodyWallLaw<Dim>::filter(std::size_t p, const Probes& seen, double dt, double nu) {
  const Point<Dim>& normal = points_[p].normal;
  const double distance = matching_place * points_[p].along;
  const Point<Dim> along_wall = seen.far[p] - seen.far[p].dot(normal) * normal;
  const double rate = karman * nu * wall_distance(along_wall.norm() * distance / nu) / (distance * distance);  // 1/T
  const double weight = begun_ ? dt * rate / (1 + dt * rate) : 1, slow = begun_ ? weight / longer : 1;
  const auto take = [&](Kept which, const Point<Dim>& now, double part) {
    Point<Dim>& mean = kept_[kept_of_each * p + which];
    mean += part * (now - mean);
  };
  take(far, along_wall, weight);
  take(low, seen.low[p], slow);
  take(high, seen.high[p], slow);
  take(flux_low, seen.low[p].dot(normal) * seen.low[p], slow);
  take(flux_high, seen.high[p].dot(normal) * seen.high[p], slow);
}

template <int Dim>
void BodyWallLaw<Dim>::set_viscosity(std::size_t p, const PureLiquid& liquid) {
  const WallPoint<Dim>& point = points_[p];
  const Point<Dim>* mean = &kept_[kept_of_each * p];
  const double speed = mean[far].norm(), distance = matching_place * point.along;
  const double nu = liquid.viscosity / liquid.density;
  y_plus_[p] = wall_distance(speed * distance / nu);
  const double part = holds_by(y_plus_[p]);
  if (part == 0) return;
  const Point<Dim> way = mean[far] / speed;
  const double friction = y_plus_[p] * nu / distance, stress = friction * friction;
  const auto by_eddies = [&](Kept at, Kept flux) {
    return -(mean[flux] - mean[at].dot(point.normal) * mean[at]).dot(way);
  };
  const double carried = lost_in_sampling * 0.5 * (by_eddies(low, flux_low) + by_eddies(high, flux_high));
  const double rest = stress - std::clamp(carried, 0.0, most_by_eddies * stress);
  const double slope = (mean[high] - mean[low]).dot(way) / ((high_place - low_place) * point.along);
  const double viscosity = liquid.density * rest / std::max(slope, 0.25 * speed / distance);
  weights_[p] = part * point.area * point.along;
  viscosities_[p] = weights_[p] * std::max(liquid.viscosity, viscosity);
}

template <int Dim>
void BodyWallLaw<Dim>::replace(Vec viscosity) const {
  const petsc::GlobalVector cover(grid_.face_dm()), covered(grid_.face_dm());
  WASH_PETSC(VecZeroEntries(cover));
  WASH_PETSC(VecZeroEntries(covered));
  transfer_.spread_mass(weights_, cover);
  transfer_.spread_mass(viscosities_, covered);
  const petsc::LocalVector local_cover(grid_.face_dm()), local_covered(grid_.face_dm()), local_share(grid_.face_dm());
  fill_local<Dim>(grid_, cover, 0, local_cover);
  fill_local<Dim>(grid_, covered, 0, local_covered);
  fill_local<Dim>(grid_, fluid_share_, 1, local_share);
  const ConstFaceView<Dim> weight(grid_.face_dm(), local_cover), weighted(grid_.face_dm(), local_covered);
  const ConstFaceView<Dim> share(grid_.face_dm(), local_share);
  const CellView<Dim> mu(grid_.cell_dm(), viscosity);
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
    double sum = 0, of_walls = 0, fluid = 0;
    visit_faces<Dim>(cell, [&](const Index<Dim>& face, int d) {
      sum += weight(face, d) / (2 * Dim);
      of_walls += weighted(face, d) / (2 * Dim);
      fluid += share(face, d) / (2 * Dim);
    });
    if (sum > 0) mu(cell) += smooth_step(sum / full_cover) * (of_walls / sum - mu(cell));
    const double inside = turbulent_ * smooth_step(1 - fluid / inside_below);
    mu(cell) += inside * std::max(0.0, inner_viscosity_ - mu(cell));
  });
}

template <int Dim>
std::vector<double> BodyWallLaw<Dim>::largest_y_plus() const {
  std::vector<double> plus(bodies_.size(), 0.0);
  for (std::size_t p = 0; p < points_.size(); ++p)
    plus[points_[p].body] = std::max(plus[points_[p].body], 0.5 / matching_place * y_plus_[p]);
  for (double& value : plus) value = largest(grid_.comm(), value);
  return plus;
}

template class BodyWallLaw<2>;
template class BodyWallLaw<3>;

}  // namespace washfsi
