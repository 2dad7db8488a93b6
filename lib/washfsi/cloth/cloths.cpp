// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/cloths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>

#include "washfsi/cloth/love.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
PointType<Dim>::PointType() {
  MPI_Type_contiguous(Dim, MPI_DOUBLE, &type_);
  MPI_Type_commit(&type_);
}

template <int Dim>
PointType<Dim>::~PointType() {
  MPI_Type_free(&type_);
}

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
  find_parts();
  find_markers();
  build_halo(layout);
}

template <int Dim>
void Cloths<Dim>::find_parts() {
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const Piece& piece = pieces_[p];
    const PetscInt own_first = std::max(piece.first, begin_), own_end = std::min(piece.first + piece.count, end_);
    if (own_first >= own_end) continue;
    parts_.push_back(part_of(p, own_first, own_end));
    halo_count_ += parts_.back().markers.size();
  }
}

template <int Dim>
typename Cloths<Dim>::Part Cloths<Dim>::part_of(std::size_t number, PetscInt own_first, PetscInt own_end) const {
  const Piece& piece = pieces_[number];
  const Sheet& sheet = groups_[piece.group].sheet;
  const auto width = static_cast<PetscInt>(sheet.width);
  const PetscInt first_row = (own_first - piece.first) / width - sheet_reach;
  const PetscInt end_row = (own_end - piece.first + width - 1) / width + sheet_reach, rows = piece.count / width;
  Part part{number, {}, halo_count_, 0, 0, static_cast<std::size_t>(own_first - begin_)};
  for (PetscInt row = first_row; row < end_row; ++row) {
    if (!sheet.closed && (row < 0 || row >= rows)) continue;
    for (PetscInt marker = piece.first + row * width; marker < piece.first + (row + 1) * width; ++marker) {
      if (marker == own_first) part.own_begin = part.markers.size();
      part.markers.push_back(piece.first + (marker - piece.first + sheet_reach * piece.count) % piece.count);
    }
  }
  part.own_end = part.own_begin + static_cast<std::size_t>(own_end - own_first);
  return part;
}

namespace {

// A force at the very edge, half a spacing beyond the first or last row: the share of the row so many places from
// there, with the right force and torque.
double end_force_share(PetscInt from_end) {
  return from_end == 0 ? 1.5 : from_end == 1 ? -0.5 : 0;
}

}  // namespace

