// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// The edges and the faces of all cloths: each cell of a lattice is two triangles, split along the diagonal from its
/// first marker; in the plane faces are the edges. A rank has those that begin at its markers. Corners are indices in
/// an array with halo (`SeenLattices::with_halo`).
template <int Dim>
struct ClothMesh {
  explicit ClothMesh(const Cloths<Dim>& cloths);

  std::vector<PetscInt> numbers;  ///< numbers of the markers that this rank sees
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::array<std::size_t, Dim>> faces;
  std::vector<std::size_t> piece_of_edge, piece_of_face;

 private:
  void add_part(const Cloths<Dim>& cloths, const LatticePart& part);
};

extern template struct ClothMesh<2>;
extern template struct ClothMesh<3>;

}  // namespace washfsi
