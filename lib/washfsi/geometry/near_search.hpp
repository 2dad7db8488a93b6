// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// A box with sides along the axes; without extent for a point.
template <int Dim>
struct Bounds {
  Point<Dim> lower, upper;  ///< [m]

  static Bounds round(const Point<Dim>& place, const Point<Dim>& margin) { return {place - margin, place + margin}; }
  void include(const Bounds& other) {
    lower = lower.cwiseMin(other.lower);
    upper = upper.cwiseMax(other.upper);
  }
};

/// The bounds of several boxes; a point if there are none.
template <int Dim>
Bounds<Dim> hull(const std::vector<Bounds<Dim>>& boxes) {
  if (boxes.empty()) return {Point<Dim>::Zero(), Point<Dim>::Zero()};
  Bounds<Dim> all = boxes.front();
  for (const Bounds<Dim>& box : boxes) all.include(box);
  return all;
}

/// Returns points as boxes without extent.
template <int Dim>
std::vector<Bounds<Dim>> bounds_of(const Points<Dim>& places) {
  std::vector<Bounds<Dim>> bounds;
  for (const auto& place : places) bounds.push_back({place, place});
  return bounds;
}

/// A space that repeats itself along some axes.
template <int Dim>
struct PeriodicSpace {
  Point<Dim> lower = Point<Dim>::Zero(), length = Point<Dim>::Zero();  ///< start, length of periods [m]
  std::array<bool, Dim> periodic{};
};

/// The periods of a grid.
template <int Dim, class Grid>
PeriodicSpace<Dim> periods_of(const Grid& grid) {
  PeriodicSpace<Dim> space{grid.lower(), grid.upper() - grid.lower(), {}};
  for (int d = 0; d < Dim; ++d) space.periodic[d] = grid.periodic(d);
  return space;
}

/// Finds which of many things come near to a place: their boxes are sorted into bins of equal size. Along periodic axes
/// all images count.
template <int Dim>
class NearSearch {
 public:
  /// `bin` are the least lengths of a bin [m]; best is about the size of the boxes and of the query bounds. Only boxes
  /// near to `asked`, which contains all query bounds, are stored.
  NearSearch(std::vector<Bounds<Dim>> boxes, const Point<Dim>& bin, const Bounds<Dim>& asked,
             const PeriodicSpace<Dim>& space = {});

  /// The numbers, from `from` on, of the boxes that overlap these bounds, in ascending order; along a periodic axis
  /// others may be among them.
  std::vector<std::size_t> near(const Bounds<Dim>& bounds, std::size_t from = 0) const;
  /// Calls visit(number) for each of them, in no order, and several times for boxes in several bins; points lie in one.
  template <class Visit>
  void visit_near(const Bounds<Dim>& bounds, const Visit& visit) const {
    visit_bins(range_of(bounds), [&](std::size_t place) {
      for (std::size_t n = starts_[place]; n < starts_[place + 1]; ++n)
        if (overlap(boxes_[numbers_[n]], bounds)) visit(numbers_[n]);
    });
  }

 private:
  using Bin = std::array<long, Dim>;
  struct Range {
    Bin first, last;
  };
  void choose_bins(const Point<Dim>& bin, const Bounds<Dim>& asked);
  Range range_of(const Bounds<Dim>& bounds) const;
  bool overlap(const Bounds<Dim>& a, const Bounds<Dim>& b) const {
    for (int d = 0; d < Dim; ++d)
      if (!space_.periodic[d] && (a.lower[d] > b.upper[d] || a.upper[d] < b.lower[d])) return false;
    return true;
  }
  std::size_t folded(long bin, int axis) const {
    return static_cast<std::size_t>(space_.periodic[axis] ? ((bin % count_[axis]) + count_[axis]) % count_[axis] : bin);
  }
  template <class Visit>
  void visit_bins(const Range& range, const Visit& visit) const {
    Bin bin = range.first;
    for (int d = 0; d < Dim;) {
      std::size_t place = 0;
      for (int e = Dim; e-- > 0;) place = place * static_cast<std::size_t>(count_[e]) + folded(bin[e], e);
      visit(place);
      for (d = 0; d < Dim && ++bin[d] > range.last[d]; ++d) bin[d] = range.first[d];
    }
  }

  std::vector<Bounds<Dim>> boxes_;
  PeriodicSpace<Dim> space_;
  Point<Dim> origin_, length_;       ///< corner of the first bin, and sides of a bin [m]
  Bin count_;                        ///< number of bins along each axis
  std::vector<std::size_t> starts_;  ///< start of each bin's numbers, and the end
  std::vector<std::size_t> numbers_;
};

extern template class NearSearch<2>;
extern template class NearSearch<3>;

}  // namespace washfsi
