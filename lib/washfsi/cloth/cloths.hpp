// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/options.hpp"
#include "washfsi/support/contiguous_type.hpp"
#include "washfsi/support/petsc.hpp"
#include "washfsi/support/slab.hpp"

namespace washfsi {

/// One cloth: its group and its markers, contiguous in the numbering of all markers.
struct Piece {
  std::size_t group = 0;
  PetscInt first = 0, count = 0;
};

/// The MPI type of a Point<Dim>, for the exchange of marker data.
template <int Dim>
struct PointType : ContiguousType {
  PointType() : ContiguousType(Dim, MPI_DOUBLE) {}
};

/// The rows of a cloth that a rank sees: those of its own markers and `sheet_reach` more on either side. A closed cloth
/// is seen as an open one that goes round beyond its own end.
struct Patch {
  std::size_t piece;
  std::vector<PetscInt> markers;              ///< markers seen, by their numbers
  std::size_t first_in_halo;                  ///< index of the first in an array with halo
  std::size_t own_begin, own_end, own_first;  ///< range of this rank's among them, and index of the first in its arrays
};

/// All cloths of a run. Markers are numbered cloth by cloth; each rank has a contiguous range of them, whatever cloths
/// they belong to. Arrays of marker data cover this range. Independent of the grid.
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
  /// This rank's part of an array over all markers with `components` values each.
  Slab slab(int components) const {
    return row_slab(static_cast<std::size_t>(total_), static_cast<std::size_t>(begin_), static_cast<std::size_t>(end_),
                    components);
  }

  /// The name of a piece: its group's, and its number in that, from 1.
  std::string name_of(std::size_t piece) const;

  const ClothGroup<Dim>& group_of_piece(std::size_t piece) const { return groups_[pieces_[piece].group]; }

  /// Piece and group of each of this rank's markers, and its number among those of all ranks.
  const std::vector<std::size_t>& piece_of_marker() const { return piece_of_marker_; }
  std::size_t group_number(std::size_t marker) const { return pieces_[piece_of_marker_[marker]].group; }
  const ClothGroup<Dim>& group_of(std::size_t marker) const { return groups_[group_number(marker)]; }
  PetscInt number_of(std::size_t marker) const { return begin_ + static_cast<PetscInt>(marker); }
  /// The quads of a piece, each as its four markers in the order round it; a fibre has none.
  std::vector<std::array<PetscInt, 4>> quads(const Piece& piece) const;
  /// Undeformed area of each of this rank's markers [m2; m in the plane].
  const std::vector<double>& marker_areas() const { return marker_areas_; }
  /// Area of each marker over that of a marker inside its cloth: below 1 on the edges of a nodal lattice.
  const std::vector<double>& marker_shares() const { return marker_shares_; }
  /// Excess mass of each of this rank's markers [kg; per unit depth in the plane].
  const std::vector<double>& marker_masses() const { return marker_masses_; }

  /// The parts of the cloths that this rank sees, for forces between neighbours on a lattice.
  const std::vector<Patch>& patches() const { return patches_; }
  const ClothGroup<Dim>& group_of(const Patch& patch) const { return group_of_piece(patch.piece); }
  /// This rank's values and those of the other markers that it sees. Collective.
  Points<Dim> with_halo(const Points<Dim>& values) const;
  std::vector<double> with_halo(const std::vector<double>& values) const;
  /// The values of a patch's markers in an array with halo.
  std::span<const Point<Dim>> seen(const Points<Dim>& with_halo, const Patch& patch) const;
  /// Calls add(patch, sums of its markers, zero at first) for some patches and adds the sums of this rank's markers.
  template <class Add>
  void add_by_patch(const std::vector<Patch>& patches, Points<Dim>& sums, const Add& add) const {
    for (const Patch& patch : patches) {
      Points<Dim> of_patch(patch.markers.size(), Point<Dim>::Zero());
      add(patch, std::span<Point<Dim>>(of_patch));
      for (std::size_t i = patch.own_begin; i < patch.own_end; ++i)
        sums[patch.own_first + i - patch.own_begin] += of_patch[i];
    }
  }

  /// Unit normal of the cloth at each of this rank's markers. Collective.
  Points<Dim> normals(const Points<Dim>& positions) const;
  /// Stress and deformation at each of this rank's markers. Collective.
  std::vector<MarkerState> marker_states(const Points<Dim>& positions) const;
  /// Largest stretch |X_s| - 1 or |X_r| - 1 of any edge in each group. Collective.
  std::vector<double> largest_stretches(const Points<Dim>& positions) const;

 private:
  void find_patches();
  void find_markers();
  Patch patch_of(std::size_t number, PetscInt own_first, PetscInt own_end) const;
  void build_halo(const petsc::Layout& layout);
  template <class Values>
  Values halo_of(const Values& values, MPI_Datatype type) const;
  template <class Find>
  auto values_by_patch(const Find& find) const;

  MPI_Comm comm_;
  std::vector<ClothGroup<Dim>> groups_;
  std::vector<Piece> pieces_;
  std::vector<Patch> patches_;
  std::vector<std::size_t> piece_of_marker_;
  std::vector<double> marker_shares_, marker_areas_, marker_masses_;
  PetscInt total_ = 0, begin_ = 0, end_ = 0;
  std::size_t halo_count_ = 0;
  PointType<Dim> point_type_;
  petsc::StarForest halo_;
};

extern template class Cloths<2>;
extern template class Cloths<3>;

}  // namespace washfsi
