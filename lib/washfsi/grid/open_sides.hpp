// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/grid/outflow.hpp"

namespace washfsi {

/// The open sides of the box: the layers of velocities beyond them (`outflow.hpp`), shifted alike so that what flows
/// out balances what flows in through the other sides.
template <int Dim>
class OpenSides {
 public:
  OpenSides(const Grid<Dim>& grid, const Sides<Dim>& sides);

  bool empty() const { return layers_.empty(); }
  /// The velocity's component beyond a side that is open, at the place nearest to a face and a time [m/s]: the present
  /// value until the time of the last `start` or `accept`, the advanced one later.
  double operator()(int axis, End end, const Index<Dim>& face, int component, double time) const;

  /// Starts with the values inside, at `time`. `local_velocity` has wide ghosts; `flux` leaves the box through the
  /// other sides [m^Dim/s]. Collective.
  void start(Vec local_velocity, double flux, double time);
  /// Computes the values after a step of dt to `time`, at whose end the flux leaves through the other sides; the
  /// velocity is that at the start of the step, filled, with wide ghosts. May be repeated. Collective.
  void advance(Vec local_velocity, double flux, double time, double dt);
  /// Makes the advanced values the present ones.
  void accept();
  /// Registers the values.
  void register_state(StateList& state);

 private:
  void balance(double flux);

  const Grid<Dim>& grid_;
  std::vector<OutflowLayer<Dim>> layers_;
  double time_ = 0, next_time_ = 0;  ///< times of the present and the advanced values [s]
};

extern template class OpenSides<2>;
extern template class OpenSides<3>;

}  // namespace washfsi
