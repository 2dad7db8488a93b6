// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/geometry/near_search.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

template <int Dim>
NearSearch<Dim>::NearSearch(std::vector<Bounds<Dim>> boxes, const Point<Dim>& bin, const Bounds<Dim>& asked,
                            const PeriodicSpace<Dim>& space)
    : boxes_(std::move(boxes)), space_(space) {
  choose_bins(bin, asked);
  std::vector<std::size_t> kept;
  for (std::size_t n = 0; n < boxes_.size(); ++n)
    if (overlap(boxes_[n], asked)) kept.push_back(n);
  std::size_t bins = 1;
  for (const long count : count_) bins *= static_cast<std::size_t>(count);
  // counted, summed up, filled in: so each bin's numbers ascend
  starts_.assign(bins + 1, 0);
  for (const std::size_t n : kept) visit_bins(range_of(boxes_[n]), [&](std::size_t place) { ++starts_[place + 1]; });
  for (std::size_t place = 0; place < bins; ++place) starts_[place + 1] += starts_[place];
  numbers_.resize(starts_.back());
  std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
  for (const std::size_t n : kept)
    visit_bins(range_of(boxes_[n]), [&](std::size_t place) { numbers_[next[place]++] = n; });
}

// Lays the bins over the query bounds, or over a period; not many more bins than boxes.
template <int Dim>
void NearSearch<Dim>::choose_bins(const Point<Dim>& bin, const Bounds<Dim>& asked) {
  const double most = std::pow(4 * static_cast<double>(boxes_.size()) + 64, 1.0 / Dim);
  for (int d = 0; d < Dim; ++d) {
    const double extent = space_.periodic[d] ? space_.length[d] : asked.upper[d] - asked.lower[d];
    origin_[d] = space_.periodic[d] ? space_.lower[d] : asked.lower[d];
    count_[d] = static_cast<long>(std::clamp(std::floor(extent / bin[d]), 1.0, most));
    length_[d] = extent > 0 ? extent / static_cast<double>(count_[d]) : 1;
  }
}

// Along a periodic axis the first may lie before the first bin, and the last beyond the last one, by less than a
// period.
template <int Dim>
typename NearSearch<Dim>::Range NearSearch<Dim>::range_of(const Bounds<Dim>& bounds) const {
  Range range;
  for (int d = 0; d < Dim; ++d) {
    const auto bin_of = [&](double x) { return static_cast<long>(std::floor((x - origin_[d]) / length_[d])); };
    range.first[d] = bin_of(bounds.lower[d]);
    range.last[d] = bin_of(bounds.upper[d]);
    if (space_.periodic[d]) {
      range.last[d] = std::min(range.last[d], range.first[d] + count_[d] - 1);
    } else {
      range.first[d] = std::clamp(range.first[d], 0L, count_[d] - 1);
      range.last[d] = std::clamp(range.last[d], 0L, count_[d] - 1);
    }
  }
  return range;
}

template <int Dim>
std::vector<std::size_t> NearSearch<Dim>::near(const Bounds<Dim>& bounds, std::size_t from) const {
  std::vector<std::size_t> found;
  visit_near(bounds, [&](std::size_t number) {
    if (number >= from) found.push_back(number);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

template class NearSearch<2>;
template class NearSearch<3>;

}  // namespace washfsi
