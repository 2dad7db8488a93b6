// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/side_velocities.hpp"

#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
double SideVelocities<Dim>::value(int axis, End end, const Index<Dim>& face, int component, double time) const {
  const Side<Dim>& here = side_of<Dim>(sides_, axis, end);
  if (here.kind == BoundaryKind::outflow) return open_(axis, end, face, component, time);
  const auto foot = [&] { return foot_on_side<Dim>(grid_, face, component, axis, end); };
  if (here.motion) return here.motion(foot(), time)[component];
  if (const auto* cover = covers_.of(axis, end); cover && cover->moves() && component != axis)
    return cover->velocities(component, time)(face);
  if (here.profile == InflowProfile::uniform) return here.velocity[component];
  return here.velocity[component] * parabola<Dim>(sides_, axis, grid_.lower(), grid_.upper(), foot());
}

template <int Dim>
typename SideVelocities<Dim>::Flux SideVelocities<Dim>::prescribed_flux(double time) const {
  std::vector<double> sums(2, 0.0);
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : both_ends) {
      if (!touches(grid_, axis, end) || side_of<Dim>(sides_, axis, end).kind == BoundaryKind::outflow) continue;
      const double area = grid_.cell_volume() / grid_.spacing()[axis];
      for_each_side_face(grid_, axis, end, grid_.owned(), [&](const Index<Dim>& face) {
        const double flux = area * value(axis, end, face, axis, time);
        sums[0] += end == End::lower ? -flux : flux;
        sums[1] += std::abs(flux);
      });
    }
  sums = ordered_sum(grid_.comm(), sums);
  return {sums[0], sums[1]};
}

template <int Dim>
double SideVelocities<Dim>::largest_prescribed(double time) const {
  double speed = 0;
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : both_ends) {
      const BoundaryKind kind = side_of<Dim>(sides_, axis, end).kind;
      if (!touches(grid_, axis, end) || kind == BoundaryKind::outflow) continue;
      for (int c = 0; c < Dim; ++c) {
        if (c != axis && kind == BoundaryKind::slip) continue;
        with_values(axis, end, c, time, [&](const auto& values) {
          for_each_side_face(grid_, axis, end, grid_.owned(),
                             [&](const Index<Dim>& face) { speed = std::max(speed, std::abs(values(face))); });
        });
      }
    }
  return largest(grid_.comm(), speed);
}

template class SideVelocities<2>;
template class SideVelocities<3>;

}  // namespace washfsi
