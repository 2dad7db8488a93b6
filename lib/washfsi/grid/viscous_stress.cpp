// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/viscous_stress.hpp"

namespace washfsi {

template <int Dim>
ViscosityField<Dim>::ViscosityField(const Grid<Dim>& grid) : grid_(grid) {
  WASH_PETSC(DMCreateLocalVector(grid.cell_dm(), cells_.put()));
  WASH_PETSC(DMCreateLocalVector(grid.face_dm(), edges_.put()));
}

template <int Dim>
void ViscosityField<Dim>::find_edges() {
  const ConstCellView<Dim> mu(grid_.cell_dm(), cells_);
  const FaceView<Dim> on_edge(grid_.face_dm(), edges_);
  Box<Dim> lower_edges = grid_.owned();  // of these cells: all edges round this rank's
  for (PetscInt& end : lower_edges.upper) ++end;
  for_each_component<Dim>([&](auto c) {
    for_each_component<Dim>([&](auto d) {
      if constexpr (d < c)
        for_each<Dim>(lower_edges, [&](const Index<Dim>& edge) {
          const Index<Dim> below = shifted<Dim>(edge, d, -1);
          on_edge(edge, edge_axis<Dim>(c, d)) =
              0.25 * (mu(edge) + mu(shifted<Dim>(edge, c, -1)) + mu(below) + mu(shifted<Dim>(below, c, -1)));
        });
    });
  });
}

template class ViscosityField<2>;
template class ViscosityField<3>;

}  // namespace washfsi
