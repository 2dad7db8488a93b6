// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/intersections.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi {

namespace {

constexpr double flat = 1e-12;  // relative to the product of lengths: less is round-off

int sign_of(double volume, double scale) {
  return volume > flat * scale ? 1 : volume < -flat * scale ? -1 : 0;
}

int side(const Point<2>& a, const Point<2>& b, const Point<2>& c) {
  const Point<2> u = b - a, v = c - a;
  return sign_of(u[0] * v[1] - u[1] * v[0], u.norm() * v.norm());
}

int side(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& d) {
  const Point<3> u = b - a, v = c - a, w = d - a;
  return sign_of(u.dot(v.cross(w)), u.norm() * v.norm() * w.norm());
}

bool opposite(int a, int b) {
  return a * b < 0;
}

// Whether the ends of each lie on different sides of the other.
bool cross(const std::array<Point<2>, 2>& e, const std::array<Point<2>, 2>& f) {
  return opposite(side(f[0], f[1], e[0]), side(f[0], f[1], e[1])) &&
         opposite(side(e[0], e[1], f[0]), side(e[0], e[1], f[1]));
}

// Whether the ends of the edge lie on different sides of the triangle, and its line passes all sides alike.
bool cross(const std::array<Point<3>, 2>& e, const std::array<Point<3>, 3>& t) {
  if (!opposite(side(t[0], t[1], t[2], e[0]), side(t[0], t[1], t[2], e[1]))) return false;
  const int a = side(e[0], e[1], t[0], t[1]), b = side(e[0], e[1], t[1], t[2]), c = side(e[0], e[1], t[2], t[0]);
  return a != 0 && a == b && b == c;
}

/// An edge or a face at its present place, and its bounds along all axes: in periodic space folded along the axis by
/// which they are sorted, perhaps an image of it before the start of the period.
template <int Dim, std::size_t Count>
struct Thing {
  std::array<Point<Dim>, Count> corners;
  std::array<PetscInt, Count> markers;
  std::size_t piece;
  Point<Dim> lower, upper;
  bool is_image;
};

template <int Dim, std::size_t Count>
Thing<Dim, Count> thing(const std::array<std::size_t, Count>& corners, const Points<Dim>& places,
                        const std::vector<PetscInt>& numbers, std::size_t piece) {
  Thing<Dim, Count> thing{{}, {}, piece, places[corners[0]], places[corners[0]], false};
  for (std::size_t i = 0; i < Count; ++i) {
    thing.corners[i] = places[corners[i]];
    thing.markers[i] = numbers[corners[i]];
    thing.lower = thing.lower.cwiseMin(thing.corners[i]);
    thing.upper = thing.upper.cwiseMax(thing.corners[i]);
  }
  return thing;
}

/// The space in slabs of equal thickness, across the axis along which the markers lie farthest apart: one for each
/// rank.
template <int Dim>
class EqualSlabs {
 public:
  EqualSlabs(MPI_Comm comm, const Points<Dim>& positions, const Point<Dim>& lengths)
      : comm_(comm), ranks_(ranks_of(comm)), lower_(Point<Dim>::Constant(1e300)) {
    Point<Dim> upper = -lower_;
    for (const auto& place : positions) {
      lower_ = lower_.cwiseMin(place);
      upper = upper.cwiseMax(place);
    }
    MPI_Allreduce(MPI_IN_PLACE, lower_.data(), Dim, MPI_DOUBLE, MPI_MIN, comm);
    MPI_Allreduce(MPI_IN_PLACE, upper.data(), Dim, MPI_DOUBLE, MPI_MAX, comm);
    extent_ = (upper - lower_).maxCoeff(&axis_);
    length_ = lengths[axis_];
    if (length_ == 0) return;
    lower_[axis_] = 0;
    extent_ = length_;
  }
  int axis() const { return axis_; }

  int rank_at(double place) const {
    const double slab = extent_ > 0 ? std::floor(ranks_ * (place - lower_[axis_]) / extent_) : 0;
    return static_cast<int>(std::clamp(slab, 0.0, static_cast<double>(ranks_ - 1)));
  }

  /// Returns those edges or faces of all ranks that reach into this rank's slab, in ascending order along the axis.
  /// This rank contributes `count` of them, created by make(n) when needed. Collective.
  template <class Make>
  auto distributed(std::size_t count, const Make& make) const {
    std::vector<int> counts(static_cast<std::size_t>(ranks_), 0), next(counts.size(), 0);
    for (std::size_t n = 0; n < count; ++n)
      visit_slabs(make(n), [&](const auto&, std::size_t slab) { ++counts[slab]; });
    std::exclusive_scan(counts.begin(), counts.end(), next.begin(), 0);
    using Item = decltype(make(0));
    std::vector<Item> sent(static_cast<std::size_t>(next.back() + counts.back()));
    for (std::size_t n = 0; n < count; ++n)
      visit_slabs(make(n),
                  [&](const Item& item, std::size_t slab) { sent[static_cast<std::size_t>(next[slab]++)] = item; });
    std::vector<Item> here = sent_to_ranks(comm_, std::move(sent), counts);
    std::ranges::sort(here, {}, [this](const Item& item) { return item.lower[axis_]; });
    return here;
  }

