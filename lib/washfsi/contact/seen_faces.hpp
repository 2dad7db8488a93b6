// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// The faces that have a marker of this rank: triangles, each cell of a lattice split into two, or segments in the
/// plane.
template <int Dim>
class SeenFaces {
 public:
  static constexpr std::ptrdiff_t none = -1;

  struct Face {
    std::array<std::size_t, Dim> seen;    ///< indices of its markers in an array with halo
    std::array<std::ptrdiff_t, Dim> own;  ///< their indices in this rank's arrays, or `none`
    std::array<PetscInt, Dim> numbers;    ///< their numbers among those of all ranks
    std::size_t piece;
    double area;  ///< undeformed area [m2; m in the plane]

    /// Whether this rank counts it, in sums over all ranks.
    bool counts() const { return own[0] != none; }
  };

  explicit SeenFaces(const Cloths<Dim>& cloths);
  const std::vector<Face>& list() const { return faces_; }

 private:
  void add_part(const Cloths<Dim>& cloths, const LatticePart& part);
  void add(const LatticePart& part, const std::array<std::size_t, Dim>& places, double area);

  std::vector<Face> faces_;
};

extern template class SeenFaces<2>;
extern template class SeenFaces<3>;

}  // namespace washfsi