template <int Dim>
void Cloths<Dim>::find_markers() {
  for (const Part& part : parts_) {
    const ClothGroup<Dim>& group = group_of(part);
    const std::vector<PetscInt> held = group.held_markers();
    const double area = group.sheet.marker_area();
    const auto width = static_cast<PetscInt>(group.sheet.width);
    for (std::size_t i = part.own_begin; i < part.own_end; ++i) {
      const PetscInt along = part.markers[i] - pieces_[part.piece].first;
      if (std::find(held.begin(), held.end(), along) != held.end())
        holds_.push_back({piece_of_marker_.size(), group.hold_stiffness, Point<Dim>::Zero()});
      piece_of_marker_.push_back(part.piece);
      marker_areas_.push_back(area);
      marker_masses_.push_back(group.excess_mass * area);
      const PetscInt row = along / width, rows = group.markers[0];
      const double of_row = 1 / static_cast<double>(width);
      dead_loads_.push_back(area * group.load + of_row * end_force_share(row) * group.end_force_first +
                            of_row * end_force_share(rows - 1 - row) * group.end_force_last);
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
void Cloths<Dim>::hold_at(const Points<Dim>& positions) {
  for (Hold& hold : holds_) hold.anchor = positions[hold.marker];
}

template <int Dim>
Points<Dim> Cloths<Dim>::of_all_ranks(const Points<Dim>& values) const {
  const auto ranks = static_cast<std::size_t>(ranks_of(comm_));
  std::vector<int> counts(ranks), starts(ranks, 0);
  const int mine = static_cast<int>(values.size());
  MPI_Allgather(&mine, 1, MPI_INT, counts.data(), 1, MPI_INT, comm_);
  std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0);
  Points<Dim> all(static_cast<std::size_t>(total_));
  MPI_Allgatherv(values.data(), mine, point_type_, all.data(), counts.data(), starts.data(), point_type_, comm_);
  return all;
}

template <int Dim>
void Cloths<Dim>::build_halo(const petsc::Layout& layout) {
  std::vector<PetscSFNode> sources;
  for (const Part& part : parts_)
    for (const PetscInt marker : part.markers) {
      PetscMPIInt rank = 0;
      PetscInt index = 0;
      WASH_PETSC(PetscLayoutFindOwnerIndex(layout, marker, &rank, &index));
      sources.push_back({rank, index});
    }
  halo_ = petsc::star_forest(comm_, owned(), sources);
}

template <int Dim>
bool Cloths<Dim>::any_damping() const {
  return std::any_of(groups_.begin(), groups_.end(), [](const auto& group) { return group.sheet.damping > 0; });
}

template <int Dim>
Points<Dim> Cloths<Dim>::with_halo(const Points<Dim>& values) const {
  Points<Dim> result(halo_count_);
  WASH_PETSC(PetscSFBcastBegin(halo_, point_type_, values.data(), result.data(), MPI_REPLACE));
  WASH_PETSC(PetscSFBcastEnd(halo_, point_type_, values.data(), result.data(), MPI_REPLACE));
  return result;
}

template <int Dim>
std::span<const Point<Dim>> Cloths<Dim>::visible(const Points<Dim>& with_halo, const Part& part) const {
  return std::span<const Point<Dim>>(with_halo).subspan(part.first_in_halo, part.markers.size());
}

// find(part) gives a value for each marker of a part; those of this rank's markers are kept.
template <int Dim>
template <class Find>
auto Cloths<Dim>::values_of_parts(const Find& find) const {
  std::invoke_result_t<Find, const Part&> result(owned());
  for (const Part& part : parts_) {
    const auto values = find(part);
    for (std::size_t i = part.own_begin; i < part.own_end; ++i) result[part.own_first + i - part.own_begin] = values[i];
  }
  return result;
}

// add_forces(part, forces) for each part.
template <int Dim>
template <class Force>
Points<Dim> Cloths<Dim>::forces_of_parts(const Force& add_forces) const {
  return values_of_parts([&](const Part& part) {
    Points<Dim> forces(part.markers.size(), Point<Dim>::Zero());
    add_forces(part, std::span<Point<Dim>>(forces));
    return forces;
  });
}

template <int Dim>
Points<Dim> Cloths<Dim>::elastic_forces(const Points<Dim>& positions) const {
  const petsc::LogPart log("cloth_force");
  const Points<Dim> x = with_halo(positions);
  Points<Dim> result = forces_of_parts([&](const Part& part, std::span<Point<Dim>> forces) {
    const ClothGroup<Dim>& group = group_of(part);
    if (group.model == "love")
      add_love_forces(group.sheet, visible(x, part), forces);
    else
      add_energy_forces<Dim>(group.sheet, visible(x, part), forces);
  });
  for (const Hold& hold : holds_) result[hold.marker] -= hold.stiffness * (positions[hold.marker] - hold.anchor);
  return result;
}

template <int Dim>
Points<Dim> Cloths<Dim>::stiffness_product(const Points<Dim>& positions, const Points<Dim>& direction) const {
  const Points<Dim> x = with_halo(positions), d = with_halo(direction);
  Points<Dim> result = forces_of_parts([&](const Part& part, std::span<Point<Dim>> rates) {
    add_energy_force_rates<Dim>(group_of(part).sheet, visible(x, part), visible(d, part), rates);
  });
  for (const Hold& hold : holds_) result[hold.marker] -= hold.stiffness * direction[hold.marker];
  for (auto& rate : result) rate = -rate;
  return result;
}

template <int Dim>
double Cloths<Dim>::force_round_off(const Points<Dim>& positions) const {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  std::vector<double> largest(positions.size());
  for (std::size_t m = 0; m < positions.size(); ++m) {
    const Sheet& sheet = group_of(m).sheet;
    largest[m] = sheet.ke_s * sheet.dr + 16 * sheet.kb_s * sheet.dr * positions[m].norm() / std::pow(sheet.ds, 3);
    if (sheet.width > 1)
      largest[m] += sheet.ke_r * sheet.ds + 16 * sheet.kb_r * sheet.ds * positions[m].norm() / std::pow(sheet.dr, 3);
  }
  for (const Hold& hold : holds_) largest[hold.marker] += hold.stiffness * positions[hold.marker].norm();
  double squares = 0;
  for (const double force : largest) squares += force * force;
  return epsilon * std::sqrt(ordered_sum(comm_, squares));
}

template <int Dim>
Points<Dim> Cloths<Dim>::damping_forces(const Points<Dim>& positions, const Points<Dim>& velocities) const {
  if (!any_damping()) return Points<Dim>(owned(), Point<Dim>::Zero());
  const petsc::LogPart log("cloth_force");
  const Points<Dim> x = with_halo(positions), u = with_halo(velocities);
  return forces_of_parts([&](const Part& part, std::span<Point<Dim>> forces) {
    add_damping_forces<Dim>(group_of(part).sheet, visible(x, part), visible(u, part), forces);
  });
}

// Calls add(row, column, block) for the parts of the Jacobian of -elastic_forces in this rank's rows, by the numbers of
// their markers; always in the same order.
template <int Dim>
template <class Add>
void Cloths<Dim>::visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric, const Add& add) const {
  const Points<Dim> x = with_halo(positions);
  for (const Part& part : parts_)
    add_energy_stiffness<Dim>(group_of(part).sheet, visible(x, part), geometric,
                              [&](std::size_t row, std::size_t column, const StiffnessBlock<Dim>& block) {
                                if (row < part.own_begin || row >= part.own_end)
                                  return;  // another rank's, or incomplete here
                                add(part.markers[row], part.markers[column], block);
                              });
  for (const Hold& hold : holds_) {
    const PetscInt marker = begin_ + static_cast<PetscInt>(hold.marker);
    add(marker, marker, hold.stiffness * StiffnessBlock<Dim>::Identity());
  }
}

template <int Dim>
petsc::Matrix Cloths<Dim>::stiffness_matrix() const {
  std::vector<PetscInt> rows, columns;
  visit_stiffness(Points<Dim>(owned(), Point<Dim>::Zero()), GeometricStiffness::all,
                  [&](PetscInt row, PetscInt column, const StiffnessBlock<Dim>&) {
                    for (PetscInt a = 0; a < Dim; ++a)
                      for (PetscInt b = 0; b < Dim; ++b) {
                        rows.push_back(row * Dim + a);
                        columns.push_back(column * Dim + b);
                      }
                  });
  const PetscInt own_rows = (end_ - begin_) * Dim;
  petsc::Matrix matrix;
  WASH_PETSC(MatCreate(comm_, matrix.put()));
  WASH_PETSC(MatSetSizes(matrix, own_rows, own_rows, PETSC_DETERMINE, PETSC_DETERMINE));
  WASH_PETSC(MatSetBlockSize(matrix, Dim));
  WASH_PETSC(MatSetType(matrix, MATAIJ));
  WASH_PETSC(MatSetPreallocationCOO(matrix, static_cast<PetscCount>(rows.size()), rows.data(), columns.data()));
  WASH_PETSC(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE));
  return matrix;
}

