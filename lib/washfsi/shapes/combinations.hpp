// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Distances of combined shapes. Of exact parts, the least (union) is exact outside and the largest (intersection)
// exact inside; elsewhere they are bounds: of the right sign, zero on the surface, and not larger in size than the true
// distance. The difference is the intersection with complements, so it is exact inside.

#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// The union of its parts.
template <int Dim>
class Union : public Shape<Dim> {
 public:
  explicit Union(ShapeList<Dim> parts) : parts_(std::move(parts)) {}
  double distance(const Point<Dim>& place) const override;
  Extent<Dim> extent() const override;
  void add_parts(const Pose<Dim>& pose, std::vector<typename Shape<Dim>::Part>& parts) const override {
    for (const auto& part : parts_) part->add_parts(pose, parts);
  }

 private:
  ShapeList<Dim> parts_;  ///< at least one
};

/// The intersection of its parts.
template <int Dim>
class Intersection : public Shape<Dim> {
 public:
  explicit Intersection(ShapeList<Dim> parts) : parts_(std::move(parts)) {}
  double distance(const Point<Dim>& place) const override;
  Extent<Dim> extent() const override;

 private:
  ShapeList<Dim> parts_;  ///< at least one
};

/// The solid is everything outside another shape (a drum).
template <int Dim>
class Inverted : public Shape<Dim> {
 public:
  explicit Inverted(ShapePtr<Dim> inner) : inner_(std::move(inner)) {}
  double distance(const Point<Dim>& place) const override { return -inner_->distance(place); }
  Extent<Dim> extent() const override { return inner_->extent().inverted(); }
  bool is_inverted() const override { return !inner_->is_inverted(); }

 private:
  ShapePtr<Dim> inner_;
};

/// A shape grown by a radius, which rounds its convex edges. Exact outside where the inner distance is; a bound inside.
template <int Dim>
class Rounded : public Shape<Dim> {
 public:
  Rounded(ShapePtr<Dim> inner, double radius) : inner_(std::move(inner)), radius_(radius) {}
  double distance(const Point<Dim>& place) const override { return inner_->distance(place) - radius_; }
  Extent<Dim> extent() const override { return inner_->extent().grown(radius_); }

 private:
  ShapePtr<Dim> inner_;
  double radius_;
};

/// A shape in its place in a parent's frame.
template <int Dim>
class Placed : public Shape<Dim> {
 public:
  Placed(ShapePtr<Dim> inner, const Pose<Dim>& pose) : inner_(std::move(inner)), pose_(pose) {}
  double distance(const Point<Dim>& place) const override { return inner_->distance(pose_.in_body_frame(place)); }
  Extent<Dim> extent() const override { return inner_->extent().in_space(pose_); }
  void add_parts(const Pose<Dim>& pose, std::vector<typename Shape<Dim>::Part>& parts) const override {
    inner_->add_parts(pose.in_space(pose_), parts);
  }

 private:
  ShapePtr<Dim> inner_;
  Pose<Dim> pose_;
};

/// The union of equal copies spread evenly about z (about the origin in the plane); the first is the shape itself.
template <int Dim>
class Repeated : public Shape<Dim> {
 public:
  Repeated(ShapePtr<Dim> inner, int copies);
  double distance(const Point<Dim>& place) const override;
  Extent<Dim> extent() const override;
  void add_parts(const Pose<Dim>& pose, std::vector<typename Shape<Dim>::Part>& parts) const override {
    for (const auto& copy : poses_) inner_->add_parts(pose.in_space(copy), parts);
  }

 private:
  ShapePtr<Dim> inner_;
  std::vector<Pose<Dim>> poses_;
};

/// The difference: the first part without all others.
template <int Dim>
ShapePtr<Dim> difference(ShapeList<Dim> parts);

extern template class Union<2>;
extern template class Union<3>;
extern template class Intersection<2>;
extern template class Intersection<3>;
extern template class Repeated<2>;
extern template class Repeated<3>;
extern template ShapePtr<2> difference<2>(ShapeList<2>);
extern template ShapePtr<3> difference<3>(ShapeList<3>);

}  // namespace washfsi
