// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/facet_blocks.hpp"

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
FacetBlocks<Dim>::FacetBlocks(const Cloths<Dim>& cloths, const PeriodicSpace<Dim>& space)
    : cloths_(cloths), space_(space) {
  const std::vector<Block> mine = own_blocks();
  blocks_ = of_all_ranks(cloths.comm(), mine);
  counts_ = of_all_ranks(cloths.comm(), std::vector<int>{static_cast<int>(2 * Dim * mine.size())});
  starts_.resize(counts_.size());
  std::exclusive_scan(counts_.begin(), counts_.end(), starts_.begin(), 0);
}

template <int Dim>
std::vector<typename FacetBlocks<Dim>::Block> FacetBlocks<Dim>::own_blocks() const {
  std::vector<Block> blocks;
  for (const LatticePart& part : cloths_.lattices().parts()) {
    const std::size_t begin = static_cast<std::size_t>(cloths_.begin()) + part.own_first,
                      end = begin + part.own_end - part.own_begin;
    for (std::size_t first = begin; first < end; first += most_of_block)
      blocks.push_back({part.piece, first, std::min(first + most_of_block, end)});
  }
  return blocks;
}

template <int Dim>
std::vector<std::size_t> FacetBlocks<Dim>::markers_near(const Points<Dim>& positions,
                                                        const std::vector<double>& reaches, double distance) const {
  const std::vector<Bounds<Dim>> own = own_boxes(positions, reaches, distance);
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

// Boxes of the facets that begin at a block's markers, with half of the distance round them.
template <int Dim>
std::vector<Bounds<Dim>> FacetBlocks<Dim>::own_boxes(const Points<Dim>& positions, const std::vector<double>& reaches,
                                                     double distance) const {
  const Points<Dim> places = cloths_.lattices().with_halo(positions);
  const std::vector<double> margins = cloths_.lattices().with_halo(reaches);
  std::vector<Bounds<Dim>> boxes;
  for (const LatticePart& part : cloths_.lattices().parts()) {
    const std::size_t width = cloths_.group_of(part).sheet.width;
    for (std::size_t first = part.own_begin; first < part.own_end; first += most_of_block) {
      const std::size_t end = std::min(first + most_of_block, part.own_end);
      std::vector<Bounds<Dim>> of_markers;
      for (const auto& [begin, stop] : runs(first, end, width))
        for (std::size_t m = begin; m < std::min(stop, part.markers.size()); ++m) {
          const std::size_t place = part.first_in_halo + m;
          of_markers.push_back(
              Bounds<Dim>::round(places[place], Point<Dim>::Constant(margins[place] + 0.5 * distance)));
        }
      boxes.push_back(hull(of_markers));
    }
  }
  return boxes;
}

template <int Dim>
std::vector<Bounds<Dim>> FacetBlocks<Dim>::of_all_blocks(const std::vector<Bounds<Dim>>& own) const {
  static_assert(sizeof(Bounds<Dim>) == 2 * Dim * sizeof(double));
  std::vector<Bounds<Dim>> all(blocks_.size());
  MPI_Allgatherv(own.data(), static_cast<int>(2 * Dim * own.size()), MPI_DOUBLE, all.data(), counts_.data(),
                 starts_.data(), MPI_DOUBLE, cloths_.comm());
  return all;
}

// Adds the markers of a block's facets; a closed cloth continues at its start.
template <int Dim>
void FacetBlocks<Dim>::add_markers(const Block& block, std::vector<std::size_t>& markers) const {
  const Piece& piece = cloths_.pieces()[block.piece];
  const Sheet& sheet = cloths_.groups()[piece.group].sheet;
  const auto start = static_cast<std::size_t>(piece.first), count = static_cast<std::size_t>(piece.count);
  for (const auto& [begin, stop] : runs(block.first - start, block.end - start, sheet.width))
    for (std::size_t m = begin; m < (sheet.closed ? stop : std::min(stop, count)); ++m)
      markers.push_back(start + m % count);
}

template class FacetBlocks<2>;
template class FacetBlocks<3>;

}  // namespace washfsi
