// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/cloths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
Cloths<Dim>::Cloths(MPI_Comm comm, std::vector<ClothGroup<Dim>> groups) : comm_(comm), groups_(std::move(groups)) {
  for (std::size_t g = 0; g < groups_.size(); ++g)
    for (PetscInt c = 0; c < groups_[g].count; ++c) {
      pieces_.push_back({g, total_, groups_[g].marker_count()});
      total_ += groups_[g].marker_count();
    }
  petsc::Layout layout;
  WASH_PETSC(PetscLayoutCreateFromSizes(comm_, PETSC_DECIDE, total_, 1, layout.put()));
  WASH_PETSC(PetscLayoutGetRange(layout, &begin_, &end_));
  find_patches();
  find_markers();
  build_halo(layout);
}

template <int Dim>
void Cloths<Dim>::find_patches() {
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const Piece& piece = pieces_[p];
    const PetscInt own_first = std::max(piece.first, begin_), own_end = std::min(piece.first + piece.count, end_);
    if (own_first >= own_end) continue;
    patches_.push_back(patch_of(p, own_first, own_end));
    halo_count_ += patches_.back().markers.size();
  }
}

template <int Dim>
Patch Cloths<Dim>::patch_of(std::size_t number, PetscInt own_first, PetscInt own_end) const {
  const Piece& piece = pieces_[number];
  const Sheet& sheet = groups_[piece.group].sheet;
  const auto width = static_cast<PetscInt>(sheet.width);
  const PetscInt first_row = (own_first - piece.first) / width - sheet_reach;
  const PetscInt end_row = (own_end - piece.first + width - 1) / width + sheet_reach, rows = piece.count / width;
  Patch patch{number, {}, halo_count_, 0, 0, static_cast<std::size_t>(own_first - begin_)};
  for (PetscInt row = first_row; row < end_row; ++row) {
    if (!sheet.closed && (row < 0 || row >= rows)) continue;
    for (PetscInt marker = piece.first + row * width; marker < piece.first + (row + 1) * width; ++marker) {
      if (marker == own_first) patch.own_begin = patch.markers.size();
      patch.markers.push_back(piece.first + (marker - piece.first + sheet_reach * piece.count) % piece.count);
    }
  }
  patch.own_end = patch.own_begin + static_cast<std::size_t>(own_end - own_first);
  return patch;
}

template <int Dim>
std::string Cloths<Dim>::name_of(std::size_t piece) const {
  const std::size_t group = pieces_[piece].group;
  std::size_t number = 1;
  for (std::size_t p = 0; p < piece; ++p) number += pieces_[p].group == group ? 1 : 0;
  return groups_[group].name + " " + std::to_string(number);
}

template <int Dim>
void Cloths<Dim>::find_markers() {
  for (const Patch& patch : patches_) {
    const ClothGroup<Dim>& group = group_of(patch);
    for (std::size_t i = patch.own_begin; i < patch.own_end; ++i) {
      const double share = group.marker_share(patch.markers[i] - pieces_[patch.piece].first);
      piece_of_marker_.push_back(patch.piece);
      marker_shares_.push_back(share);
      marker_areas_.push_back(share * group.sheet.part_area());
      marker_masses_.push_back(group.excess_mass * marker_areas_.back());
    }
  }
}

template <int Dim>
std::vector<std::array<PetscInt, 4>> Cloths<Dim>::quads(const Piece& piece) const {
  const PetscInt width = groups_[piece.group].markers[1];
  std::vector<std::array<PetscInt, 4>> quads;
  for (PetscInt k = piece.first; k + width < piece.first + piece.count; ++k)
    if ((k - piece.first) % width + 1 < width) quads.push_back({k, k + 1, k + width + 1, k + width});
  return quads;
}

template <int Dim>
void Cloths<Dim>::build_halo(const petsc::Layout& layout) {
  std::vector<PetscInt> markers;
  for (const Patch& patch : patches_) markers.insert(markers.end(), patch.markers.begin(), patch.markers.end());
  WASH_PETSC(PetscSFCreate(comm_, halo_.put()));
  WASH_PETSC(PetscSFSetGraphLayout(halo_, layout, static_cast<PetscInt>(markers.size()), nullptr, PETSC_COPY_VALUES,
                                   markers.data()));
  WASH_PETSC(PetscSFSetUp(halo_));
}

template <int Dim>
template <class Values>
Values Cloths<Dim>::halo_of(const Values& values, MPI_Datatype type) const {
  Values result(halo_count_);
  WASH_PETSC(PetscSFBcastBegin(halo_, type, values.data(), result.data(), MPI_REPLACE));
  WASH_PETSC(PetscSFBcastEnd(halo_, type, values.data(), result.data(), MPI_REPLACE));
  return result;
}

template <int Dim>
Points<Dim> Cloths<Dim>::with_halo(const Points<Dim>& values) const {
  return halo_of(values, point_type_);
}

template <int Dim>
std::vector<double> Cloths<Dim>::with_halo(const std::vector<double>& values) const {
  return halo_of(values, MPI_DOUBLE);
}

template <int Dim>
std::span<const Point<Dim>> Cloths<Dim>::seen(const Points<Dim>& with_halo, const Patch& patch) const {
  return std::span<const Point<Dim>>(with_halo).subspan(patch.first_in_halo, patch.markers.size());
}

// Collects this rank's values; find(patch) gives a value for each marker of a patch.
template <int Dim>
template <class Find>
auto Cloths<Dim>::values_by_patch(const Find& find) const {
  std::invoke_result_t<Find, const Patch&> result(owned());
  for (const Patch& patch : patches_) {
    const auto values = find(patch);
    for (std::size_t i = patch.own_begin; i < patch.own_end; ++i)
      result[patch.own_first + i - patch.own_begin] = values[i];
  }
  return result;
}

template <int Dim>
Points<Dim> Cloths<Dim>::normals(const Points<Dim>& positions) const {
  const Points<Dim> x = with_halo(positions);
  return values_by_patch(
      [&](const Patch& patch) { return washfsi::normals<Dim>(group_of(patch).sheet, seen(x, patch)); });
}

template <int Dim>
std::vector<MarkerState> Cloths<Dim>::marker_states(const Points<Dim>& positions) const {
  const Points<Dim> x = with_halo(positions);
  return values_by_patch(
      [&](const Patch& patch) { return washfsi::marker_states<Dim>(group_of(patch).sheet, seen(x, patch)); });
}

template <int Dim>
std::vector<double> Cloths<Dim>::largest_stretches(const Points<Dim>& positions) const {
  const Points<Dim> x = with_halo(positions);
  std::vector<double> stretches(groups_.size(), 0.0);
  for (const Patch& patch : patches_) {
    double& most = stretches[pieces_[patch.piece].group];
    most = std::max(most, largest_stretch<Dim>(group_of(patch).sheet, seen(x, patch)));
  }
  for (double& stretch : stretches) stretch = largest(comm_, stretch);
  return stretches;
}

template class Cloths<2>;
template class Cloths<3>;

}  // namespace washfsi
