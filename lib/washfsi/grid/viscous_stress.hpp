// SPDX-License-Identifier: BSD-3-Clause
//
// The viscous stress of water whose viscosity may vary,
//   tau = mu (grad u + grad u^T),      tau_cc in cells, tau_cd on the edges where faces of the directions c and d meet,
// and its force div tau on faces. The operator is symmetric and never positive: the discrete adjoint of the strain
// rate. For uniform viscosity the force is mu lap u, which equals div tau where div u = 0.
#pragma once

#include "washfsi/grid/boundary.hpp"
#include "washfsi/grid/strain_rate.hpp"

namespace washfsi {

/// Dynamic viscosity [Pa s]: one number, or the vectors of a `ViscosityField`, which replace it.
struct Viscosity {
  double everywhere = 0;
  Vec in_cells = nullptr;  ///< viscosity in cells: local, of cell_dm, its ghosts filled
  Vec on_edges = nullptr;  ///< on edges: local, of face_dm; component `edge_axis(c, d)` for edge (index, c, d)
};

/// The component in which edge (index, c, d) is stored: in space the axis along which it lies, in the plane the first.
template <int Dim>
constexpr int edge_axis(int c, int d) noexcept {
  return Dim == 2 ? 0 : 3 - c - d;
}

/// A viscosity that varies: given in cells, and on edges the mean of the four cells round them.
template <int Dim>
class ViscosityField {
 public:
  explicit ViscosityField(const Grid<Dim>& grid);

  Vec in_cells() const { return cells_; }  ///< local, of cell_dm; to be filled with its ghosts [Pa s]
  /// Computes the viscosity on the edges round this rank's cells from the cells.
  void find_edges();
  Viscosity viscosity() const { return {0, cells_, edges_}; }

 private:
  const Grid<Dim>& grid_;
  petsc::Vector cells_, edges_;
};

extern template class ViscosityField<2>;
extern template class ViscosityField<3>;

/// A uniform viscosity. Results of its members are to be multiplied with `scale`.
template <int Dim>
class UniformViscosity {
 public:
  UniformViscosity(const Grid<Dim>& grid, double everywhere) : scale(everywhere), h_(grid.spacing()) {}

  const double scale;  ///< [Pa s]
  double in_cell(const Index<Dim>&) const { return 1; }
  double on_edge(const Index<Dim>&, int, int) const { return 1; }
  double on_face(const Index<Dim>&, int) const { return 1; }
  double on_side(const Index<Dim>&, int, int, int) const { return 1; }

  /// div tau on a c-face.
  template <class Velocity>
  [[gnu::always_inline]] inline double force(const Velocity& u, const Index<Dim>& face, int c) const {
    return laplacian<Dim>(u, face, c, h_);
  }
  /// Contribution of a face's neighbours along d to its diagonal, times h_d^2; `below` and `above` are factors for
  /// neighbours beyond a side.
  double diagonal_part(const Index<Dim>&, int, int, double below, double above) const { return below + above; }

 private:
  Spacing<Dim> h_;
};

/// A viscosity given in cells and on edges [Pa s].
template <int Dim>
class CellViscosity {
 public:
  CellViscosity(const Grid<Dim>& grid, const Viscosity& viscosity)
      : mu_(grid.cell_dm(), viscosity.in_cells), edges_(grid.face_dm(), viscosity.on_edges), h_(grid.spacing()) {}

  static constexpr double scale = 1;
  [[gnu::always_inline]] inline double in_cell(const Index<Dim>& cell) const { return mu_(cell); }
  /// Edge (index, c, d): where the lower c-face and the lower d-face of a cell meet.
  [[gnu::always_inline]] inline double on_edge(const Index<Dim>& edge, int c, int d) const {
    return edges_(edge, edge_axis<Dim>(c, d));
  }
  double on_face(const Index<Dim>& face, int c) const { return 0.5 * (mu_(face) + mu_(shifted<Dim>(face, c, -1))); }
  /// The viscosity half a cell from a c-face along an axis, upwards or downwards: on a side of the box beside it.
  double on_side(const Index<Dim>& face, int c, int axis, int upwards) const {
    if (c == axis) return in_cell(face);
    return on_edge(upwards > 0 ? shifted<Dim>(face, axis, 1) : face, c, axis);
  }

  template <class Velocity>
  [[gnu::always_inline]] inline double force(const Velocity& u, const Index<Dim>& face, int c) const {
    const Index<Dim> before = shifted<Dim>(face, c, -1), after = shifted<Dim>(face, c, 1);
    double sum =
        2 * h_.inverse_square[c] * (mu_(face) * (u(after, c) - u(face, c)) - mu_(before) * (u(face, c) - u(before, c)));
#pragma GCC unroll 3
    for (int d = 0; d < Dim; ++d)
      if (d != c) sum += h_.inverse[d] * (shear(u, shifted<Dim>(face, d, 1), c, d) - shear(u, face, c, d));
    return sum;
  }
  [[gnu::always_inline]] inline double diagonal_part(const Index<Dim>& face, int c, int d, double below,
                                                     double above) const {
    if (d == c) return 2 * (mu_(shifted<Dim>(face, c, -1)) + mu_(face));
    return below * on_edge(face, c, d) + above * on_edge(shifted<Dim>(face, d, 1), c, d);
  }

 private:
  /// tau_cd on an edge.
  template <class Velocity>
  [[gnu::always_inline]] inline double shear(const Velocity& u, const Index<Dim>& edge, int c, int d) const {
    return on_edge(edge, c, d) * shear_rate<Dim>(u, edge, c, d, h_);
  }

  ConstCellView<Dim> mu_;
  ConstFaceView<Dim> edges_;
  Spacing<Dim> h_;
};

/// Calls use(viscosity) with the form that fits, so that its loops are compiled for either.
template <int Dim, class Use>
void with_viscosity(const Grid<Dim>& grid, const Viscosity& viscosity, Use&& use) {
  if (viscosity.in_cells)
    use(CellViscosity<Dim>(grid, viscosity));
  else
    use(UniformViscosity<Dim>(grid, viscosity.everywhere));
}

/// Minus the diagonal of the force on a c-face over `scale`, with the reflections at walls and slip sides folded in.
template <int Dim, class Form>
[[gnu::always_inline]] inline double viscous_diagonal(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                                      const Form& viscosity, const Spacing<Dim>& h,
                                                      const Index<Dim>& face, int c) {
  double sum = 0;
#pragma GCC unroll 3
  for (int d = 0; d < Dim; ++d) {
    double below = 1, above = 1;  // beyond a wall 2, beyond a slip side 0
    if (d != c && face[d] == 0 && !grid.periodic(d)) below -= boundary.mirror_sign(d, End::lower, c);
    if (d != c && face[d] == grid.cells()[d] - 1 && !grid.periodic(d)) above -= boundary.mirror_sign(d, End::upper, c);
    sum += viscosity.diagonal_part(face, c, d, below, above) * h.inverse_square[d];
  }
  return sum;
}

}  // namespace washfsi
