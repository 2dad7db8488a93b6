// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "washfsi/forcing/overlap_inverse.hpp"

namespace washfsi {

/// What the water answered to the last pushes of walls, pressure and all. Pushes of steps in a row want much the same,
/// so that of their combinations one is near to what is wanted now, and what it does is known without a projection: the
/// recycling of directions by which Krylov methods solve linear systems in a row (Parks, de Sturler, Mackey, Johnson
/// and Maiti, SIAM J. Sci. Comput. 28 (2006) 1651). All is of this rank's patches, in their bodies' frames.
template <int Dim>
class KnownPushes {
 public:
  /// The impulses on patches [N s; per unit depth in the plane] and by how much they changed the slip [m/s].
  struct Push {
    Points<Dim> impulses, answers;
  };
  static constexpr std::size_t most = 10;

  /// The overlaps, by which slips are judged, stay alive.
  KnownPushes(MPI_Comm comm, const OverlapInverse<Dim>& overlap) : comm_(comm), overlap_(overlap) {}

  /// Forgets the oldest if there are too many. Collective.
  void add(Push push);
  /// The combination whose answers come nearest to a slip, as means over the reach of a delta. Collective.
  Push best_for(const Points<Dim>& slips) const;

  /// What a restart needs: impulses and answers of one push after the other, for each patch. Taking them is collective.
  Points<Dim> kept() const;
  void take(const Points<Dim>& kept, std::size_t pushes);
  std::size_t size() const { return known_.size(); }

 private:
  struct Known {
    Push push;
    Points<Dim> felt;  ///< means of the answers
  };
  std::vector<double> weights_for(const Points<Dim>& slips) const;

  MPI_Comm comm_;
  const OverlapInverse<Dim>& overlap_;
  std::deque<Known> known_;  ///< the last first
};

extern template class KnownPushes<2>;
extern template class KnownPushes<3>;

}  // namespace washfsi
