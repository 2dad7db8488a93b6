// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/tangent_planes.hpp"

namespace washfsi {

/// The stiffness of planes in the rows of this rank's markers: one block for each marker, and one for each two of a
/// seen face, whether they touch anything or not. So the pattern of blocks never changes.
template <int Dim>
class PlaneBlocks {
 public:
  using Block = StiffnessBlock<Dim>;

  /// Begins with zeros, for this many markers of this rank; the faces must outlive it.
  PlaneBlocks(std::size_t markers, const TangentPlanes<Dim>& planes);
  /// Adds the stiffness of the point of a plane [N/m], for each two of its markers by their shares.
  void add(const TangentPlane<Dim>& plane, const Block& block) {
    if (!plane.is_of_face()) {
      of_markers_[plane.markers[0]] += block;
    } else {
      for (std::size_t i = 0; i < Dim; ++i)
        for (std::size_t j = 0; j < Dim; ++j)
          of_faces_[plane.face][i * Dim + j] += plane.shares[i] * plane.shares[j] * block;
    }
  }
  /// Calls `add` for all blocks, always in the same order.
  void visit(const Cloths<Dim>& cloths, const AddMarkerBlock<Dim>& add) const;

 private:
  const std::vector<typename SeenFaces<Dim>::Face>& faces_;
  std::vector<Block> of_markers_;
  std::vector<std::array<Block, Dim * Dim>> of_faces_;
};

extern template class PlaneBlocks<2>;
extern template class PlaneBlocks<3>;

}  // namespace washfsi
