// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/body_contact_law.hpp"
#include "washfsi/contact/tangent_planes.hpp"

namespace washfsi {

/// The tangent planes that cloth may touch in a step, each with its contact distance and the share of this below which
/// its barrier is soft; and how they push.
template <int Dim>
class ContactPlanes {
 public:
  using Plane = TangentPlane<Dim>;

  /// Points that start nearer than this share of their contact distance have a soft barrier.
  static constexpr double soft_start = 0.1;

  /// The contact distances and what surrounds the cloths must outlive it.
  ContactPlanes(const BodyContactOptions& options, const Surroundings<Dim>& around, PairDistances& distances);

  /// Finds the planes of a step, and updates the contact distances of what started in contact. Returns the velocities
  /// of the markers and of those with halo where faces were searched [m/s]. Collective.
  Points<Dim> find(const StepStart<Dim>& start);
  /// Refines the planes where the solution of the step lies deep in their soft part, or nearer to a body than they
  /// show. Returns whether any rank did. Collective.
  bool sharpen(const Points<Dim>& positions);

  const std::vector<Plane>& list() const { return planes_; }
  /// The time for which they were found [s].
  double time() const { return time_; }
  const TangentPlanes<Dim>& finder() const { return finder_; }

  /// The values of this rank's markers, followed by those with halo where faces need these: planes index them so.
  /// Collective.
  Points<Dim> with_halo(const Points<Dim>& values) const;
  /// The push of a plane at some distance [m], on the area that the point stands for: energy [J], force [N] and
  /// stiffness [N/m].
  BodyPush push(const Plane& plane, double gap) const {
    const BodyPush push = body_push(options_, gap, plane.begins, plane.soft);
    return {plane.area * push.energy, plane.area * push.pressure, plane.area * push.stiffness};
  }
  /// The push at these places of the markers, as `with_halo` gives them.
  BodyPush push(const Plane& plane, const Points<Dim>& all) const { return push(plane, plane.gap(all)); }

 private:
  void find_whether_faces_touch();
  void follow_distances();
  double begins_over_usual(const Plane& plane) const;
  bool soften_less(const Points<Dim>& all);
  bool add_missed(const Points<Dim>& all);

  BodyContactOptions options_;
  Surroundings<Dim> around_;
  PairDistances& distances_;
  TangentPlanes<Dim> finder_;
  double time_ = 0;  ///< the step's end [s]
  std::vector<Plane> planes_;
  bool has_faces_ = false;  ///< whether any rank has a plane of a face, or may find one
};

extern template class ContactPlanes<2>;
extern template class ContactPlanes<3>;

}  // namespace washfsi
