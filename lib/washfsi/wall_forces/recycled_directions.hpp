// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "washfsi/support/state_list.hpp"
#include "washfsi/wall_forces/overlap_inverse.hpp"

namespace washfsi {

/// The responses of the water to the last slip corrections, including the pressure. Corrections of successive steps are
/// similar, so that a combination of them is near to the present one, and its response is known without a projection.
/// So Krylov methods recycle directions for sequences of linear systems (Parks, de Sturler, Mackey, Johnson and Maiti,
/// SIAM J. Sci. Comput. 28 (2006) 1651). All values are of this rank's patches, in the frames of their bodies.
template <int Dim>
class RecycledDirections {
 public:
  /// Impulses on patches [N s; per unit depth in the plane] and their responses: the reductions of slip [m/s].
  struct Direction {
    Points<Dim> impulses, responses;
  };
  static constexpr std::size_t most = 10;

  /// The overlaps, which filter slips, stay alive.
  RecycledDirections(MPI_Comm comm, const OverlapInverse<Dim>& overlap) : comm_(comm), overlap_(overlap) {}

  /// Adds a direction and drops the oldest if there are more than `most`. Collective.
  void add(Direction direction);
  /// The combination whose filtered responses are nearest to the filtered slips. Collective.
  Direction best_for(const Points<Dim>& slips) const;

  /// Registers the directions: for each patch, impulse and response of each in turn. With other patches the list is
  /// emptied.
  void register_state(StateList& state, PatchRange own, std::size_t patches);
  std::size_t size() const { return directions_.size(); }

 private:
  struct Filtered {
    Direction direction;
    Points<Dim> responses;  ///< filtered responses: means over the reach of a kernel
  };
  std::vector<double> weights_for(const Points<Dim>& slips) const;
  Points<Dim> stored(std::size_t patches) const;
  void restore(const Points<Dim>& stored);

  MPI_Comm comm_;
  const OverlapInverse<Dim>& overlap_;
  std::deque<Filtered> directions_;  ///< newest first
  std::size_t stored_size_ = 0;      ///< number of directions in a restored checkpoint
};

extern template class RecycledDirections<2>;
extern template class RecycledDirections<3>;

}  // namespace washfsi
