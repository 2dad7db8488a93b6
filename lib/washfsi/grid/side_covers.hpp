// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/grid/side.hpp"
#include "washfsi/grid/side_cover.hpp"

namespace washfsi {

/// The covers of the box's sides that are walls without a motion of their own, by bodies that stand on them: there a
/// side has the bodies' tangential velocity.
template <int Dim>
class SideCovers {
 public:
  /// The sides stay alive.
  SideCovers(const Grid<Dim>& grid, const Sides<Dim>& sides) : grid_(grid), sides_(sides) {}

  /// Sets the covers at `time` [s].
  void set(double time, const typename SideCover<Dim>::Cover& cover);
  /// Whether they have been set, as from the first step on; below, forgets them.
  bool are_known() const { return !covers_.empty(); }
  void forget() { covers_.clear(); }

  /// The cover of a side; null where no body stands on this rank's part of it.
  const SideCover<Dim>* of(int axis, End end) const;
  /// The share of bodies on a side at the place beside a face; 0 where none stands.
  double share(int axis, End end, const Index<Dim>& face, int component, double time) const;
  /// Whether bodies cover all of this rank's part of a side.
  bool cover_wholly(int axis, End end) const;

 private:
  const Grid<Dim>& grid_;
  const Sides<Dim>& sides_;
  std::vector<SideCover<Dim>> covers_;
};

extern template class SideCovers<2>;
extern template class SideCovers<3>;

}  // namespace washfsi
