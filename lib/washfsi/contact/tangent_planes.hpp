// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/contact_force.hpp"
#include "washfsi/contact/nearest_in_face.hpp"
#include "washfsi/contact/seen_faces.hpp"

namespace washfsi {

/// The tangent plane of a body's surface or a side of the box near a point of a cloth: a marker, or the place in a face
/// that is nearest to the body.
template <int Dim>
struct TangentPlane {
  static constexpr std::size_t no_face = static_cast<std::size_t>(-1);

  std::size_t face = no_face;              ///< index in the list of seen faces; `no_face`: a marker
  std::array<std::size_t, Dim> markers{};  ///< indices in own values and those with halo; a marker: first
  std::array<double, Dim> shares{};        ///< shares of the markers, of sum 1
  std::array<std::ptrdiff_t, Dim> own{};   ///< indices in this rank's arrays, or `SeenFaces::none`
  std::size_t piece = 0;
  double area = 0;  ///< undeformed area that the point stands for [m2; m in the plane]
  Point<Dim> start = Point<Dim>::Zero(), normal = Point<Dim>::Zero();  ///< start of the point [m]; outward normal
  double distance = 0;                                                 ///< distance of `start` at the step's end [m]
  double before = 0;                                                   ///< distance of `start` at the step's start [m]
  double begins = 0;                                                   ///< contact distance [m]
  double soft = 0;       ///< share of the contact distance below which a barrier is soft
  std::size_t body = 0;  ///< number of the body; for a side the count of bodies
  int axis = 0;
  End end = End::lower;

  bool is_of_face() const { return face != no_face; }
  /// How many markers the point lies between.
  std::size_t count() const { return is_of_face() ? Dim : 1; }
  /// Whether this rank counts it, in sums over all ranks.
  bool counts() const { return own[0] != SeenFaces<Dim>::none; }
  Point<Dim> place(const Points<Dim>& all) const {
    Point<Dim> sum = shares[0] * all[markers[0]];
    for (std::size_t i = 1; i < count(); ++i) sum += shares[i] * all[markers[i]];
    return sum;
  }
  /// The distance of the point at these places of the markers [m].
  double gap(const Points<Dim>& all) const { return distance + normal.dot(place(all) - start); }
  /// Calls visit(index among its markers, index among this rank's) for those of this rank.
  template <class Visit>
  void visit_own(const Visit& visit) const {
    for (std::size_t i = 0; i < count(); ++i)
      if (own[i] != SeenFaces<Dim>::none) visit(i, static_cast<std::size_t>(own[i]));
  }
  /// The number of its body or side as a thing, after those of all cloths.
  std::size_t thing(std::size_t cloths, std::size_t bodies) const {
    return cloths + body + (body < bodies ? 0 : 2 * static_cast<std::size_t>(axis) + (end == End::upper ? 1 : 0));
  }
};

/// Finds the planes near cloths when a step begins. In a step the distance from a body is taken as that from the plane,
/// with the body where it is at the step's end: linear in the places of the markers. Where the body would have run over
/// a point by then, the plane is that of the start, carried along with the body, so that the point stays on its side.
template <int Dim>
class TangentPlanes {
 public:
  /// With `sees_faces`, planes of faces are found in addition to those of markers; only those count that are nearer
  /// than the share `of_faces` of the contact distance of markers.
  TangentPlanes(const Surroundings<Dim>& around, bool sees_faces);

  static constexpr double of_faces = 0.5;

  /// Finds the planes to which points may come nearer than `distance` in this step, with a margin of as much; `all` and
  /// `speeds` [m/s] are of the markers and those with halo. No communication.
  std::vector<TangentPlane<Dim>> find(const Points<Dim>& all, const std::vector<double>& speeds, double distance,
                                      double time, double dt) const;
  /// Finds the planes at the step's end `time` where with the markers at `now` faces are nearer to bodies than `within`
  /// and than half of what the known planes show; `distance` is the contact distance. No communication.
  std::vector<TangentPlane<Dim>> missed(const std::vector<TangentPlane<Dim>>& known, const Points<Dim>& now,
                                        double distance, double within, double time) const;
  const SeenFaces<Dim>& faces() const { return faces_; }
  bool sees_faces() const { return sees_faces_; }
  /// The velocity of the surface at a plane at some time [m/s].
  Point<Dim> velocity_of_surface(const TangentPlane<Dim>& plane, double time) const;

 private:
  struct Look;
  struct StepLook;
  void add_markers(const StepLook& look, std::vector<TangentPlane<Dim>>& planes) const;
  void add_faces(const StepLook& look, std::vector<TangentPlane<Dim>>& planes) const;
  void add_face(const StepLook& look, std::size_t face, std::size_t body, std::vector<TangentPlane<Dim>>& planes) const;
  NearestInFace<Dim> nearest(const Look& look, std::size_t face, std::size_t body, double reach) const;
  TangentPlane<Dim> plane_of_face(const Look& look, std::size_t face, const NearestInFace<Dim>& found) const;
  void add_sides(const TangentPlane<Dim>& marker, double reach, std::vector<TangentPlane<Dim>>& planes) const;
  void set_plane(const StepLook& look, TangentPlane<Dim>& plane) const;

  Surroundings<Dim> around_;
  bool sees_faces_;
  SeenFaces<Dim> faces_;
};

extern template class TangentPlanes<2>;
extern template class TangentPlanes<3>;

}  // namespace washfsi
