// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/tangent_planes.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace washfsi {

/// The markers and the bodies at a step's end.
template <int Dim>
struct TangentPlanes<Dim>::Look {
  Look(const Points<Dim>& places, PosedBodies<Dim> bodies, const Grid<Dim>& grid, double contact_distance)
      : all(places), end(std::move(bodies)), distance(contact_distance) {
    for (std::size_t body = 0; body < end.size(); ++body) {
      std::vector<double>& of_body = distances.emplace_back();
      for (const auto& place : all) of_body.push_back(end.distance(body, grid.folded(place)));
    }
  }

  const Points<Dim>& all;
  PosedBodies<Dim> end;
  double distance;
  std::vector<std::vector<double>> distances;  ///< distances of all places from each body at the step's end [m]
};

/// A search from the step's start on.
template <int Dim>
struct TangentPlanes<Dim>::StepLook : Look {
  PosedBodies<Dim> start;
  const std::vector<double>& speeds;
  double dt;

  // The distance within which a point may come into contact in the step, with a margin of as much.
  double reach(double contact, double speed) const { return dt > 0 ? 2 * (contact + dt * speed) : contact; }
};

template <int Dim>
TangentPlanes<Dim>::TangentPlanes(const Surroundings<Dim>& around, bool sees_faces)
    : around_(around), sees_faces_(sees_faces && !around.bodies.empty()), faces_(around.cloths) {}

template <int Dim>
std::vector<TangentPlane<Dim>> TangentPlanes<Dim>::find(const Points<Dim>& all, const std::vector<double>& speeds,
                                                        double distance, double time, double dt) const {
  const StepLook look{{all, PosedBodies<Dim>(around_.bodies, time), around_.grid, distance},
                      PosedBodies<Dim>(around_.bodies, time - dt),
                      speeds,
                      dt};
  std::vector<TangentPlane<Dim>> planes;
  add_markers(look, planes);
  if (sees_faces_) add_faces(look, planes);
  return planes;
}

template <int Dim>
void TangentPlanes<Dim>::add_markers(const StepLook& look, std::vector<TangentPlane<Dim>>& planes) const {
  const Cloths<Dim>& cloths = around_.cloths;
  for (std::size_t m = 0; m < cloths.owned(); ++m) {
    TangentPlane<Dim> plane;
    plane.markers[0] = m;
    plane.shares[0] = 1;
    plane.own[0] = static_cast<std::ptrdiff_t>(m);
    plane.piece = cloths.piece_of_marker()[m];
    plane.area = cloths.marker_areas()[m];
    plane.begins = look.distance;
    plane.start = look.all[m];
    const double reach = look.reach(look.distance, look.speeds[m]);
    for (plane.body = 0; plane.body < look.end.size(); ++plane.body) {
      plane.distance = look.distances[plane.body][m];
      if (plane.distance >= reach) continue;
      set_plane(look, plane);
      planes.push_back(plane);
    }
    add_sides(plane, reach, planes);
  }
}

template <int Dim>
void TangentPlanes<Dim>::add_sides(const TangentPlane<Dim>& marker, double reach,
                                   std::vector<TangentPlane<Dim>>& planes) const {
  TangentPlane<Dim> plane = marker;
  for (plane.axis = 0; plane.axis < Dim; ++plane.axis)
    for (const End end : {End::lower, End::upper}) {
      const BoundaryKind kind = around_.boundary.side(plane.axis, end).kind;
      if (kind != BoundaryKind::wall && kind != BoundaryKind::slip) continue;
      const bool upper = end == End::upper;
      plane.end = end;
      plane.distance = plane.before = upper ? around_.grid.upper()[plane.axis] - plane.start[plane.axis]
                                            : plane.start[plane.axis] - around_.grid.lower()[plane.axis];
      plane.normal = (upper ? -1 : 1) * Point<Dim>::Unit(plane.axis);
      if (plane.distance < reach) planes.push_back(plane);
    }
}

// The body has run over the point if it contains it at the end and did not at the start.
template <int Dim>
void TangentPlanes<Dim>::set_plane(const StepLook& look, TangentPlane<Dim>& plane) const {
  const Point<Dim> place = around_.grid.folded(plane.start);
  const double step = 1e-3 * look.distance;
  plane.before = look.start.distance(plane.body, place);
  if (plane.distance >= 0 || plane.before < 0) {
    plane.normal = look.end.normal(plane.body, place, step);
    return;
  }
  const Point<Dim> normal = look.start.normal(plane.body, place, step), foot = place - plane.before * normal;
  const Point<Dim> shift = place - look.start[plane.body].beside(place);  // shift of the nearest image
  const auto carried = [&](const Point<Dim>& point) -> Point<Dim> {
    return look.end.in_space(plane.body, look.start.in_body_frame(plane.body, point - shift)) + shift;
  };
  plane.normal = carried(place) - carried(place - normal);
  plane.distance = plane.normal.dot(place - carried(foot));
}

