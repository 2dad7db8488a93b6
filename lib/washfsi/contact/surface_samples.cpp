// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/surface_samples.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace washfsi {

namespace {

/// A corner, an edge or a face: its markers in ascending order, filled up with the last one.
template <int Dim>
using Feature = std::array<std::size_t, Dim>;

template <int Dim>
Feature<Dim> feature_of(const Facing<Dim>& facing) {
  const std::span markers(facing.markers.begin() + Dim, facing.count - Dim);
  Feature<Dim> feature{};
  feature.fill(std::ranges::max(markers));
  std::ranges::copy(markers, feature.begin());
  std::ranges::sort(feature);
  return feature;
}

/// Sums up how often each feature counts that contains the nearest point of a face, an edge or a corner.
template <int Dim>
class Count {
 public:
  using Sample = SurfaceSample<Dim>;
  using Opposite = typename Sample::Opposite;

  Count(const Sample& sample, const Points<Dim>& all) : sample_(sample), all_(all), place_(sample.place(all)) {}

  Gap<Dim> gap(const Opposite& opposite) const {
    PairPoints<Dim> places{place_};
    for (std::size_t i = 0; i < Dim; ++i) places[i + 1] = all_[opposite.face[i]] + opposite.shift;
    return gap_of<Dim>(PairKind::point_facet, places);
  }

  void add_face(const Opposite& opposite, const Gap<Dim>& gap) {
    Facing<Dim> facing = begin();
    for (std::size_t i = 0; i < Dim; ++i)
      if (gap.shares[i + 1] != 0) facing.add(opposite.face[i], gap.shares[i + 1]);
    facing.distance = gap.distance;
    facing.normal = gap.normal;
    add(facing, 1);
  }

  void add_edge(std::size_t from, std::size_t to, const Point<Dim>& shift, int times) {
    const double part = part_along<Dim>(all_[from] + shift, all_[to] + shift, place_);
    Facing<Dim> facing = begin();
    if (part < 1) facing.add(from, part - 1);
    if (part > 0) facing.add(to, -part);
    add_toward((1 - part) * all_[from] + part * all_[to] + shift, facing, times);
  }

  void add_corner(std::size_t corner, const Point<Dim>& shift, int times) {
    Facing<Dim> facing = begin();
    facing.add(corner, -1);
    add_toward(all_[corner] + shift, facing, times);
  }

  std::vector<CountedFacing<Dim>> result() const {
    std::vector<CountedFacing<Dim>> result;
    for (const auto& [feature, facing, times] : counted_)
      if (times != 0) result.push_back({facing, times});
    return result;
  }

 private:
  struct Counted {
    Feature<Dim> feature;
    Facing<Dim> facing;
    int times;
  };

  Facing<Dim> begin() const {
    Facing<Dim> facing;
    for (std::size_t i = 0; i < Dim; ++i) facing.add(sample_.face[i], sample_.shares[i]);
    return facing;
  }
  void add_toward(const Point<Dim>& foot, Facing<Dim>& facing, int times) {
    const Point<Dim> way = place_ - foot;
    facing.distance = way.norm();
    if (facing.distance == 0) return;
    facing.normal = way / facing.distance;
    add(facing, times);
  }
  void add(const Facing<Dim>& facing, int times) {
    const Feature<Dim> feature = feature_of(facing);
    const auto place = std::ranges::find(counted_, feature, &Counted::feature);
    if (place != counted_.end())
      place->times += times;
    else
      counted_.push_back({feature, facing, times});
  }

