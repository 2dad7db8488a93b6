// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "washfsi/support/state_list.hpp"
#include "washfsi/wall_forces/overlap_inverse.hpp"

namespace washfsi {

/// The responses of the water to the last slip corrections, pressure and all. Corrections of steps in a row are much
/// alike, so that a combination of them is near to what is needed now, and its response is known without a projection:
/// the recycling of directions by which Krylov methods solve linear systems in a row (Parks, de Sturler, Mackey,
/// Johnson and Maiti, SIAM J. Sci. Comput. 28 (2006) 1651). All values are of this rank's patches, in the frames of
/// their bodies.
template <int Dim>
class RecycledDirections {
 public:
  /// Impulses on patches [N s; per unit depth in the plane] and by how much they reduced the slip [m/s].
  struct Direction {
    Points<Dim> impulses, responses;
  };
  static constexpr std::size_t most = 10;

  /// The overlaps, which filter slips, stay alive.
  RecycledDirections(MPI_Comm comm, const OverlapInverse<Dim>& overlap) : comm_(comm), overlap_(overlap) {}

  /// Drops the oldest if there are too many. Collective.
  void add(Direction direction);
  /// The combination whose filtered responses come nearest to the filtered slips. Collective.
  Direction best_for(const Points<Dim>& slips) const;

  /// Registers them, of each patch impulse and response of one after the other. With other patches they begin anew.
  void register_state(StateList& state, PatchRange own, std::size_t patches);
  std::size_t size() const { return directions_.size(); }

 private:
  struct Filtered {
    Direction direction;
    Points<Dim> responses;  ///< filtered: means over the reach of a kernel
  };
  std::vector<double> weights_for(const Points<Dim>& slips) const;
  Points<Dim> stored(std::size_t patches) const;
  void restore(const Points<Dim>& stored);

  MPI_Comm comm_;
  const OverlapInverse<Dim>& overlap_;
  std::deque<Filtered> directions_;  ///< the last first
  std::size_t stored_size_ = 0;      ///< how many there are in what is restored
};

extern template class RecycledDirections<2>;
extern template class RecycledDirections<3>;

}  // namespace washfsi
