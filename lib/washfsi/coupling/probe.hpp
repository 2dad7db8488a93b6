// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/marker_exchange.hpp"
#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// Reads the velocity at any places, on whatever rank they are: linearly between faces, not with the delta.
template <int Dim>
class Probe {
 public:
  explicit Probe(const Grid<Dim>& grid) : grid_(grid), exchange_(grid) {}

  /// Velocity at this rank's places, of a local velocity whose ghosts are filled; places outside the box are moved to
  /// its surface. Collective.
  Points<Dim> sample(Vec local_velocity, Points<Dim> places);

 private:
  const Grid<Dim>& grid_;
  MarkerExchange<Dim> exchange_;
};

extern template class Probe<2>;
extern template class Probe<3>;

}  // namespace washfsi
