// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/block_places.hpp"

#include <algorithm>

namespace washfsi {

namespace {

constexpr double ahead = 1.25;  // pairs nearer than this times the contact distance are in the pattern

}  // namespace

template <int Dim>
void BlockPlaces<Dim>::lay_out(const BarrierTouches<Dim>& touches, const Points<Dim>& all) {
  const NearMarkers<Dim>& known = touches.search().known();
  std::vector<std::vector<std::size_t>> columns(cloths_.owned());
  for (std::size_t m = 0; m < columns.size(); ++m) columns[m].push_back(known.numbers()[known.begin() + m]);
  const auto couple = [&](const auto& markers, const auto& others) {
    for (const std::size_t marker : markers)
      if (known.owns(marker))
        for (const std::size_t other : others) columns[marker - known.begin()].push_back(known.numbers()[other]);
  };
  for (const auto& pair : touches.pairs())
    if (gap_of<Dim>(pair.kind, pair.at(all)).distance <
        ahead * BarrierTouches<Dim>::of_guards * touches.distances().usual())
      couple(pair.markers, pair.markers);
  for (const auto& sample : touches.samples())
    for (const auto& opposite : sample.opposites) {
      if (distance_between(sample, opposite, all) >= ahead * touches.distances().usual()) continue;
      couple(sample.face, sample.face);
      couple(sample.face, opposite.face);
      couple(opposite.face, sample.face);
      couple(opposite.face, opposite.face);
    }
  const std::vector<std::size_t> before = std::move(columns_);
  columns_.clear();
  rows_.assign(1, 0);
  for (auto& row : columns) {
    std::sort(row.begin(), row.end());
    columns_.insert(columns_.end(), row.begin(), std::unique(row.begin(), row.end()));
    rows_.push_back(columns_.size());
  }
  if (columns_ != before) ++pattern_;
  leaves_out_ = false;
}

template <int Dim>
std::size_t BlockPlaces<Dim>::place_of(std::size_t row, std::size_t column) const {
  const auto begin = columns_.begin() + static_cast<long>(rows_[row]),
             end = columns_.begin() + static_cast<long>(rows_[row + 1]);
  const auto place = std::lower_bound(begin, end, column);
  return place != end && *place == column ? static_cast<std::size_t>(place - columns_.begin()) : columns_.size();
}

template <int Dim>
void BlockPlaces<Dim>::visit(const std::vector<StiffnessBlock<Dim>>& blocks, const AddMarkerBlock<Dim>& add) const {
  for (std::size_t m = 0; m + 1 < rows_.size(); ++m)
    for (std::size_t n = rows_[m]; n < rows_[m + 1]; ++n)
      add(cloths_.number_of(m), static_cast<PetscInt>(columns_[n]), blocks[n]);
}

template class BlockPlaces<2>;
template class BlockPlaces<3>;

}  // namespace washfsi
