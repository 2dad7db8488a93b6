// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "washfsi/grid/open_sides.hpp"
#include "washfsi/grid/side_covers.hpp"
#include "washfsi/grid/side_faces.hpp"

namespace washfsi {

/// The velocities of the sides of the box: prescribed, carried out by the flow, or those of bodies that cover a side.
template <int Dim>
class SideVelocities {
 public:
  SideVelocities(const Grid<Dim>& grid, Sides<Dim> sides)
      : grid_(grid), sides_(std::move(sides)), open_(grid, sides_), covers_(grid, sides_) {}
  SideVelocities(const SideVelocities&) = delete;
  SideVelocities& operator=(const SideVelocities&) = delete;

  const Sides<Dim>& sides() const { return sides_; }
  OpenSides<Dim>& open() { return open_; }
  const OpenSides<Dim>& open() const { return open_; }
  SideCovers<Dim>& covers() { return covers_; }
  const SideCovers<Dim>& covers() const { return covers_; }

  /// The velocity's component at the place of a side next to a face: in it, or half a cell from it [m/s].
  double value(int axis, End end, const Index<Dim>& face, int component, double time) const;
  /// Calls use(values), values(face) being `value`; evaluates it once where it is the same on the whole side.
  template <class Use>
  void with_values(int axis, End end, int component, double time, Use&& use) const;

  /// The flux out of the box through the sides that are not open [m^Dim/s].
  struct Flux {
    double net, gross;  ///< sum, and sum of absolute values
  };
  /// Collective.
  Flux prescribed_flux(double time) const;
  /// Largest speed prescribed anywhere [m/s]. Collective.
  double largest_prescribed(double time) const;

 private:
  const Grid<Dim>& grid_;
  Sides<Dim> sides_;
  OpenSides<Dim> open_;
  SideCovers<Dim> covers_;
};

template <int Dim>
template <class Use>
void SideVelocities<Dim>::with_values(int axis, End end, int component, double time, Use&& use) const {
  const Side<Dim>& here = side_of<Dim>(sides_, axis, end);
  const bool varies = here.kind == BoundaryKind::outflow || here.motion || here.profile != InflowProfile::uniform;
  if (varies)
    use([&](const Index<Dim>& face) { return value(axis, end, face, component, time); });
  else if (const auto* cover = covers_.of(axis, end); cover && cover->moves() && component != axis)
    use(cover->velocities(component, time));
  else
    use([same = here.velocity[component]](const Index<Dim>&) { return same; });
}

extern template class SideVelocities<2>;
extern template class SideVelocities<3>;

}  // namespace washfsi
