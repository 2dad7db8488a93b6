// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/grid/grid.hpp"
#include "washfsi/grid/side.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

/// The velocities just beyond an open side of the box, carried out by the convective condition
///   du/dt + u_adv du/dn = 0,   u_adv the mean outward velocity one cell inside, or 0 where that points inwards
/// (thesis 4.3.2; Kim, Kim and Choi, J. Comput. Phys. 171 (2001) 132). The scheme is upwind and implicit, hence bounded
/// for every step:
///   u_out^(n+1) = (u_out^n + Co u_inside^n)/(1 + Co),   Co = u_adv dt/h
/// The layer consists of the side's own faces for the normal component and of the first ghosts beyond the side for the
/// others. It exists on every rank that touches the side, ghosts along the side included.
template <int Dim>
class OutflowLayer {
 public:
  OutflowLayer(const Grid<Dim>& grid, int axis, End end);

  int axis() const { return axis_; }
  End end() const { return end_; }

  /// Starts with the nearest values inside. `local_velocity` has its ghosts filled along the side.
  void start(const ConstFaceView<Dim>& local_velocity);
  /// This rank's part of the outward flux one cell inside [m^Dim/s].
  double inner_flux(const ConstFaceView<Dim>& local_velocity) const;
  /// Computes the values a step later; `speed` is u_adv.
  void advance(const ConstFaceView<Dim>& local_velocity, double speed, double dt);
  /// This rank's part of the outward flux of the advanced values [m^Dim/s].
  double flux() const;
  /// Adds to the advanced values' outward velocity [m/s].
  void add_outward(double speed);
  /// Makes the advanced values the present ones.
  void accept() { now_ = next_; }

  /// Area of the whole side [m^(Dim-1)].
  double area() const;
  /// The value at the layer's place nearest to a face.
  double operator()(const Index<Dim>& face, int component, bool advanced) const;

  /// Registers the present values: in a file those beside owned cells, x first, components together.
  void register_state(StateList& state);

 private:
  Box<Dim> all_cells() const;
  std::vector<double> values() const;
  void set_values(const std::vector<double>& whole);
  std::size_t offset(const Box<Dim>& box, Index<Dim> cell, int component) const;
  Index<Dim> nearest_inside(const Index<Dim>& cell, int component) const;

  const Grid<Dim>& grid_;
  int axis_;
  End end_;
  Box<Dim> owned_;                  ///< cells beside the side
  Box<Dim> kept_;                   ///< these cells with ghosts along the side, as far as the box has cells there
  std::vector<double> now_, next_;  ///< present and advanced values in `kept_`
};

extern template class OutflowLayer<2>;
extern template class OutflowLayer<3>;

}  // namespace washfsi
