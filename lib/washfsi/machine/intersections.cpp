// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/machine/intersections.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr double flat = 1e-12;  // of the lengths' product: less is round-off

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

// Lower and upper ends of a thing along all axes.
template <int Dim>
struct Span {
  Point<Dim> lower, upper;
  std::size_t thing;
  bool is_image;
};

template <int Dim, std::size_t Count>
Span<Dim> span_of(const std::array<std::size_t, Count>& markers, const Points<Dim>& all, std::size_t thing) {
  Span<Dim> span{all[markers[0]], all[markers[0]], thing, false};
  for (const std::size_t m : markers) {
    span.lower = span.lower.cwiseMin(all[m]);
    span.upper = span.upper.cwiseMax(all[m]);
  }
  return span;
}

// In ascending order along an axis; where space repeats itself, folded, and those that reach beyond the end once more
// before its start.
template <int Dim, class Things>
std::vector<Span<Dim>> spans_along(int axis, const Things& things, const Points<Dim>& all, double length) {
  std::vector<Span<Dim>> spans;
  spans.reserve(things.size());
  const auto add_shifted = [&](Span<Dim> span, double shift) {
    span.lower[axis] -= shift;
    span.upper[axis] -= shift;
    spans.push_back(span);
  };
  for (std::size_t n = 0; n < things.size(); ++n) {
    Span<Dim> span = span_of<Dim>(things[n], all, n);
    const double fold = length > 0 ? length * std::floor(span.lower[axis] / length) : 0;
    add_shifted(span, fold);
    span.is_image = true;
    if (length > 0 && span.upper[axis] - fold >= length) add_shifted(span, fold + length);
  }
  std::sort(spans.begin(), spans.end(), [=](const auto& a, const auto& b) { return a.lower[axis] < b.lower[axis]; });
  return spans;
}

// Along an axis that repeats itself all may meet.
template <int Dim>
bool may_meet(const Span<Dim>& a, const Span<Dim>& b, const Point<Dim>& lengths, int sorted_along) {
  for (int d = 0; d < Dim; ++d)
    if ((lengths[d] == 0 || d == sorted_along) && (a.upper[d] < b.lower[d] || b.upper[d] < a.lower[d])) return false;
  return !(a.is_image && b.is_image);
}

// The axis along which the markers lie farthest apart.
template <int Dim>
int longest_axis(const Points<Dim>& all) {
  Point<Dim> lower = all[0], upper = all[0];
  for (const auto& place : all) {
    lower = lower.cwiseMin(place);
    upper = upper.cwiseMax(place);
  }
  int axis = 0;
  (upper - lower).maxCoeff(&axis);
  return axis;
}

}  // namespace

template <int Dim>
IntersectionCount<Dim>::IntersectionCount(const Cloths<Dim>& cloths, const Point<Dim>& lengths)
    : cloths_(cloths), lengths_(lengths) {
  for (std::size_t p = 0; p < cloths.pieces().size(); ++p) add_piece(p);
}

// Row by row of the lattice, each cell split along the diagonal from its first marker.
template <int Dim>
void IntersectionCount<Dim>::add_piece(std::size_t number) {
  const Piece& piece = cloths_.pieces()[number];
  const Sheet& sheet = cloths_.groups()[piece.group].sheet;
  const auto first = static_cast<std::size_t>(piece.first), width = sheet.width;
  const std::size_t rows = static_cast<std::size_t>(piece.count) / width;
  const auto marker = [&](std::size_t i, std::size_t j) { return first + (i % rows) * width + j; };
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < width; ++j) {
      const bool below = sheet.closed || i + 1 < rows, beside = j + 1 < width;
      if (below) edges_.push_back({marker(i, j), marker(i + 1, j)});
      if (beside) edges_.push_back({marker(i, j), marker(i, j + 1)});
      if (below && beside) edges_.push_back({marker(i, j), marker(i + 1, j + 1)});
      if constexpr (Dim == 3) {
        if (!below || !beside) continue;
        faces_.push_back({marker(i, j), marker(i + 1, j), marker(i + 1, j + 1)});
        faces_.push_back({marker(i, j), marker(i + 1, j + 1), marker(i, j + 1)});
      } else if (below) {
        faces_.push_back(edges_.back());
      }
    }
  piece_of_edge_.resize(edges_.size(), number);
  piece_of_face_.resize(faces_.size(), number);
}

