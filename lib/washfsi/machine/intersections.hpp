// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// Where two cloths, or two parts of one, go through each other.
template <int Dim>
struct Intersection {
  std::size_t first, second;  ///< pieces
  Point<Dim> place;           ///< [m]
};

/// Counts the intersections of cloths as they lie: edges that go through triangles, in the plane edges that go through
/// edges. It is there to check what keeps cloths apart, and shares nothing with that but the markers. An intersection
/// is one if it is deeper than round-off: what only touches, or lies in one plane, is none.
template <int Dim>
class IntersectionCount {
 public:
  /// `lengths`: periods of space [m]; 0 where it does not repeat itself. The cloths must outlive it.
  IntersectionCount(const Cloths<Dim>& cloths, const Point<Dim>& lengths);

  /// Takes the places of this rank's markers. Each rank tests a share of the edges. Collective.
  void count(const Points<Dim>& positions);
  double total() const { return total_; }
  /// One of them; the same on all ranks.
  const std::optional<Intersection<Dim>>& example() const { return example_; }
  /// Which cloths the example is of, and where, in words.
  std::string describe() const;

 private:
  using Edge = std::array<std::size_t, 2>;
  using Face = std::array<std::size_t, Dim>;
  void add_piece(std::size_t number);
  std::string name_of_piece(std::size_t piece) const;
  void test(std::size_t edge, std::size_t face, const Points<Dim>& all);
  Point<Dim> image_shift(const Point<Dim>& from, const Point<Dim>& to) const;
  void share_example();

  const Cloths<Dim>& cloths_;
  Point<Dim> lengths_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<std::size_t> piece_of_edge_, piece_of_face_;
  double total_ = 0;
  std::optional<Intersection<Dim>> example_;
};

extern template class IntersectionCount<2>;
extern template class IntersectionCount<3>;

}  // namespace washfsi
