// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "washfsi/measure/cloth_mesh.hpp"

namespace washfsi {

/// A place where two cloths, or two parts of one, go through each other.
template <int Dim>
struct ClothIntersection {
  std::size_t first, second;  ///< pieces
  Point<Dim> place;           ///< [m]
};

/// Counts the intersections of cloths as they lie: edges that go through triangles, in the plane edges that go through
/// edges. It checks the contact forces independently, from the markers only. An intersection counts if it is deeper
/// than round-off: touching or coplanar parts do not.
template <int Dim>
class IntersectionCount {
 public:
  /// `lengths` are the periods of space [m]; 0 where it is not periodic. The cloths must outlive it.
  IntersectionCount(const Cloths<Dim>& cloths, const Point<Dim>& lengths);

  /// Counts for these places of this rank's markers. Each rank tests one slab of space. Collective.
  void count(const Points<Dim>& positions);
  double total() const { return total_; }
  /// One of them; the same on all ranks.
  const std::optional<ClothIntersection<Dim>>& example() const { return example_; }
  /// Describes the example: which cloths, and where.
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
  std::optional<ClothIntersection<Dim>> example_;
};

extern template class IntersectionCount<2>;
extern template class IntersectionCount<3>;

}  // namespace washfsi
