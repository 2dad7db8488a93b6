// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/cloths.hpp"

#include <algorithm>
#include <cmath>

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
Cloths<Dim>::Cloths(MPI_Comm comm, std::vector<ClothGroup> groups) : comm_(comm), groups_(std::move(groups)) {
  for (std::size_t g = 0; g < groups_.size(); ++g)
    for (PetscInt c = 0; c < groups_[g].count; ++c) {
      pieces_.push_back({g, total_, groups_[g].markers});
      total_ += groups_[g].markers;
    }
  build_halo();
  for (const Piece& piece : pieces_) {
    const PetscInt piece_end = piece.first + piece.count;
    const PetscInt own_first = std::max(piece.first, begin_), own_last = std::min(piece_end, end_);
    if (own_first >= own_last) continue;
    parts_.push_back({&piece, &groups_[piece.group], std::max(piece.first, halo_begin_), std::min(piece_end, halo_end_),
                      own_first, own_last});
  }
}

template <int Dim>
void Cloths<Dim>::build_halo() {
  petsc::Layout layout;
  WASH_PETSC(PetscLayoutCreateFromSizes(comm_, PETSC_DECIDE, total_, 1, layout.put()));
  WASH_PETSC(PetscLayoutGetRange(layout, &begin_, &end_));
  const bool any = end_ > begin_;
  halo_begin_ = any ? std::max<PetscInt>(0, begin_ - fibre_reach) : begin_;
  halo_end_ = any ? std::min<PetscInt>(total_, end_ + fibre_reach) : end_;
  std::vector<PetscSFNode> sources(static_cast<std::size_t>(halo_end_ - halo_begin_));
  for (PetscInt marker = halo_begin_; marker < halo_end_; ++marker) {
    PetscMPIInt rank = 0;
    PetscInt index = 0;
    WASH_PETSC(PetscLayoutFindOwnerIndex(layout, marker, &rank, &index));
    sources[static_cast<std::size_t>(marker - halo_begin_)] = {rank, index};
  }
  halo_ = petsc::star_forest(comm_, owned(), sources);
}

template <int Dim>
std::vector<std::size_t> Cloths<Dim>::piece_of_marker() const {
  std::vector<std::size_t> result(owned());
  for (const Part& part : parts_)
    for (PetscInt m = part.own_first; m < part.own_last; ++m)
      result[static_cast<std::size_t>(m - begin_)] = static_cast<std::size_t>(part.piece - pieces_.data());
  return result;
}

template <int Dim>
std::vector<double> Cloths<Dim>::marker_lengths() const {
  std::vector<double> result;
  for (const std::size_t piece : piece_of_marker()) result.push_back(groups_[pieces_[piece].group].fibre.spacing);
  return result;
}

template <int Dim>
std::vector<double> Cloths<Dim>::marker_masses() const {
  std::vector<double> result;
  for (const std::size_t piece : piece_of_marker()) {
    const ClothGroup& group = groups_[pieces_[piece].group];
    result.push_back(group.excess_mass * group.fibre.spacing);
  }
  return result;
}

template <int Dim>
Points<Dim> Cloths<Dim>::with_halo(const Points<Dim>& values) const {
  Points<Dim> result(static_cast<std::size_t>(halo_end_ - halo_begin_));
  WASH_PETSC(PetscSFBcastBegin(halo_, point_type_, values.data(), result.data(), MPI_REPLACE));
  WASH_PETSC(PetscSFBcastEnd(halo_, point_type_, values.data(), result.data(), MPI_REPLACE));
  return result;
}

template <int Dim>
std::span<const Point<Dim>> Cloths<Dim>::visible(const Points<Dim>& with_halo, const Part& part) const {
  return std::span<const Point<Dim>>(with_halo).subspan(static_cast<std::size_t>(part.first - halo_begin_),
                                                        static_cast<std::size_t>(part.last - part.first));
}

template <int Dim>
Points<Dim> Cloths<Dim>::elastic_forces(const Points<Dim>& positions, const Points<Dim>& velocities) const {
  const petsc::LogPart log("cloth_force");
  const Points<Dim> x = with_halo(positions), u = with_halo(velocities);
  Points<Dim> result(owned(), Point<Dim>::Zero());
  for (const Part& part : parts_) {
    const auto markers = visible(x, part);
    const Fibre& fibre = part.group->fibre;
    Points<Dim> forces(markers.size(), Point<Dim>::Zero());
    if constexpr (Dim == 2) {
      if (part.group->model == "love") add_love_forces(fibre, markers, forces);
    }
    if (part.group->model == "energy") add_energy_forces<Dim>(fibre, markers, forces);
    if (fibre.damping > 0) add_damping_forces<Dim>(fibre, markers, visible(u, part), forces);
    std::copy(forces.begin() + (part.own_first - part.first), forces.begin() + (part.own_last - part.first),
              result.begin() + (part.own_first - begin_));
  }
  return result;
}

template <int Dim>
std::vector<double> Cloths<Dim>::stresses(const Points<Dim>& positions) const {
  const Points<Dim> x = with_halo(positions);
  std::vector<double> result(owned());
  for (const Part& part : parts_) {
    const std::vector<double> values = washfsi::stresses<Dim>(part.group->fibre, visible(x, part));
    std::copy(values.begin() + (part.own_first - part.first), values.begin() + (part.own_last - part.first),
              result.begin() + (part.own_first - begin_));
  }
  return result;
}

template <int Dim>
std::vector<double> Cloths<Dim>::elastic_energies(const Points<Dim>& positions) const {
  const Points<Dim> x = with_halo(positions);
  std::vector<double> energies(groups_.size(), 0.0);
  for (const Part& part : parts_)
    energies[part.piece->group] +=
        elastic_energy<Dim>(part.group->fibre, visible(x, part), static_cast<std::size_t>(part.own_first - part.first),
                            static_cast<std::size_t>(part.own_last - part.first));
  return ordered_sum(comm_, energies);
}

template <int Dim>
std::vector<double> Cloths<Dim>::largest_stretches(const Points<Dim>& positions) const {
  const Points<Dim> x = with_halo(positions);
  std::vector<double> stretches(groups_.size(), 0.0);
  for (const Part& part : parts_) {
    const auto markers = visible(x, part);
    for (std::size_t k = 0; k + 1 < markers.size(); ++k) {
      const double stretch = (markers[k + 1] - markers[k]).norm() / part.group->fibre.spacing - 1;
      stretches[part.piece->group] = std::max(stretches[part.piece->group], stretch);
    }
  }
  for (double& stretch : stretches) stretch = largest(comm_, stretch);
  return stretches;
}

template class PointType<2>;
template class PointType<3>;
template class Cloths<2>;
template class Cloths<3>;

}  // namespace washfsi
