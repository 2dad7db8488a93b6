// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/side_covers.hpp"

#include "washfsi/grid/side_faces.hpp"

namespace washfsi {

template <int Dim>
void SideCovers<Dim>::set(double time, const typename SideCover<Dim>::Cover& cover) {
  if (covers_.empty())
    for (int axis = 0; axis < Dim; ++axis)
      for (const End end : both_ends) {
        const Side<Dim>& side = side_of<Dim>(sides_, axis, end);
        if (touches(grid_, axis, end) && side.kind == BoundaryKind::wall && !side.motion)
          covers_.emplace_back(grid_, axis, end, side.velocity);
      }
  for (auto& covered : covers_) covered.set(time, cover);
}

template <int Dim>
const SideCover<Dim>* SideCovers<Dim>::of(int axis, End end) const {
  for (const auto& cover : covers_)
    if (cover.axis() == axis && cover.end() == end && cover.covers()) return &cover;
  return nullptr;
}

template <int Dim>
double SideCovers<Dim>::share(int axis, End end, const Index<Dim>& face, int component, double time) const {
  const auto* cover = of(axis, end);
  return cover ? cover->shares(component, time)(face) : 0;
}

template <int Dim>
bool SideCovers<Dim>::cover_wholly(int axis, End end) const {
  const auto* cover = of(axis, end);
  return !touches(grid_, axis, end) || (cover && cover->covers_all());
}

template class SideCovers<2>;
template class SideCovers<3>;

}  // namespace washfsi
