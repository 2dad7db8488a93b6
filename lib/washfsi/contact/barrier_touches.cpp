// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/barrier_touches.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/contact/barrier_function.hpp"

namespace washfsi {

template <int Dim>
void BarrierTouches<Dim>::find_near(const Points<Dim>& positions, const std::vector<double>& reaches, Before before) {
  const auto of_surfaces = [this](std::size_t marker, std::size_t other) { return distance_of(marker, other); };
  const auto of_pairs = [&](std::size_t marker, std::size_t other) { return of_guards * of_surfaces(marker, other); };
  search_.find_near(positions, reaches, 2 * distances_.usual(), before);
  pairs_ = search_.pairs(of_pairs, of_guards * distances_.usual());
  samples_ = search_.samples(of_surfaces, distances_.usual());
}

// Present least distances of cloths, scaled to the contact distance of surfaces.
template <int Dim>
PairDistances::Nearest BarrierTouches<Dim>::nearest(const Points<Dim>& all) const {
  const NearMarkers<Dim>& known = search_.known();
  PairDistances::Nearest nearest;
  const auto note_distance = [&](std::size_t marker, std::size_t other, double distance) {
    if (distance < distances_.usual()) note(nearest, known.piece_of(marker), known.piece_of(other), distance);
  };
  for (const auto& sample : samples_)
    for (const auto& opposite : sample.opposites)
      note_distance(sample.face[0], opposite.face[0], distance_between(sample, opposite, all));
  for (const auto& pair : pairs_)
    note_distance(pair.markers.front(), pair.markers.back(), gap_of<Dim>(pair.kind, pair.at(all)).distance / of_guards);
  return nearest;
}

template <int Dim>
void BarrierTouches<Dim>::follow_distances(const Points<Dim>& all) {
  if (!distances_.has_started())
    distances_.start(comm_, nearest(all));
  else if (!distances_.less().empty())
    distances_.follow(comm_, nearest(all), least_reach());
}

template <int Dim>
Touch<Dim> BarrierTouches<Dim>::touch(const Facing<Dim>& facing, double weight, double distance) const {
  const BarrierValue b = barrier(facing.distance / distance);
  const double scale = stiffness_ * weight, push = -scale * b.first, stiffness = scale / distance * b.second;
  Touch<Dim> touch{
      facing, scale * distance * b.value, std::max(0.0, stiffness), std::min(0.0, stiffness), push, push, 0, false, {}};
  for (std::size_t i = 0; i < facing.count; ++i) touch.forces[i] = push * facing.shares[i] * facing.normal;
  return touch;
}

// A sample is pressed by one force, of which each part that it faces has a share, none negative.
template <int Dim>
void BarrierTouches<Dim>::add_surface_touches(const SurfaceSample<Dim>& sample, const Points<Dim>& all,
                                              std::vector<Touch<Dim>>& touches) const {
  const auto distance = [this](std::size_t marker, std::size_t other) { return distance_of(marker, other); };
  const std::size_t first = touches.size();
  double sum = 0, pushed = 0;
  for (const auto& [facing, times] : faced_by<Dim>(sample, all, distance)) {
    const double begins = distance_of(facing.markers[0], facing.markers[Dim]);
    if (facing.distance >= begins) continue;
    touches.push_back(touch(facing, times * sample.weight, begins));
    sum += touches.back().push;
    pushed += std::max(0.0, touches.back().push);
  }
  for (std::size_t n = first; n < touches.size(); ++n) {
    const double share = std::max(0.0, touches[n].push) / pushed;
    touches[n].pressing = share * std::max(0.0, sum);
    touches[n].area = share * sample.weight;
  }
}

// Facets at distance 0, which are impossible positions of cloth, have no barrier.
template <int Dim>
void BarrierTouches<Dim>::add_guard_touch(const FacetPair<Dim>& pair, const Points<Dim>& all,
                                          std::vector<Touch<Dim>>& touches) const {
  const PairPoints<Dim> places = pair.at(all);
  const Gap<Dim> gap = gap_of<Dim>(pair.kind, places);
  if (gap.distance == 0 || gap.distance >= of_guards * distances_.usual()) return;
  const double begins = of_guards * distance_of(pair.markers.front(), pair.markers.back());
  if (gap.distance >= begins) return;
  Facing<Dim> facing;
  for (std::size_t i = 0; i < places.size(); ++i) facing.add(pair.markers[i], gap.shares[i]);
  facing.distance = gap.distance;
  facing.normal = gap.normal;
  Touch<Dim> guard = touch(facing, pair.weight, begins);
  guard.is_guard = true;
  if constexpr (Dim == 3) {
    const Mollifier m = pair.parallel > 0 ? mollifier(places, pair.parallel) : Mollifier{};
    for (std::size_t i = 0; i < places.size(); ++i)
      guard.forces[i] = m.value * guard.forces[i] - guard.energy * m.gradient[i];
    for (double* value : {&guard.energy, &guard.stiffness, &guard.push, &guard.pressing}) *value *= m.value;
  }
  touches.push_back(guard);
}

template <int Dim>
std::vector<Touch<Dim>> BarrierTouches<Dim>::at(const Points<Dim>& all) const {
  std::vector<Touch<Dim>> touches;
  for (const auto& sample : samples_) add_surface_touches(sample, all, touches);
  for (const auto& pair : pairs_) add_guard_touch(pair, all, touches);
  return touches;
}

template <int Dim>
double BarrierTouches<Dim>::begins(const Touch<Dim>& touch) const {
  const std::size_t last = touch.facing.markers[touch.facing.count - 1];
  return (touch.is_guard ? of_guards : 1) * distance_of(touch.facing.markers[0], last);
}

template class BarrierTouches<2>;
template class BarrierTouches<3>;

}  // namespace washfsi
