// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/immersed_boundary/transfer.hpp"
#include "washfsi/wall_law/wall_points.hpp"

namespace washfsi {

/// This rank's points of the walls, placed in space as the bodies are at a time: where the water is sampled, where the
/// friction acts on it, and where the inner water slides.
template <int Dim>
class PlacedPoints {
 public:
  // Distances before the surface, in cells; behind it the constraint begins at 5/2. Of friction that acts at 1, up to a
  // fifth falls on the water inside, depending on where the wall lies in its cell; at 3/2 up to 3 %.
  static constexpr double acting_place = 1.5, matching_place = 3, inner_place = -3;

  /// `all` are the points of all ranks, which are dealt out evenly; the bodies stay alive. Collective.
  PlacedPoints(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
               const std::vector<WallPoint<Dim>>& all);

  /// Places the points as the bodies are at `time` [s]. Collective.
  void place(double time);
  double time() const { return time_; }  ///< time of the last `place` [s]

  std::size_t count() const { return count_; }  ///< number of points on all ranks
  std::size_t begin() const { return begin_; }  ///< number of this rank's first point among all
  std::size_t size() const { return points_.size(); }
  const WallPoint<Dim>& operator[](std::size_t point) const { return points_[point]; }
  /// Distance before the surface at which the law is matched to the water [m].
  double matching_distance(std::size_t point) const { return matching_place * points_[point].along; }
  /// The face of a patch that a point is on: twice the patch's number, plus 1 on a sheet's other face.
  std::size_t face(std::size_t point) const { return faces_[point]; }

  /// The place at which the friction of a point acts [m]; and whether it acts: not where another body or a side is too
  /// near.
  const Point<Dim>& place_of(std::size_t point) const { return places_[point]; }
  bool acts(std::size_t point) const { return acts_[point]; }
  /// The velocity of a point's body at this place [m/s]; at another time as the motions given, those of all bodies.
  using Motions = std::vector<typename RigidMotion<Dim>::State>;
  Point<Dim> body_velocity(std::size_t point, const Motions& motions) const {
    return motions[points_[point].body].velocity_at(places_[point]);
  }
  const Motions& motions() const { return motions_; }

  /// Velocities along the walls, relative to the bodies and in their frames, at a distance in cells before them [m/s].
  Points<Dim> speeds_along(Vec local_velocity, double distance) const;
  /// Turns values at the points from the bodies' frames into space, or back.
  Points<Dim> turned(Points<Dim> values, bool into_space) const;

  const Transfer<Dim>& transfer() const { return transfer_; }  ///< spreads and interpolates where the friction acts
  const Transfer<Dim>& inner() const { return inner_; }        ///< spreads at the inner water behind the walls
  /// The volume of inner water that each point covers, 0 beyond the box [m3; m2 in the plane].
  const std::vector<double>& covers() const { return covers_; }

 private:
  bool is_free(const PosedBodies<Dim>& posed, const WallPoint<Dim>& point, const Point<Dim>& place) const;

  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  std::size_t count_, begin_;
  std::vector<WallPoint<Dim>> points_;
  std::vector<std::size_t> faces_;
  Transfer<Dim> transfer_, inner_;
  double time_ = 0;
  Motions motions_;
  Points<Dim> places_, normals_;  ///< where friction acts [m], and outward normals
  std::vector<char> acts_;
  std::vector<double> covers_;
};

extern template class PlacedPoints<2>;
extern template class PlacedPoints<3>;

}  // namespace washfsi
