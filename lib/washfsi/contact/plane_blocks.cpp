// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/plane_blocks.hpp"

namespace washfsi {

template <int Dim>
PlaneBlocks<Dim>::PlaneBlocks(std::size_t markers, const TangentPlanes<Dim>& planes)
    : faces_(planes.faces().list()),
      of_markers_(markers, Block::Zero()),
      of_faces_(planes.sees_faces() ? faces_.size() : 0) {
  for (auto& blocks : of_faces_) blocks.fill(Block::Zero());
}

template <int Dim>
void PlaneBlocks<Dim>::visit(const Cloths<Dim>& cloths, const AddMarkerBlock<Dim>& add) const {
  for (std::size_t m = 0; m < of_markers_.size(); ++m) add(cloths.number_of(m), cloths.number_of(m), of_markers_[m]);
  for (std::size_t f = 0; f < of_faces_.size(); ++f)
    for (std::size_t i = 0; i < Dim; ++i)
      for (std::size_t j = 0; j < Dim; ++j)
        if (faces_[f].own[i] != SeenFaces<Dim>::none)
          add(faces_[f].numbers[i], faces_[f].numbers[j], of_faces_[f][i * Dim + j]);
}

template class PlaneBlocks<2>;
template class PlaneBlocks<3>;

}  // namespace washfsi
