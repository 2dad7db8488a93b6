// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/options.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// One cloth: its group and its markers, contiguous in the numbering of all markers.
struct Piece {
  std::size_t group = 0;
  PetscInt first = 0, count = 0;
};

/// The MPI type of a Point<Dim>, for the exchange of marker data.
template <int Dim>
class PointType {
 public:
  PointType();
  ~PointType();
  PointType(const PointType&) = delete;
  PointType& operator=(const PointType&) = delete;
  operator MPI_Datatype() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

/// All cloths of a run and their elasticity. Markers are numbered cloth by cloth; each rank has a contiguous
/// range of them, whatever cloths they belong to. Arrays of marker data hold this range. Knows no grid.
template <int Dim>
class Cloths {
 public:
  Cloths(MPI_Comm comm, std::vector<ClothGroup<Dim>> groups);

  MPI_Comm comm() const { return comm_; }
  const std::vector<ClothGroup<Dim>>& groups() const { return groups_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  PetscInt marker_count() const { return total_; }
  PetscInt begin() const { return begin_; }  ///< first marker of this rank
  PetscInt end() const { return end_; }
  std::size_t owned() const { return static_cast<std::size_t>(end_ - begin_); }

  /// Piece and group of each of this rank's markers.
  const std::vector<std::size_t>& piece_of_marker() const { return piece_of_marker_; }
  const ClothGroup<Dim>& group_of(std::size_t marker) const { return groups_[pieces_[piece_of_marker_[marker]].group]; }
  /// The quads of a piece, each as its four markers in the order round it; a fibre has none.
  std::vector<std::array<PetscInt, 4>> quads(const Piece& piece) const;
  /// Values of all markers of all ranks, in marker order. Collective.
  Points<Dim> of_all_ranks(const Points<Dim>& values) const;
  /// Undeformed area that each of this rank's markers stands for [m2; m in the plane].
  const std::vector<double>& marker_areas() const { return marker_areas_; }
  /// Excess mass of each of this rank's markers [kg; per unit depth in the plane].
  const std::vector<double>& marker_masses() const { return marker_masses_; }

  /// Fixes the springs that hold cloths (-..._hold) at the places where the held markers are now.
  void hold_at(const Points<Dim>& positions);

  /// Force of elasticity and of the holding springs on each of this rank's markers [N; per unit depth in the plane].
  /// Collective.
  Points<Dim> elastic_forces(const Points<Dim>& positions) const;
  /// Minus the Jacobian of elastic_forces, of the energy form whatever the group's model, times a direction.
  /// Collective.
  Points<Dim> stiffness_product(const Points<Dim>& positions, const Points<Dim>& direction) const;
  /// 2-norm over all markers of the round-off that elastic_forces may have [N; per unit depth in the plane].
  /// Collective.
  double force_round_off(const Points<Dim>& positions) const;
  /// Kelvin-Voigt damping of the edges [N; per unit depth in the plane]. Collective.
  Points<Dim> damping_forces(const Points<Dim>& positions, const Points<Dim>& velocities) const;
  /// Constant loads: distributed and at the ends [N; per unit depth in the plane].
  const Points<Dim>& dead_loads() const { return dead_loads_; }
  bool any_damping() const;

  /// A matrix for `set_stiffness`: a row for each coordinate of each marker. Collective.
  petsc::Matrix stiffness_matrix() const;
  /// Sets the matrix to factor times the Jacobian of -elastic_forces, of the energy form whatever the group's model.
  /// Collective.
  void set_stiffness(const Points<Dim>& positions, GeometricStiffness geometric, double factor, Mat matrix) const;

  /// Unit normal of the cloth at each of this rank's markers. Collective.
  Points<Dim> normals(const Points<Dim>& positions) const;
  /// Stress and deformation at each of this rank's markers. Collective.
  std::vector<MarkerState> marker_states(const Points<Dim>& positions) const;
  /// Energy of elasticity and of the holding springs of each group [J; per unit depth in the plane]. Collective.
  std::vector<double> elastic_energies(const Points<Dim>& positions) const;
  /// Largest stretch |X_s| - 1 or |X_r| - 1 of any edge in each group. Collective.
  std::vector<double> largest_stretches(const Points<Dim>& positions) const;

 private:
  /// The rows of a piece that this rank sees: those of its own markers and `sheet_reach` more on either side. A closed
  /// piece is seen as an open one that goes round beyond its own end.
  struct Part {
    std::size_t piece;
    std::vector<PetscInt> markers;              ///< seen, by their numbers
    std::size_t first_in_halo;                  ///< where they begin in an array with halo
    std::size_t own_begin, own_end, own_first;  ///< this rank's among them, and the first of these in its arrays
  };
  /// A marker that a spring holds.
  struct Hold {
    std::size_t marker;  ///< in this rank's arrays
    double stiffness;    ///< [N/m; per unit depth in the plane]
    Point<Dim> anchor;   ///< [m]
  };
  void find_parts();
  void find_markers();
  Part part_of(std::size_t number, PetscInt own_first, PetscInt own_end) const;
  const ClothGroup<Dim>& group_of(const Part& part) const { return groups_[pieces_[part.piece].group]; }
  void build_halo(const petsc::Layout& layout);
  Points<Dim> with_halo(const Points<Dim>& values) const;
  std::span<const Point<Dim>> visible(const Points<Dim>& with_halo, const Part& part) const;
  template <class Find>
  auto values_of_parts(const Find& find) const;
  template <class Force>
  Points<Dim> forces_of_parts(const Force& add_forces) const;
  template <class Add>
  void visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric, const Add& add) const;

  MPI_Comm comm_;
  std::vector<ClothGroup<Dim>> groups_;
  std::vector<Piece> pieces_;
  std::vector<Part> parts_;
  std::vector<Hold> holds_;
  std::vector<std::size_t> piece_of_marker_;
  std::vector<double> marker_areas_, marker_masses_;
  Points<Dim> dead_loads_;
  PetscInt total_ = 0, begin_ = 0, end_ = 0;
  std::size_t halo_count_ = 0;
  PointType<Dim> point_type_;
  petsc::StarForest halo_;
};

extern template class Cloths<2>;
extern template class Cloths<3>;

}  // namespace washfsi