 private:
  // Calls visit(item, slab) for all slabs into which an item reaches, folded, and as an image before the period's
  // start.
  template <class Item, class Visit>
  void visit_slabs(Item item, const Visit& visit) const {
    const auto visit_shifted = [&](double shift) {
      item.lower[axis_] -= shift;
      item.upper[axis_] -= shift;
      const int end = rank_at(item.upper[axis_]) + 1;
      for (int slab = rank_at(item.lower[axis_]); slab < end; ++slab) visit(item, static_cast<std::size_t>(slab));
    };
    visit_shifted(length_ > 0 ? length_ * std::floor(item.lower[axis_] / length_) : 0);
    item.is_image = true;
    if (length_ > 0 && item.upper[axis_] >= length_) visit_shifted(length_);
  }

  MPI_Comm comm_;
  int ranks_, axis_ = 0;
  Point<Dim> lower_;
  double extent_ = 0, length_ = 0;  ///< extent along the axis; length of its period, 0 without one
};

// Whether two may meet; along periodic axes, except the sorted one, all may.
template <class First, class Second, int Dim>
bool may_meet(const First& a, const Second& b, const Point<Dim>& lengths, int sorted_along) {
  for (int d = 0; d < Dim; ++d)
    if ((lengths[d] == 0 || d == sorted_along) && (a.upper[d] < b.lower[d] || b.upper[d] < a.lower[d])) return false;
  return !(a.is_image && b.is_image);
}

}  // namespace

template <int Dim>
IntersectionCount<Dim>::IntersectionCount(const Cloths<Dim>& cloths, const Point<Dim>& lengths)
    : cloths_(cloths), lengths_(lengths), mesh_(cloths) {}

template <int Dim>
void IntersectionCount<Dim>::count(const Points<Dim>& positions) {
  total_ = 0;
  example_.reset();
  if (cloths_.marker_count() == 0) return;
  const EqualSlabs<Dim> slabs(cloths_.comm(), positions, lengths_);
  const Points<Dim> places = cloths_.lattices().with_halo(positions);
  const auto edge = [&](std::size_t n) {
    return thing<Dim>(mesh_.edges[n], places, mesh_.numbers, mesh_.piece_of_edge[n]);
  };
  const auto face = [&](std::size_t n) {
    return thing<Dim>(mesh_.faces[n], places, mesh_.numbers, mesh_.piece_of_face[n]);
  };
  const auto edges = slabs.distributed(mesh_.edges.size(), edge);
  const auto faces = slabs.distributed(mesh_.faces.size(), face);
  count_among(slabs, edges, faces);
  total_ = ordered_sum(cloths_.comm(), total_);
  share_example();
}

// A pair that meets is counted in the slab where the later one begins.
template <int Dim>
template <class Slabs, class Edges, class Faces>
void IntersectionCount<Dim>::count_among(const Slabs& slabs, const Edges& edges, const Faces& faces) {
  const int axis = slabs.axis(), rank = rank_of(cloths_.comm());
  double longest = 0;
  for (const auto& face : faces) longest = std::max(longest, face.upper[axis] - face.lower[axis]);
  for (const auto& edge : edges) {
    auto face = std::ranges::lower_bound(faces, edge.lower[axis] - longest, {},
                                         [&](const auto& other) { return other.lower[axis]; });
    for (; face != faces.end() && face->lower[axis] <= edge.upper[axis]; ++face)
      if (may_meet(edge, *face, lengths_, axis) && slabs.rank_at(std::max(edge.lower[axis], face->lower[axis])) == rank)
        test(edge, *face);
  }
}

// Tests an edge with the nearest image of a face. In the plane both are edges, of which each pair counts once.
template <int Dim>
template <class Edge, class Face>
void IntersectionCount<Dim>::test(const Edge& edge, Face face) {
  if (Dim == 2 && face.markers[0] <= edge.markers[0]) return;
  const Point<Dim> shift = image_shift(face.corners[0], edge.corners[0]);
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    if (face.markers[i] == edge.markers[0] || face.markers[i] == edge.markers[1]) return;
    face.corners[i] += shift;
  }
  if (!cross(edge.corners, face.corners)) return;
  total_ += 1;
  if (!example_) example_ = {edge.piece, face.piece, 0.5 * (edge.corners[0] + edge.corners[1])};
}

template <int Dim>
Point<Dim> IntersectionCount<Dim>::image_shift(const Point<Dim>& from, const Point<Dim>& to) const {
  Point<Dim> shift = Point<Dim>::Zero();
  for (int d = 0; d < Dim; ++d)
    if (lengths_[d] > 0) shift[d] = lengths_[d] * std::round((to[d] - from[d]) / lengths_[d]);
  return shift;
}

// Shares the example of the first rank that has one.
template <int Dim>
void IntersectionCount<Dim>::share_example() {
  const MPI_Comm comm = cloths_.comm();
  const int mine = example_ ? rank_of(comm) : ranks_of(comm);
  int first = mine;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, comm);
  if (first == ranks_of(comm)) return;
  std::array<double, Dim + 2> numbers{};
  if (example_) {
    numbers[0] = static_cast<double>(example_->first);
    numbers[1] = static_cast<double>(example_->second);
    std::copy_n(example_->place.data(), Dim, numbers.begin() + 2);
  }
  MPI_Bcast(numbers.data(), Dim + 2, MPI_DOUBLE, first, comm);
  example_ = {static_cast<std::size_t>(numbers[0]), static_cast<std::size_t>(numbers[1]),
              Point<Dim>(numbers.data() + 2)};
}

template <int Dim>
std::string IntersectionCount<Dim>::describe() const {
  const std::string first = cloths_.name_of(example_->first), second = cloths_.name_of(example_->second);
  const std::string who = first == second ? first + " goes through itself" : first + " goes through " + second;
  return who + " at (" + list_text<Dim>(example_->place) + ") m";
}

template class IntersectionCount<2>;
template class IntersectionCount<3>;

}  // namespace washfsi