template <int Dim>
void IntersectionCount<Dim>::count(const Points<Dim>& positions) {
  const Points<Dim> all = cloths_.of_all_ranks(positions);
  total_ = 0;
  example_.reset();
  if (all.empty() || faces_.empty()) return;
  const int axis = longest_axis<Dim>(all);
  const std::vector<Span<Dim>> edges = spans_along<Dim>(axis, edges_, all, lengths_[axis]),
                               faces = spans_along<Dim>(axis, faces_, all, lengths_[axis]);
  double longest = 0;
  for (const auto& face : faces) longest = std::max(longest, face.upper[axis] - face.lower[axis]);
  const auto rank = static_cast<std::size_t>(rank_of(cloths_.comm())),
             ranks = static_cast<std::size_t>(ranks_of(cloths_.comm()));
  for (const auto& edge : edges) {
    if (edge.thing % ranks != rank) continue;
    auto face = std::lower_bound(faces.begin(), faces.end(), edge.lower[axis] - longest,
                                 [&](const auto& span, double value) { return span.lower[axis] < value; });
    for (; face != faces.end() && face->lower[axis] <= edge.upper[axis]; ++face)
      if (may_meet(edge, *face, lengths_, axis)) test(edge.thing, face->thing, all);
  }
  total_ = ordered_sum(cloths_.comm(), total_);
  share_example();
}

// With the image of the face that is nearest to the edge. In the plane both are edges, of which each pair counts once.
template <int Dim>
void IntersectionCount<Dim>::test(std::size_t edge, std::size_t face, const Points<Dim>& all) {
  if (Dim == 2 && face <= edge) return;
  std::array<Point<Dim>, 2> e;
  std::array<Point<Dim>, Dim> f;
  for (std::size_t i = 0; i < e.size(); ++i) e[i] = all[edges_[edge][i]];
  const Point<Dim> shift = image_shift(all[faces_[face][0]], e[0]);
  for (std::size_t i = 0; i < f.size(); ++i) {
    f[i] = all[faces_[face][i]] + shift;
    if (faces_[face][i] == edges_[edge][0] || faces_[face][i] == edges_[edge][1]) return;
  }
  if (!cross(e, f)) return;
  total_ += 1;
  if (!example_) example_ = {piece_of_edge_[edge], piece_of_face_[face], 0.5 * (e[0] + e[1])};
}

template <int Dim>
Point<Dim> IntersectionCount<Dim>::image_shift(const Point<Dim>& from, const Point<Dim>& to) const {
  Point<Dim> shift = Point<Dim>::Zero();
  for (int d = 0; d < Dim; ++d)
    if (lengths_[d] > 0) shift[d] = lengths_[d] * std::round((to[d] - from[d]) / lengths_[d]);
  return shift;
}

// That of the first rank that has one.
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

// Numbered in its group, from 1.
template <int Dim>
std::string IntersectionCount<Dim>::name_of_piece(std::size_t piece) const {
  const std::size_t group = cloths_.pieces()[piece].group;
  std::size_t number = 1;
  for (std::size_t p = 0; p < piece; ++p) number += cloths_.pieces()[p].group == group ? 1 : 0;
  return cloths_.groups()[group].name + " " + std::to_string(number);
}

template <int Dim>
std::string IntersectionCount<Dim>::describe() const {
  const std::string first = name_of_piece(example_->first), second = name_of_piece(example_->second);
  const std::string who = first == second ? first + " goes through itself" : first + " goes through " + second;
  return who + " at (" + list_text<Dim>(example_->place) + ") m";
}

template class IntersectionCount<2>;
template class IntersectionCount<3>;

}  // namespace washfsi
