// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/near_markers.hpp"

#include <algorithm>
#include <numeric>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
NearMarkers<Dim>::NearMarkers(const Cloths<Dim>& cloths, const PeriodicSpace<Dim>& space)
    : cloths_(cloths), blocks_(cloths, space) {
  std::vector<std::size_t> own(cloths.owned());
  std::iota(own.begin(), own.end(), static_cast<std::size_t>(cloths.begin()));
  know(std::move(own));
}

template <int Dim>
bool NearMarkers<Dim>::choose(const Points<Dim>& positions, const std::vector<double>& reaches, double distance,
                              Before before) {
  if (ranks_of(cloths_.comm()) == 1) return false;  // all markers are its own
  const petsc::LogPart part("near_markers");
  std::vector<std::size_t> markers = blocks_.markers_near(positions, reaches, distance);
  for (std::size_t m = 0; m < cloths_.owned(); ++m) markers.push_back(static_cast<std::size_t>(cloths_.number_of(m)));
  if (before == Before::keep) markers.insert(markers.end(), numbers_.begin(), numbers_.end());
  std::sort(markers.begin(), markers.end());
  markers.erase(std::unique(markers.begin(), markers.end()), markers.end());
  const bool changes = any_rank(cloths_.comm(), markers != numbers_);
  if (changes) know(std::move(markers));
  return changes;
}

// Builds the communication of values from the owners of the known markers.
template <int Dim>
void NearMarkers<Dim>::know(std::vector<std::size_t> numbers) {
  numbers_ = std::move(numbers);
  begin_ = place_of(static_cast<std::size_t>(cloths_.begin()));
  pieces_.clear();
  std::vector<PetscInt> places, others;
  for (std::size_t known = 0, piece = 0; known < numbers_.size(); ++known) {
    const auto number = static_cast<PetscInt>(numbers_[known]);
    while (number >= cloths_.pieces()[piece].first + cloths_.pieces()[piece].count) ++piece;
    pieces_.push_back(piece);
    if (owns(known)) continue;
    places.push_back(static_cast<PetscInt>(known));
    others.push_back(number);
  }
  WASH_PETSC(PetscSFCreate(cloths_.comm(), forest_.put()));
  WASH_PETSC(PetscSFSetGraphLayout(forest_, cloths_.layout(), static_cast<PetscInt>(others.size()), places.data(),
                                   PETSC_COPY_VALUES, others.data()));
  WASH_PETSC(PetscSFSetUp(forest_));
}

template <int Dim>
std::size_t NearMarkers<Dim>::place_of(std::size_t number) const {
  return static_cast<std::size_t>(std::lower_bound(numbers_.begin(), numbers_.end(), number) - numbers_.begin());
}

template <int Dim>
template <class Values>
Values NearMarkers<Dim>::known(const Values& own, MPI_Datatype type) const {
  Values all(numbers_.size());
  WASH_PETSC(PetscSFBcastBegin(forest_, type, own.data(), all.data(), MPI_REPLACE));
  std::copy(own.begin(), own.end(), all.begin() + static_cast<std::ptrdiff_t>(begin_));
  WASH_PETSC(PetscSFBcastEnd(forest_, type, own.data(), all.data(), MPI_REPLACE));
  return all;
}

template <int Dim>
template <class Values>
Values NearMarkers<Dim>::reduced(const Values& of_known, MPI_Datatype type, MPI_Op operation) const {
  Values result = own(of_known);
  WASH_PETSC(PetscSFReduceBegin(forest_, type, of_known.data(), result.data(), operation));
  WASH_PETSC(PetscSFReduceEnd(forest_, type, of_known.data(), result.data(), operation));
  return result;
}

template <int Dim>
Points<Dim> NearMarkers<Dim>::values(const Points<Dim>& own) const {
  return known(own, point_type_);
}

template <int Dim>
std::vector<double> NearMarkers<Dim>::values(const std::vector<double>& own) const {
  return known(own, MPI_DOUBLE);
}

template <int Dim>
Points<Dim> NearMarkers<Dim>::sums(const Points<Dim>& of_known) const {
  return reduced(of_known, point_type_, MPI_SUM);
}

template <int Dim>
std::vector<double> NearMarkers<Dim>::least(const std::vector<double>& of_known) const {
  return reduced(of_known, MPI_DOUBLE, MPI_MIN);
}

template class NearMarkers<2>;
template class NearMarkers<3>;

}  // namespace washfsi
