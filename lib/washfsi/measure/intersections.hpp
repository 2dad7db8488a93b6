// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "washfsi/measure/cloth_mesh.hpp"

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

  /// Takes the places of this rank's markers. Each rank tests what lies in one slab of space. Collective.
  void count(const Points<Dim>& positions);
  double total() const { return total_; }
  /// One of them; the same on all ranks.
  const std::optional<Intersection<Dim>>& example() const { return example_; }
  /// Which cloths the example is of, and where, in words.
  std::string describe() const;

 private:
  template <class Slabs, class Edges, class Faces>
  void count_among(const Slabs& slabs, const Edges& edges, const Faces& faces);
  template <class Edge, class Face>
  void test(const Edge& edge, Face face);
  Point<Dim> image_shift(const Point<Dim>& from, const Point<Dim>& to) const;
  void share_example();

  const Cloths<Dim>& cloths_;
  Point<Dim> lengths_;
  ClothMesh<Dim> mesh_;
  double total_ = 0;
  std::optional<Intersection<Dim>> example_;
};

extern template class IntersectionCount<2>;
extern template class IntersectionCount<3>;

}  // namespace washfsi
