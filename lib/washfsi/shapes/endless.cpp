// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/endless.hpp"

#include <limits>

namespace washfsi {

/// A part, in its own frame.
template <int Dim>
class Endless<Dim>::EndlessPart : public Shape<Dim> {
 public:
  EndlessPart(const Endless& whole, const typename Shape<Dim>::Part& part) : whole_(whole), part_(part) {}
  double distance(const Point<Dim>& place) const override {
    return part_.shape->distance(part_.pose.in_body_frame(whole_.at_place(part_.pose.in_space(place))));
  }
  Extent<Dim> extent() const override {
    const bool turned = part_.pose.sine != 0 || part_.pose.cosine != 1;
    return whole_.axis_ < 2 && turned ? Extent<Dim>::infinite() : whole_.endless(part_.shape->extent());
  }

 private:
  const Endless& whole_;
  typename Shape<Dim>::Part part_;
};

template <int Dim>
Endless<Dim>::Endless(ShapePtr<Dim> inner, int axis, double place)
    : inner_(std::move(inner)), axis_(axis), place_(place) {
  std::vector<typename Shape<Dim>::Part> parts;
  inner_->add_parts({}, parts);
  for (const auto& part : parts) parts_.push_back({std::make_unique<EndlessPart>(*this, part), part.pose});
}

template <int Dim>
Extent<Dim> Endless<Dim>::extent() const {
  return endless(inner_->extent());
}

template <int Dim>
Extent<Dim> Endless<Dim>::endless(Extent<Dim> extent) const {
  extent.bounds.lower[axis_] = -std::numeric_limits<double>::infinity();
  extent.bounds.upper[axis_] = std::numeric_limits<double>::infinity();
  return extent;
}

template <int Dim>
void Endless<Dim>::add_parts(const Pose<Dim>& pose, std::vector<typename Shape<Dim>::Part>& parts) const {
  for (const Part& part : parts_) parts.push_back({part.shape.get(), pose.in_space(part.pose)});
}

template class Endless<2>;
template class Endless<3>;

}  // namespace washfsi