  const Sample& sample_;
  const Points<Dim>& all_;
  Point<Dim> place_;
  std::vector<Counted> counted_;
};

/// An edge or a corner of near faces, and how many of them share it.
template <std::size_t Size, int Dim>
struct Shared {
  std::array<std::size_t, Size> markers;
  Point<Dim> shift;
  int faces = 0, excess = 0;  ///< excess: how often all edges that meet at a corner are subtracted
};

template <std::size_t Size, int Dim>
Shared<Size, Dim>& shared(std::vector<Shared<Size, Dim>>& list, const std::array<std::size_t, Size>& markers,
                          const Point<Dim>& shift) {
  const auto place = std::ranges::find(list, markers, &Shared<Size, Dim>::markers);
  if (place != list.end()) return *place;
  return list.emplace_back(Shared<Size, Dim>{markers, shift});
}

template <int Dim>
using Near = std::vector<const typename SurfaceSample<Dim>::Opposite*>;

template <int Dim>
std::vector<Shared<1, Dim>> corners_of(const Near<Dim>& near) {
  std::vector<Shared<1, Dim>> corners;
  for (const auto* opposite : near)
    for (const std::size_t marker : opposite->face) ++shared<1, Dim>(corners, {marker}, opposite->shift).faces;
  return corners;
}

// In the plane a face has no edges but itself.
template <int Dim>
std::vector<Shared<2, Dim>> edges_of(const Near<Dim>& near) {
  std::vector<Shared<2, Dim>> edges;
  if constexpr (Dim == 3)
    for (const auto* opposite : near)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [from, to] = std::minmax(opposite->face[i], opposite->face[(i + 1) % 3]);
        ++shared<2, 3>(edges, {from, to}, opposite->shift).faces;
      }
  return edges;
}

}  // namespace

template <int Dim>
std::vector<CountedFacing<Dim>> faced_by(const SurfaceSample<Dim>& sample, const Points<Dim>& all,
                                         const ContactDistance& distance) {
  Count<Dim> count(sample, all);
  Near<Dim> near;
  for (const auto& opposite : sample.opposites) {
    const Gap<Dim> gap = count.gap(opposite);
    if (gap.distance == 0 || gap.distance >= distance(sample.face[0], opposite.face[0])) continue;
    near.push_back(&opposite);
    count.add_face(opposite, gap);
  }
  if (near.size() < 2) return count.result();
  std::vector<Shared<1, Dim>> corners = corners_of<Dim>(near);
  for (const auto& edge : edges_of<Dim>(near)) {
    for (const std::size_t marker : edge.markers)
      shared<1, Dim>(corners, {marker}, edge.shift).excess += edge.faces - 1;
    if (edge.faces > 1) count.add_edge(edge.markers[0], edge.markers[1], edge.shift, 1 - edge.faces);
  }
  for (const auto& corner : corners)
    if (const int times = 1 - corner.faces + corner.excess; times != 0)
      count.add_corner(corner.markers[0], corner.shift, times);
  return count.result();
}

namespace {

template <int Dim>
bool share_a_marker(const typename Facets<Dim>::Face& first, const typename Facets<Dim>::Face& second) {
  return std::ranges::any_of(first, [&](std::size_t m) { return std::ranges::find(second, m) != second.end(); });
}

// Gauss points of the rule that is exact for cubic functions along a segment, for quadratic ones on a triangle.
template <int Dim>
std::array<std::array<double, Dim>, Dim> gauss_points() {
  constexpr double large = Dim == 2 ? 0.78867513459481287 : 2.0 / 3, small = (1 - large) / (Dim - 1);
  std::array<std::array<double, Dim>, Dim> points;
  for (std::size_t i = 0; i < Dim; ++i) {
    points[i].fill(small);
    points[i][i] = large;
  }
  return points;
}

/// Finds what each sample may face.
template <int Dim>
class SampleSearch {
 public:
  using Face = typename Facets<Dim>::Face;

  SampleSearch(const Facets<Dim>& facets, const Points<Dim>& all, const std::vector<double>& reaches,
               const ContactDistance& distance, double most, const PeriodicSpace<Dim>& space)
      : facets_(facets), all_(all), reaches_(reaches), distance_(distance), most_(most), space_(space) {}