template <int Dim>
void TangentPlanes<Dim>::add_faces(const StepLook& look, std::vector<TangentPlane<Dim>>& planes) const {
  for (std::size_t face = 0; face < faces_.list().size(); ++face)
    for (std::size_t body = 0; body < look.end.size(); ++body) add_face(look, face, body, planes);
}

template <int Dim>
void TangentPlanes<Dim>::add_face(const StepLook& look, std::size_t number, std::size_t body,
                                  std::vector<TangentPlane<Dim>>& planes) const {
  const auto& face = faces_.list()[number];
  double speed = 0;
  for (const std::size_t seen : face.seen) speed = std::max(speed, look.speeds[around_.cloths.owned() + seen]);
  const double begins = of_faces * look.distance, reach = look.reach(begins, speed);
  const NearestInFace<Dim> found = nearest(look, number, body, reach);
  if (found.distance >= reach) return;
  TangentPlane<Dim> plane = plane_of_face(look, number, found);
  plane.body = body;
  plane.start = plane.place(look.all);
  set_plane(look, plane);
  planes.push_back(plane);
}

// A face that comes nearest at a marker, as it does to any wide body, is kept away by that marker's plane: its distance
// counts as infinite.
template <int Dim>
NearestInFace<Dim> TangentPlanes<Dim>::nearest(const Look& look, std::size_t number, std::size_t body,
                                               double reach) const {
  std::array<Point<Dim>, Dim> corners;
  std::array<double, Dim> at_corners;
  double nearest = INFINITY, longest = 0;
  for (std::size_t i = 0; i < Dim; ++i) {
    const std::size_t marker = around_.cloths.owned() + faces_.list()[number].seen[i];
    corners[i] = look.all[marker];
    at_corners[i] = look.distances[body][marker];
    nearest = std::min(nearest, at_corners[i]);
    longest = std::max(longest, (corners[i] - corners[0]).norm());
  }
  if (nearest > reach + longest) return {{}, INFINITY};
  const auto distance = [&](const Point<Dim>& place) { return look.end.distance(body, around_.grid.folded(place)); };
  const NearestInFace<Dim> found = nearest_in_face<Dim>(corners, at_corners, reach, distance);
  return {found.shares, found.distance > nearest - 1e-3 * look.distance ? INFINITY : found.distance};
}

template <int Dim>
TangentPlane<Dim> TangentPlanes<Dim>::plane_of_face(const Look& look, std::size_t number,
                                                    const NearestInFace<Dim>& found) const {
  const auto& face = faces_.list()[number];
  TangentPlane<Dim> plane;
  plane.face = number;
  for (std::size_t i = 0; i < Dim; ++i) plane.markers[i] = around_.cloths.owned() + face.seen[i];
  plane.shares = found.shares;
  plane.own = face.own;
  plane.piece = face.piece;
  plane.area = face.area;
  plane.begins = of_faces * look.distance;
  plane.distance = found.distance;
  return plane;
}

// The body's surface is straight about the place where the face is now.
template <int Dim>
std::vector<TangentPlane<Dim>> TangentPlanes<Dim>::missed(const std::vector<TangentPlane<Dim>>& known,
                                                          const Points<Dim>& now, double distance, double within,
                                                          double time) const {
  std::map<std::pair<std::size_t, std::size_t>, double> gaps;  // least ones of faces and bodies
  for (const auto& plane : known) {
    if (!plane.is_of_face()) continue;
    double& least = gaps.try_emplace({plane.face, plane.body}, INFINITY).first->second;
    least = std::min(least, plane.gap(now));
  }
  const Look look(now, PosedBodies<Dim>(around_.bodies, time), around_.grid, distance);
  std::vector<TangentPlane<Dim>> planes;
  for (std::size_t face = 0; face < faces_.list().size(); ++face)
    for (std::size_t body = 0; body < look.end.size(); ++body) {
      const NearestInFace<Dim> found = nearest(look, face, body, within);
      const auto gap = gaps.find({face, body});
      if (found.distance >= within || (gap != gaps.end() && found.distance >= 0.5 * gap->second)) continue;
      TangentPlane<Dim> plane = plane_of_face(look, face, found);
      plane.body = body;
      plane.start = plane.place(now);
      plane.before = plane.distance;
      plane.normal = look.end.normal(body, around_.grid.folded(plane.start), 1e-3 * distance);
      planes.push_back(plane);
    }
  return planes;
}

template <int Dim>
Point<Dim> TangentPlanes<Dim>::velocity_of_surface(const TangentPlane<Dim>& plane, double time) const {
  const Point<Dim> place = around_.grid.folded(plane.start);
  if (plane.body < around_.bodies.size()) return around_.bodies[plane.body].at(time).velocity(place);
  const Side<Dim>& side = around_.boundary.side(plane.axis, plane.end);
  return side.motion ? side.motion(place, time) : side.velocity;
}

template class TangentPlanes<2>;
template class TangentPlanes<3>;

}  // namespace washfsi
