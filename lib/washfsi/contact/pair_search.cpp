// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace washfsi {

template <int Dim>
struct PairSearch<Dim>::Query {
  const Points<Dim>& all;
  const std::vector<double>& reaches;
  double most;
  const ContactDistance& distance;

  /// The bounds of where a facet may be, with half of the distance round it.
  template <class Markers>
  Bounds<Dim> bounds(const Markers& markers) const {
    std::vector<Bounds<Dim>> boxes;
    for (const std::size_t m : markers)
      boxes.push_back(Bounds<Dim>::round(all[m], Point<Dim>::Constant(reaches[m] + 0.5 * most)));
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
std::vector<Bounds<Dim>> chosen(const std::vector<Bounds<Dim>>& boxes, const std::vector<std::size_t>& numbers) {
  std::vector<Bounds<Dim>> result;
  for (const std::size_t n : numbers) result.push_back(boxes[n]);
  return result;
}

template <int Dim>
bool overlap(const Bounds<Dim>& a, const Bounds<Dim>& b) {
  return (a.lower.array() <= b.upper.array()).all() && (b.lower.array() <= a.upper.array()).all();
}

/// The facets among some that a rank has to visit, and the search among them; only those that may be near to `asked`.
template <int Dim>
class Search {
 public:
  Search(const std::vector<Bounds<Dim>>& boxes, std::vector<std::size_t> numbers, const Bounds<Dim>& asked,
         const PeriodicSpace<Dim>& space)
      : numbers_(std::move(numbers)), search_(chosen<Dim>(boxes, numbers_), mean_size(boxes), asked, space) {}

  /// Calls visit(number) in ascending order, for numbers from one on.
  template <class Visit>
  void visit_near(const Bounds<Dim>& bounds, std::size_t from, const Visit& visit) const {
    const auto first = std::lower_bound(numbers_.begin(), numbers_.end(), from) - numbers_.begin();
    for (const std::size_t n : search_.near(bounds, static_cast<std::size_t>(first))) visit(numbers_[n]);
  }

 private:
  static Point<Dim> mean_size(const std::vector<Bounds<Dim>>& boxes) {
    Point<Dim> mean = Point<Dim>::Zero();
    for (const auto& box : boxes) mean += (box.upper - box.lower) / static_cast<double>(boxes.size());
    return mean;
  }

  std::vector<std::size_t> numbers_;
  NearSearch<Dim> search_;
};

/// Searches among all known facets for those of this rank, and among this rank's for others.
template <int Dim>
class Searches {
 public:
  Searches(const std::vector<Bounds<Dim>>& boxes, const std::vector<std::size_t>& own,
           const std::vector<Bounds<Dim>>& asked, const std::vector<std::size_t>& own_asked,
           const PeriodicSpace<Dim>& space)
      : own_hull_(hull(chosen<Dim>(boxes, own))),
        is_periodic_(std::any_of(space.periodic.begin(), space.periodic.end(), [](bool is) { return is; })),
        among_all_(boxes, all_of(boxes), hull(chosen<Dim>(asked, own_asked)), space),
        among_own_(boxes, own, own_hull_, space) {}

  /// Calls visit(number) in ascending order, for numbers from one on.
  template <class Visit>
  void visit_near(bool is_own, const Bounds<Dim>& bounds, std::size_t from, const Visit& visit) const {
    if (is_own) return among_all_.visit_near(bounds, from, visit);
    if (is_periodic_ || overlap<Dim>(bounds, own_hull_)) among_own_.visit_near(bounds, from, visit);
  }

 private:
  static std::vector<std::size_t> all_of(const std::vector<Bounds<Dim>>& boxes) {
    std::vector<std::size_t> numbers(boxes.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return numbers;
  }

  Bounds<Dim> own_hull_;
  bool is_periodic_;
  Search<Dim> among_all_, among_own_;
};

template <class First, class Second>
bool share_a_marker(const First& first, const Second& second) {
  return std::any_of(first.begin(), first.end(),
                     [&](std::size_t m) { return std::find(second.begin(), second.end(), m) != second.end(); });
}

}  // namespace

template <int Dim>
void PairSearch<Dim>::find_near(const Points<Dim>& positions, const std::vector<double>& reaches, double distance,
                                Before before) {
  if (known_.choose(positions, reaches, distance, before)) facets_ = Facets<Dim>(cloths_, known_);
  all_ = known_.values(positions);
  reaches_ = known_.values(reaches);
}

template <int Dim>
std::vector<FacetPair<Dim>> PairSearch<Dim>::pairs(const ContactDistance& distance, double most) const {
  std::vector<FacetPair<Dim>> found;
  const Query query{all_, reaches_, most, distance};
  if (!facets_.faces.empty()) find_points_and_faces(query, found);
  if constexpr (Dim == 3)
    if (!facets_.edges.empty()) find_edges(query, found);
  return found;
}

template <int Dim>
template <class Facet>
std::vector<std::size_t> PairSearch<Dim>::own(const std::vector<Facet>& facets) const {
  std::vector<std::size_t> numbers;
  for (std::size_t n = 0; n < facets.size(); ++n)
    if (is_own(facets[n])) numbers.push_back(n);
  return numbers;
}

// Pairs this rank's points with all faces, others only with this rank's.
template <int Dim>
void PairSearch<Dim>::find_points_and_faces(const Query& query, std::vector<FacetPair<Dim>>& found) const {
  std::vector<std::array<std::size_t, 1>> points;
  for (std::size_t m = 0; m < query.all.size(); ++m) points.push_back({m});
  const std::vector<Bounds<Dim>> places = query.bounds_of_all(points), boxes = query.bounds_of_all(facets_.faces);
  const Searches<Dim> searches(boxes, own(facets_.faces), places, own(points), space_);
  for (std::size_t m = 0; m < points.size(); ++m)
    searches.visit_near(is_own(points[m]), places[m], 0, [&](std::size_t f) {
      const auto& face = facets_.faces[f];
      if (share_a_marker(points[m], face)) return;
      FacetPair<Dim> pair{PairKind::point_facet, {}, Point<Dim>::Zero(), 0.5 * facets_.marker_areas[m], 0, 0};
      pair.markers[0] = m;
      std::copy(face.begin(), face.end(), pair.markers.begin() + 1);
      keep_if_near(query, pair, found);
    });
}

template <int Dim>
void PairSearch<Dim>::find_edges(const Query& query, std::vector<FacetPair<Dim>>& found) const {
  if constexpr (Dim == 3) {
    constexpr double nearly_parallel = 1e-2;
    const std::vector<Bounds<3>> boxes = query.bounds_of_all(facets_.edges);
    const std::vector<std::size_t> own_edges = own(facets_.edges);
    const Searches<3> searches(boxes, own_edges, boxes, own_edges, space_);
    const auto area = [&](const auto& e) { return (facets_.marker_areas[e[0]] + facets_.marker_areas[e[1]]) / 6; };
    for (std::size_t a = 0; a < boxes.size(); ++a)
      searches.visit_near(is_own(facets_.edges[a]), boxes[a], a + 1, [&](std::size_t b) {
        const auto &first = facets_.edges[a], &second = facets_.edges[b];
        if (share_a_marker(first, second)) return;
        const double lengths = facets_.edge_lengths[a] * facets_.edge_lengths[b];
        keep_if_near(query,
                     {PairKind::edge_edge,
                      {first[0], first[1], second[0], second[1]},
                      Point<3>::Zero(),
                      0.5 * (area(first) + area(second)),
                      nearly_parallel * lengths * lengths,
                      0},
                     found);
      });
  }
}

template <int Dim>
void PairSearch<Dim>::keep_if_near(const Query& query, FacetPair<Dim> pair, std::vector<FacetPair<Dim>>& found) const {
  pair.shift = shift_of(pair, query.all);
  double first = 0, second = 0;
  for (std::size_t i = 0; i < pair.markers.size(); ++i) {
    double& reach = i < markers_of_first(pair.kind) ? first : second;
    reach = std::max(reach, query.reaches[pair.markers[i]]);
  }
  pair.start = gap_of<Dim>(pair.kind, pair.at(query.all)).distance;
  const double distance = query.distance(pair.markers.front(), pair.markers.back());
  if (pair.start < distance + first + second) found.push_back(pair);
}

// The shift to the image of the second facet that is nearest to the first.
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
