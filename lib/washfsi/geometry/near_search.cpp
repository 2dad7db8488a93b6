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

// Over what is asked for, or over a period; no more bins than there are boxes, and some.
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

template <int Dim>
bool NearSearch<Dim>::overlap(const Bounds<Dim>& a, const Bounds<Dim>& b) const {
  for (int d = 0; d < Dim; ++d)
    if (!space_.periodic[d] && (a.lower[d] > b.upper[d] || a.upper[d] < b.lower[d])) return false;
  return true;
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
template <class Visit>
void NearSearch<Dim>::visit_bins(const Range& range, const Visit& visit) const {
  Bin bin = range.first;
  for (int d = 0; d < Dim;) {
    std::size_t place = 0;
    for (int e = Dim; e-- > 0;) {
      const long folded = ((bin[e] % count_[e]) + count_[e]) % count_[e];
      place = place * static_cast<std::size_t>(count_[e]) + static_cast<std::size_t>(folded);
    }
    visit(place);
    for (d = 0; d < Dim && ++bin[d] > range.last[d]; ++d) bin[d] = range.first[d];
  }
}

template <int Dim>
std::vector<std::size_t> NearSearch<Dim>::near(const Bounds<Dim>& bounds) const {
  std::vector<std::size_t> found;
  visit_bins(range_of(bounds), [&](std::size_t place) {
    for (std::size_t n = starts_[place]; n < starts_[place + 1]; ++n)
      if (overlap(boxes_[numbers_[n]], bounds)) found.push_back(numbers_[n]);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

template class NearSearch<2>;
template class NearSearch<3>;

}  // namespace washfsi
