// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/mask/cut_faces.hpp"

#include <algorithm>

namespace washfsi {

template <int Dim>
std::vector<CutFace<Dim>> find_cut_faces(const Grid<Dim>& grid, const PosedBodies<Dim>& posed, Vec body_of_faces) {
  constexpr double shortest = 1e-3;
  const petsc::LocalVector local_body(grid.face_dm(), body_of_faces);
  const ConstFaceView<Dim> near_body(grid.face_dm(), local_body);
  const FaceView<Dim> holder(grid.face_dm(), body_of_faces);
  std::vector<CutFace<Dim>> cuts;
  const auto arm_towards = [&](const CutFace<Dim>& cut, PetscInt step) -> typename CutFace<Dim>::Arm {
    const Index<Dim> neighbour = shifted<Dim>(cut.face, cut.axis, step);
    if (near_body(neighbour, cut.component) < 0) return {};
    if (!grid.periodic(cut.axis) && grid.inside(neighbour) != neighbour) return {};  // beyond the box
    const auto body = static_cast<std::size_t>(near_body(neighbour, cut.component));
    const Point<Dim> from = grid.face_center(cut.face, cut.component);
    const Point<Dim> to = grid.face_center(neighbour, cut.component);
    const double here = posed.distance(body, from), there = posed.distance(body, to);
    const double length = std::max(shortest, here / (here - there));
    holder(cut.face, cut.component) = static_cast<double>(body);  // its constraint force loads the body
    return {true, length, posed[body].velocity(from + length * (to - from))[cut.component]};
  };
  grid.for_each_inner_face([&](const Index<Dim>& face, auto c) {
    if (near_body(face, c) >= 0) return;
    for (int axis = 0; axis < Dim; ++axis) {
      if (near_body(shifted<Dim>(face, axis, -1), c) < 0 && near_body(shifted<Dim>(face, axis, 1), c) < 0) continue;
      CutFace<Dim> cut{face, c, axis, {}, {}};
      cut.lower = arm_towards(cut, -1);
      cut.upper = arm_towards(cut, 1);
      if (cut.lower.cut || cut.upper.cut) cuts.push_back(cut);
    }
  });
  return cuts;
}

template std::vector<CutFace<2>> find_cut_faces<2>(const Grid<2>&, const PosedBodies<2>&, Vec);
template std::vector<CutFace<3>> find_cut_faces<3>(const Grid<3>&, const PosedBodies<3>&, Vec);

}  // namespace washfsi
