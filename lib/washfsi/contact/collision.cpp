// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/collision.hpp"

#include <algorithm>

namespace washfsi {

namespace {

// How much nearer the facets can come by these motions, without their common part.
template <int Dim>
double approach(PairKind kind, PairPoints<Dim>& motions) {
  Point<Dim> mean = Point<Dim>::Zero();
  for (const auto& motion : motions) mean += motion / static_cast<double>(motions.size());
  double first = 0, second = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    motions[i] -= mean;
    double& most = i < markers_of_first(kind) ? first : second;
    most = std::max(most, motions[i].norm());
  }
  return first + second;
}

}  // namespace

template <int Dim>
double step_limit(PairKind kind, PairPoints<Dim> places, PairPoints<Dim> motions) {
  constexpr double kept = 0.1;
  constexpr int most_advances = 10000;  // each is safe, so stopping early is safe too
  const double fastest = approach<Dim>(kind, motions);
  const double start = gap_of<Dim>(kind, places).distance;
  if (start == 0) return 0;
  if (fastest <= (1 - kept) * start) return 1;
  double part = 0, advance = (1 - kept) * start / fastest;
  for (int n = 0; n < most_advances; ++n) {
    for (std::size_t i = 0; i < places.size(); ++i) places[i] += advance * motions[i];
    const double distance = gap_of<Dim>(kind, places).distance;
    if (part > 0 && distance <= kept * start) return part;
    part += advance;
    if (part >= 1) return 1;
    advance = 0.9 * distance / fastest;
  }
  return part;
}

template double step_limit<2>(PairKind, PairPoints<2>, PairPoints<2>);
template double step_limit<3>(PairKind, PairPoints<3>, PairPoints<3>);

}  // namespace washfsi