  std::vector<SurfaceSample<Dim>> find() const {
    std::vector<Bounds<Dim>> boxes;
    Point<Dim> mean = Point<Dim>::Zero();
    for (const Face& face : facets_.faces) {
      boxes.push_back(bounds(face));
      mean += (boxes.back().upper - boxes.back().lower) / static_cast<double>(facets_.faces.size());
    }
    const NearSearch<Dim> search(boxes, mean, hull(boxes), space_);
    std::vector<SurfaceSample<Dim>> found;
    for (std::size_t f = 0; f < facets_.faces.size(); ++f)
      for (const auto& shares : gauss_points<Dim>()) {
        SurfaceSample<Dim> sample{facets_.faces[f], shares, 0.5 / Dim * facets_.face_areas[f], {}};
        const Point<Dim> margin = Point<Dim>::Constant(reach(sample.face) + 0.5 * most_);
        for (const std::size_t other : search.near(Bounds<Dim>::round(sample.place(all_), margin)))
          add_if_near(sample, facets_.faces[other]);
        if (!sample.opposites.empty()) found.push_back(std::move(sample));
      }
    return found;
  }

 private:
  double reach(const Face& face) const {
    double most = 0;
    for (const std::size_t marker : face) most = std::max(most, reaches_[marker]);
    return most;
  }
  Bounds<Dim> bounds(const Face& face) const {
    std::vector<Bounds<Dim>> boxes;
    for (const std::size_t marker : face)
      boxes.push_back(Bounds<Dim>::round(all_[marker], Point<Dim>::Constant(reaches_[marker] + 0.5 * most_)));
    return hull(boxes);
  }
  // The shift to the image of the face that is nearest to the sample.
  Point<Dim> shift(const Point<Dim>& place, const Face& face) const {
    Point<Dim> shift = Point<Dim>::Zero();
    const Point<Dim> way = place - all_[face[0]];
    for (int d = 0; d < Dim; ++d)
      if (space_.periodic[d]) shift[d] = space_.length[d] * std::round(way[d] / space_.length[d]);
    return shift;
  }
  void add_if_near(SurfaceSample<Dim>& sample, const Face& face) const {
    if (share_a_marker<Dim>(sample.face, face)) return;
    const Point<Dim> place = sample.place(all_);
    PairPoints<Dim> places{place};
    const Point<Dim> to_image = shift(place, face);
    for (std::size_t i = 0; i < Dim; ++i) places[i + 1] = all_[face[i]] + to_image;
    const double start = gap_of<Dim>(PairKind::point_facet, places).distance;
    const double distance = distance_(sample.face[0], face[0]);
    if (start < distance + reach(sample.face) + reach(face)) sample.opposites.push_back({face, to_image, start});
  }

  const Facets<Dim>& facets_;
  const Points<Dim>& all_;
  const std::vector<double>& reaches_;
  const ContactDistance& distance_;
  double most_;
  PeriodicSpace<Dim> space_;
};

}  // namespace

template <int Dim>
std::vector<SurfaceSample<Dim>> find_samples(const NearMarkers<Dim>& known, const Facets<Dim>& facets,
                                             const Points<Dim>& all, const std::vector<double>& reaches,
                                             const ContactDistance& distance, double most,
                                             const PeriodicSpace<Dim>& space) {
  if (facets.faces.empty()) return {};
  std::vector<SurfaceSample<Dim>> samples = SampleSearch<Dim>(facets, all, reaches, distance, most, space).find();
  const auto is_own = [&](const auto& face) {
    return std::ranges::any_of(face, [&](std::size_t m) { return known.owns(m); });
  };
  std::erase_if(samples, [&](const SurfaceSample<Dim>& sample) {
    return !is_own(sample.face) &&
           std::ranges::none_of(sample.opposites, [&](const auto& opposite) { return is_own(opposite.face); });
  });
  return samples;
}

template std::vector<CountedFacing<2>> faced_by<2>(const SurfaceSample<2>&, const Points<2>&, const ContactDistance&);
template std::vector<CountedFacing<3>> faced_by<3>(const SurfaceSample<3>&, const Points<3>&, const ContactDistance&);
template std::vector<SurfaceSample<2>> find_samples<2>(const NearMarkers<2>&, const Facets<2>&, const Points<2>&,
                                                       const std::vector<double>&, const ContactDistance&, double,
                                                       const PeriodicSpace<2>&);
template std::vector<SurfaceSample<3>> find_samples<3>(const NearMarkers<3>&, const Facets<3>&, const Points<3>&,
                                                       const std::vector<double>&, const ContactDistance&, double,
                                                       const PeriodicSpace<3>&);

}  // namespace washfsi