template <int Dim>
void Cloths<Dim>::set_stiffness(const Points<Dim>& positions, GeometricStiffness geometric, double factor,
                                Mat matrix) const {
  std::vector<double> values;
  visit_stiffness(positions, geometric, [&](PetscInt, PetscInt, const StiffnessBlock<Dim>& block) {
    for (int a = 0; a < Dim; ++a)
      for (int b = 0; b < Dim; ++b) values.push_back(factor * block(a, b));
  });
  WASH_PETSC(MatSetValuesCOO(matrix, values.data(), INSERT_VALUES));
}

template <int Dim>
Points<Dim> Cloths<Dim>::normals(const Points<Dim>& positions) const {
  const Points<Dim> x = with_halo(positions);
  return values_of_parts(
      [&](const Part& part) { return washfsi::normals<Dim>(group_of(part).sheet, visible(x, part)); });
}

template <int Dim>
std::vector<MarkerState> Cloths<Dim>::marker_states(const Points<Dim>& positions) const {
  const Points<Dim> x = with_halo(positions);
  return values_of_parts(
      [&](const Part& part) { return washfsi::marker_states<Dim>(group_of(part).sheet, visible(x, part)); });
}

template <int Dim>
std::vector<double> Cloths<Dim>::elastic_energies(const Points<Dim>& positions) const {
  const Points<Dim> x = with_halo(positions);
  std::vector<double> energies(groups_.size(), 0.0);
  for (const Part& part : parts_)
    energies[pieces_[part.piece].group] +=
        elastic_energy<Dim>(group_of(part).sheet, visible(x, part), part.own_begin, part.own_end);
  for (const Hold& hold : holds_)
    energies[pieces_[piece_of_marker_[hold.marker]].group] +=
        0.5 * hold.stiffness * (positions[hold.marker] - hold.anchor).squaredNorm();
  return ordered_sum(comm_, energies);
}

template <int Dim>
std::vector<double> Cloths<Dim>::largest_stretches(const Points<Dim>& positions) const {
  const Points<Dim> x = with_halo(positions);
  std::vector<double> stretches(groups_.size(), 0.0);
  for (const Part& part : parts_) {
    double& most = stretches[pieces_[part.piece].group];
    most = std::max(most, largest_stretch<Dim>(group_of(part).sheet, visible(x, part)));
  }
  for (double& stretch : stretches) stretch = largest(comm_, stretch);
  return stretches;
}

template class PointType<2>;
template class PointType<3>;
template class Cloths<2>;
template class Cloths<3>;

}  // namespace washfsi
