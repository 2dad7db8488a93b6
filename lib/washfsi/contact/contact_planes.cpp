// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/contact_planes.hpp"

#include <algorithm>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr double sharper = 0.25;  // the next soft share over that within which the solution must not lie

}  // namespace

template <int Dim>
ContactPlanes<Dim>::ContactPlanes(const BodyContactOptions& options, const Surroundings<Dim>& around,
                                  PairDistances& distances)
    : options_(options),
      around_(around),
      distances_(distances),
      finder_(around, options.law == BodyContactLaw::barrier) {}

template <int Dim>
Points<Dim> ContactPlanes<Dim>::with_halo(const Points<Dim>& values) const {
  if (!has_faces_) return values;
  Points<Dim> all = values;
  const Points<Dim> halo = around_.cloths.lattices().with_halo(values);
  all.insert(all.end(), halo.begin(), halo.end());
  return all;
}

template <int Dim>
void ContactPlanes<Dim>::find_whether_faces_touch() {
  has_faces_ = any_rank(around_.cloths.comm(), std::ranges::any_of(planes_, &Plane::is_of_face));
}

template <int Dim>
Points<Dim> ContactPlanes<Dim>::find(const StepStart<Dim>& start) {
  time_ = start.time;
  has_faces_ = finder_.sees_faces();
  const Points<Dim> all = with_halo(start.positions);
  Points<Dim> velocities = with_halo(start.velocities);
  std::vector<double> speeds;
  for (const auto& velocity : velocities) speeds.push_back(velocity.norm());
  planes_ = finder_.find(all, speeds, options_.distance, time_, start.dt);
  find_whether_faces_touch();
  follow_distances();
  for (Plane& plane : planes_) plane.soft = plane.distance < soft_start * plane.begins ? soft_start : 0;
  return velocities;
}

// Only a barrier is so stiff that it would throw off cloth that starts within it.
template <int Dim>
void ContactPlanes<Dim>::follow_distances() {
  if (options_.law != BodyContactLaw::barrier) return;
  const std::size_t cloths = around_.cloths.pieces().size(), bodies = around_.bodies.size();
  const bool starts = !distances_.has_started();
  if (starts || !distances_.less().empty()) {
    PairDistances::Nearest nearest;
    for (const Plane& plane : planes_)
      if (const double now = plane.before * options_.distance / plane.begins; now < options_.distance)
        note(nearest, plane.piece, plane.thing(cloths, bodies), now);
    if (starts)
      distances_.start(around_.cloths.comm(), nearest);
    else
      distances_.follow(around_.cloths.comm(), nearest, options_.distance);
  }
  for (Plane& plane : planes_) plane.begins *= begins_over_usual(plane);
}

template <int Dim>
double ContactPlanes<Dim>::begins_over_usual(const Plane& plane) const {
  if (distances_.less().empty()) return 1;
  return distances_.of(plane.piece, plane.thing(around_.cloths.pieces().size(), around_.bodies.size())) /
         options_.distance;
}

template <int Dim>
bool ContactPlanes<Dim>::sharpen(const Points<Dim>& positions) {
  if (options_.law != BodyContactLaw::barrier) return false;
  has_faces_ = finder_.sees_faces();
  const Points<Dim> all = with_halo(positions);
  const bool is_harder = soften_less(all), is_denser = add_missed(all);
  find_whether_faces_touch();
  return any_rank(around_.cloths.comm(), is_harder || is_denser);
}

// The barrier begins to be soft nearer to the surface where the solution lies deep in its soft part.
template <int Dim>
bool ContactPlanes<Dim>::soften_less(const Points<Dim>& all) {
  bool is_harder = false;
  for (Plane& plane : planes_) {
    const double least = sharper * plane.soft;
    if (plane.soft == 0 || plane.gap(all) >= least * plane.begins) continue;
    plane.soft = least;
    is_harder = true;
  }
  return is_harder;
}

// Adds planes where faces have come nearer to bodies than their planes show, as they turn about the place of these.
template <int Dim>
bool ContactPlanes<Dim>::add_missed(const Points<Dim>& all) {
  if (!finder_.sees_faces()) return false;
  const double within = soft_start * TangentPlanes<Dim>::of_faces * options_.distance;
  std::vector<Plane> missed = finder_.missed(planes_, all, options_.distance, within, time_);
  for (Plane& plane : missed) {
    plane.begins *= begins_over_usual(plane);
    plane.soft = soft_start;
  }
  planes_.insert(planes_.end(), missed.begin(), missed.end());
  return !missed.empty();
}

template class ContactPlanes<2>;
template class ContactPlanes<3>;

}  // namespace washfsi
