// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/combinations.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace washfsi {

namespace {

template <int Dim>
std::vector<Extent<Dim>> extents_of(const ShapeList<Dim>& parts) {
  std::vector<Extent<Dim>> extents;
  for (const auto& part : parts) extents.push_back(part->extent());
  return extents;
}

}  // namespace

template <int Dim>
double Union<Dim>::distance(const Point<Dim>& place) const {
  double least = std::numeric_limits<double>::max();
  for (const auto& part : parts_) least = std::min(least, part->distance(place));
  return least;
}

template <int Dim>
Extent<Dim> Union<Dim>::extent() const {
  return Extent<Dim>::of_union(extents_of(parts_));
}

template <int Dim>
double Intersection<Dim>::distance(const Point<Dim>& place) const {
  double largest = std::numeric_limits<double>::lowest();
  for (const auto& part : parts_) largest = std::max(largest, part->distance(place));
  return largest;
}

template <int Dim>
Extent<Dim> Intersection<Dim>::extent() const {
  return Extent<Dim>::of_intersection(extents_of(parts_));
}

template <int Dim>
Repeated<Dim>::Repeated(ShapePtr<Dim> inner, int copies) : inner_(std::move(inner)) {
  for (int k = 0; k < copies; ++k)
    poses_.push_back(Pose<Dim>::at(Point<Dim>::Zero(), 2 * std::numbers::pi * k / copies));
}

template <int Dim>
double Repeated<Dim>::distance(const Point<Dim>& place) const {
  double least = std::numeric_limits<double>::max();
  for (const auto& pose : poses_) least = std::min(least, inner_->distance(pose.in_body_frame(place)));
  return least;
}

template <int Dim>
Extent<Dim> Repeated<Dim>::extent() const {
  std::vector<Extent<Dim>> extents;
  for (const auto& pose : poses_) extents.push_back(inner_->extent().in_space(pose));
  return Extent<Dim>::of_union(extents);
}

template <int Dim>
ShapePtr<Dim> difference(ShapeList<Dim> parts) {
  for (std::size_t k = 1; k < parts.size(); ++k) parts[k] = std::make_unique<Inverted<Dim>>(std::move(parts[k]));
  return std::make_unique<Intersection<Dim>>(std::move(parts));
}

template class Union<2>;
template class Union<3>;
template class Intersection<2>;
template class Intersection<3>;
template class Repeated<2>;
template class Repeated<3>;
template ShapePtr<2> difference<2>(ShapeList<2>);
template ShapePtr<3> difference<3>(ShapeList<3>);

}  // namespace washfsi
