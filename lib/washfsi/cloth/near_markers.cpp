// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/near_markers.hpp"

#include <algorithm>
#include <numeric>

#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi {

namespace {

constexpr std::size_t most_of_block = 32;  // markers in a block: boxes are small, and few compared to markers

/// The markers of the facets that begin at some markers of a cloth: these, the next one, and the same in the next row.
std::array<std::pair<std::size_t, std::size_t>, 2> runs(std::size_t first, std::size_t end, std::size_t width) {
  return {std::pair{first, end + 1}, std::pair{first + width, end + width + 1}};
}

}  // namespace

template <int Dim>
NearMarkers<Dim>::NearMarkers(const Cloths<Dim>& cloths, const PeriodicSpace<Dim>& space)
    : cloths_(cloths), space_(space) {
  const auto owned = static_cast<PetscInt>(cloths.owned());
  WASH_PETSC(PetscLayoutCreateFromSizes(cloths.comm(), owned, PETSC_DETERMINE, 1, layout_.put()));
  const std::vector<Block> mine = own_blocks();
  blocks_ = of_all_ranks(cloths.comm(), mine);
  counts_ = of_all_ranks(cloths.comm(), std::vector<int>{static_cast<int>(2 * Dim * mine.size())});
  starts_.resize(counts_.size());
  std::exclusive_scan(counts_.begin(), counts_.end(), starts_.begin(), 0);
  std::vector<std::size_t> own(cloths.owned());
  std::iota(own.begin(), own.end(), static_cast<std::size_t>(cloths.begin()));
  know(std::move(own));
}

template <int Dim>
std::vector<typename NearMarkers<Dim>::Block> NearMarkers<Dim>::own_blocks() const {
  std::vector<Block> blocks;
  for (const Patch& patch : cloths_.patches()) {
    const std::size_t begin = static_cast<std::size_t>(cloths_.begin()) + patch.own_first,
                      end = begin + patch.own_end - patch.own_begin;
    for (std::size_t first = begin; first < end; first += most_of_block)
      blocks.push_back({patch.piece, first, std::min(first + most_of_block, end)});
  }
  return blocks;
}

// Boxes of the facets that begin at a block's markers, with half of the distance round them.
template <int Dim>
std::vector<Bounds<Dim>> NearMarkers<Dim>::own_boxes(const Points<Dim>& positions, const std::vector<double>& reaches,
                                                     double distance) const {
  const Points<Dim> places = cloths_.with_halo(positions);
  const std::vector<double> margins = cloths_.with_halo(reaches);
  std::vector<Bounds<Dim>> boxes;
  for (const Patch& patch : cloths_.patches()) {
    const std::size_t width = cloths_.group_of(patch).sheet.width;
    for (std::size_t first = patch.own_begin; first < patch.own_end; first += most_of_block) {
      const std::size_t end = std::min(first + most_of_block, patch.own_end);
      std::vector<Bounds<Dim>> of_markers;
      for (const auto& [begin, stop] : runs(first, end, width))
        for (std::size_t m = begin; m < std::min(stop, patch.markers.size()); ++m) {
          const std::size_t place = patch.first_in_halo + m;
          of_markers.push_back(
              Bounds<Dim>::round(places[place], Point<Dim>::Constant(margins[place] + 0.5 * distance)));
        }
      boxes.push_back(hull(of_markers));
    }
  }
  return boxes;
}

template <int Dim>
std::vector<Bounds<Dim>> NearMarkers<Dim>::of_all_blocks(const std::vector<Bounds<Dim>>& own) const {
  static_assert(sizeof(Bounds<Dim>) == 2 * Dim * sizeof(double));
  std::vector<Bounds<Dim>> all(blocks_.size());
  MPI_Allgatherv(own.data(), static_cast<int>(2 * Dim * own.size()), MPI_DOUBLE, all.data(), counts_.data(),
                 starts_.data(), MPI_DOUBLE, cloths_.comm());
  return all;
}

template <int Dim>
std::vector<std::size_t> NearMarkers<Dim>::markers_near(const std::vector<Bounds<Dim>>& own) const {
  std::vector<Bounds<Dim>> boxes = of_all_blocks(own);
  Point<Dim> mean = Point<Dim>::Zero();
  for (const auto& box : boxes) mean += (box.upper - box.lower) / static_cast<double>(boxes.size());
  const NearSearch<Dim> search(std::move(boxes), mean, hull(own), space_);
  std::vector<char> is_near(blocks_.size(), 0);
  for (const auto& box : own) search.visit_near(box, [&](std::size_t block) { is_near[block] = 1; });
  std::vector<std::size_t> markers;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (is_near[b]) add_markers(blocks_[b], markers);
  return markers;
}

// Adds the markers of a block's facets; a closed cloth continues at its start.
template <int Dim>
void NearMarkers<Dim>::add_markers(const Block& block, std::vector<std::size_t>& markers) const {
  const Piece& piece = cloths_.pieces()[block.piece];
  const Sheet& sheet = cloths_.groups()[piece.group].sheet;
  const auto start = static_cast<std::size_t>(piece.first), count = static_cast<std::size_t>(piece.count);
  for (const auto& [begin, stop] : runs(block.first - start, block.end - start, sheet.width))
    for (std::size_t m = begin; m < (sheet.closed ? stop : std::min(stop, count)); ++m)
      markers.push_back(start + m % count);
}

template <int Dim>
bool NearMarkers<Dim>::choose(const Points<Dim>& positions, const std::vector<double>& reaches, double distance,
                              Before before) {
  if (ranks_of(cloths_.comm()) == 1) return false;  // all markers are its own
  const petsc::LogPart part("near_markers");
  std::vector<std::size_t> markers = markers_near(own_boxes(positions, reaches, distance));
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
  WASH_PETSC(PetscSFSetGraphLayout(forest_, layout_, static_cast<PetscInt>(others.size()), places.data(),
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
