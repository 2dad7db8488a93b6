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
  Cloths(MPI_Comm comm, std::vector<ClothGroup> groups);

  const std::vector<ClothGroup>& groups() const { return groups_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  PetscInt marker_count() const { return total_; }
  PetscInt begin() const { return begin_; }  ///< first marker of this rank
  PetscInt end() const { return end_; }
  std::size_t owned() const { return static_cast<std::size_t>(end_ - begin_); }

  /// Piece and group of each of this rank's markers.
  std::vector<std::size_t> piece_of_marker() const;
  /// Undeformed length that each of this rank's markers stands for [m].
  std::vector<double> marker_lengths() const;
  /// Excess mass of each of this rank's markers [kg; per unit depth in the plane].
  std::vector<double> marker_masses() const;

  /// Elastic and damping force on each of this rank's markers [N; per unit depth in the plane]. Collective.
  Points<Dim> elastic_forces(const Points<Dim>& positions, const Points<Dim>& velocities) const;
  /// Stress at each of this rank's markers [Pa]. Collective.
  std::vector<double> stresses(const Points<Dim>& positions) const;
  /// Elastic energy of each group [J; per unit depth in the plane]. Collective.
  std::vector<double> elastic_energies(const Points<Dim>& positions) const;
  /// Largest stretch |X_s| - 1 of any edge in each group. Collective.
  std::vector<double> largest_stretches(const Points<Dim>& positions) const;

 private:
  /// The part of a piece that this rank sees: its own markers and `fibre_reach` neighbours.
  struct Part {
    const Piece* piece;
    const ClothGroup* group;
    PetscInt first, last;  ///< visible markers
    PetscInt own_first, own_last;
  };
  void build_halo();
  Points<Dim> with_halo(const Points<Dim>& values) const;
  std::span<const Point<Dim>> visible(const Points<Dim>& with_halo, const Part& part) const;

  MPI_Comm comm_;
  std::vector<ClothGroup> groups_;
  std::vector<Piece> pieces_;
  std::vector<Part> parts_;
  PetscInt total_ = 0, begin_ = 0, end_ = 0;
  PetscInt halo_begin_ = 0, halo_end_ = 0;
  PointType<Dim> point_type_;
  petsc::StarForest halo_;
};

extern template class Cloths<2>;
extern template class Cloths<3>;

}  // namespace washfsi
