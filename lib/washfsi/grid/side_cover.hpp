// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// A place of a side as bodies that stand on it change it.
template <int Dim>
struct Covered {
  Point<Dim> velocity;  ///< velocity of the side there [m/s]
  double share;         ///< share of the bodies in it: 1 beneath one, 0 beside them
};

/// The cover of a no-slip side of the box by bodies, at two moments: the ends of the current step. It is stored for the
/// faces beside this rank's cells and ghosts. Bodies at rest are evaluated once.
template <int Dim>
class SideCover {
 public:
  /// The cover of a side at a moment, as functions.
  struct Cover {
    /// Cover at a place of the side, whose own velocity is given.
    using At = std::function<Covered<Dim>(const Point<Dim>& place, const Point<Dim>& own)>;
    At by_all, by_resting;
    std::function<double(const Point<Dim>& place)> to_moving;  ///< distance from the nearest moving body [m]
    double reach;  ///< distance from a body beyond which nothing is covered [m]
  };

  SideCover(const Grid<Dim>& grid, int axis, End end, const Point<Dim>& own);

  int axis() const { return axis_; }
  End end() const { return end_; }
  /// Whether a body stands on this rank's part at either moment.
  bool covers() const { return before_.covers || now_.covers; }
  /// Whether a moving body covers this rank's part at either moment.
  bool moves() const { return before_.moves || now_.moves; }
  /// Whether bodies cover all of this rank's part at both moments.
  bool covers_all() const { return before_.open_places == 0 && now_.open_places == 0; }
  /// Sets the later moment; the last one becomes the earlier. The first time both are the same.
  void set(double time, const Cover& cover);
  /// The velocity along the side, as a function of the face beside it.
  auto velocities(int component, double time) const {
    return [this, component, &moment = nearest(time)](const Index<Dim>& face) {
      return moment.velocities[number(face)][component];
    };
  }
  /// The bodies' share as a function of the face beside it.
  auto shares(int component, double time) const {
    return [this, component, &moment = nearest(time)](const Index<Dim>& face) {
      return moment.shares[number(face)][component];
    };
  }

 private:
  struct Moment {
    double time = 0;
    Points<Dim> velocities, shares;  ///< at each place of the plane, by component at that component's faces
    std::size_t open_places = 0;     ///< number of places not wholly covered
    bool covers = false, moves = false;
  };
  const Moment& nearest(double time) const {
    return std::abs(time - now_.time) <= std::abs(time - before_.time) ? now_ : before_;
  }
  std::size_t number(const Index<Dim>& face) const {
    PetscInt number = 0;
    for (int d = Dim; d-- > 0;)
      if (d != axis_) number = number * (plane_.upper[d] - plane_.lower[d]) + face[d] - plane_.lower[d];
    return static_cast<std::size_t>(number);
  }
  Point<Dim> on_side(Point<Dim> place) const;
  void find(Moment& moment, const Index<Dim>& face, const typename Cover::At& cover) const;
  Moment resting(const Cover& cover) const;

  const Grid<Dim>& grid_;
  int axis_;
  End end_;
  Point<Dim> own_;
  Box<Dim> plane_;  ///< one layer of the local faces along the side
  Moment resting_, before_, now_;
};

extern template class SideCover<2>;
extern template class SideCover<3>;

}  // namespace washfsi
