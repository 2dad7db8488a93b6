// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/pair_search.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

template <int Dim>
struct PairSearch<Dim>::Query {
  const Points<Dim>& all;
  const std::vector<double>& reaches;
  double distance;

  /// Where a facet may be, with half of the distance round it.
  template <class Markers>
  Bounds<Dim> bounds(const Markers& markers) const {
    std::vector<Bounds<Dim>> boxes;
    for (const std::size_t m : markers)
      boxes.push_back(Bounds<Dim>::round(all[m], Point<Dim>::Constant(reaches[m] + 0.5 * distance)));
    return hull(boxes);
  }
  template <class Facet>
  std::vector<Bounds<Dim>> bounds_of_all(const std::vector<Facet>& facets) const {
    std::vector<Bounds<Dim>> boxes;
    boxes.reserve(facets.size());
    for (const Facet& facet : facets) boxes.push_back(bounds(facet));
    return boxes;
  }
};

namespace {

template <int Dim>
NearSearch<Dim> search_of(const std::vector<Bounds<Dim>>& boxes, const PeriodicSpace<Dim>& space) {
  Point<Dim> mean = Point<Dim>::Zero();
  for (const auto& box : boxes) mean += (box.upper - box.lower) / static_cast<double>(boxes.size());
  return NearSearch<Dim>(boxes, mean, hull(boxes), space);
}

template <class First, class Second>
bool share_a_marker(const First& first, const Second& second) {
  return std::any_of(first.begin(), first.end(),
                     [&](std::size_t m) { return std::find(second.begin(), second.end(), m) != second.end(); });
}

}  // namespace

template <int Dim>
std::vector<FacetPair<Dim>> PairSearch<Dim>::find(const Points<Dim>& all, const std::vector<double>& reaches,
                                                  double distance) const {
  std::vector<FacetPair<Dim>> found;
  const Query query{all, reaches, distance};
  if (!facets_.faces.empty()) find_points_and_faces(query, found);
  if constexpr (Dim == 3)
    if (!facets_.edges.empty()) find_edges(query, found);
  return found;
}

template <int Dim>
void PairSearch<Dim>::find_points_and_faces(const Query& query, std::vector<FacetPair<Dim>>& found) const {
  const NearSearch<Dim> search = search_of(query.bounds_of_all(facets_.faces), space_);
  for (std::size_t m = 0; m < query.all.size(); ++m) {
    const std::array<std::size_t, 1> point{m};
    for (const std::size_t f : search.near(query.bounds(point))) {
      const auto& face = facets_.faces[f];
      if (share_a_marker(point, face)) continue;
      FacetPair<Dim> pair{PairKind::point_facet, {}, Point<Dim>::Zero(), 0.5 * facets_.marker_areas[m], 0, 0};
      pair.markers[0] = m;
      std::copy(face.begin(), face.end(), pair.markers.begin() + 1);
      keep_if_near(query, pair, found);
    }
  }
}

template <int Dim>
void PairSearch<Dim>::find_edges(const Query& query, std::vector<FacetPair<Dim>>& found) const {
  if constexpr (Dim == 3) {
    constexpr double nearly_parallel = 1e-2;
    const std::vector<Bounds<3>> boxes = query.bounds_of_all(facets_.edges);
    const NearSearch<3> search = search_of(boxes, space_);
    const auto area = [&](const auto& e) { return (facets_.marker_areas[e[0]] + facets_.marker_areas[e[1]]) / 6; };
    for (std::size_t a = 0; a < boxes.size(); ++a)
      for (const std::size_t b : search.near(boxes[a], a + 1)) {
        const auto &first = facets_.edges[a], &second = facets_.edges[b];
        if (share_a_marker(first, second)) continue;
        const double lengths = facets_.edge_lengths[a] * facets_.edge_lengths[b];
        keep_if_near(query,
                     {PairKind::edge_edge,
                      {first[0], first[1], second[0], second[1]},
                      Point<3>::Zero(),
                      0.5 * (area(first) + area(second)),
                      nearly_parallel * lengths * lengths,
                      0},
                     found);
      }
  }
}

template <int Dim>
void PairSearch<Dim>::keep_if_near(const Query& query, FacetPair<Dim> pair, std::vector<FacetPair<Dim>>& found) const {
  const auto is_own = [&](std::size_t m) { return m >= begin_ && m < end_; };
  if (std::none_of(pair.markers.begin(), pair.markers.end(), is_own)) return;
  pair.shift = shift_of(pair, query.all);
  double first = 0, second = 0;
  for (std::size_t i = 0; i < pair.markers.size(); ++i) {
    double& reach = i < markers_of_first(pair.kind) ? first : second;
    reach = std::max(reach, query.reaches[pair.markers[i]]);
  }
  pair.start = gap_of<Dim>(pair.kind, pair.at(query.all)).distance;
  if (pair.start < query.distance + first + second) found.push_back(pair);
}

// To the image of the second facet that is nearest to the first.
template <int Dim>
Point<Dim> PairSearch<Dim>::shift_of(const FacetPair<Dim>& pair, const Points<Dim>& all) const {
  Point<Dim> shift = Point<Dim>::Zero();
  const Point<Dim> way = all[pair.markers.front()] - all[pair.markers.back()];
  for (int d = 0; d < Dim; ++d)
    if (space_.periodic[d]) shift[d] = space_.length[d] * std::round(way[d] / space_.length[d]);
  return shift;
}

template class PairSearch<2>;
template class PairSearch<3>;

}  // namespace washfsi
