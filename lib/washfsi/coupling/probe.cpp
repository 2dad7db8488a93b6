// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/probe.hpp"

#include <algorithm>

#include "washfsi/grid/interpolate.hpp"

namespace washfsi {

template <int Dim>
Points<Dim> Probe<Dim>::sample(Vec local_velocity, Points<Dim> places) {
  constexpr double inside = 1e-9;  // of a cell
  for (auto& place : places) {
    place = grid_.folded(place);
    for (int d = 0; d < Dim; ++d) {
      const double margin = inside * grid_.spacing()[d];
      place[d] = std::clamp(place[d], grid_.lower()[d] + margin, grid_.upper()[d] - margin);
    }
  }
  exchange_.update(places);
  const ConstFaceView<Dim> u(grid_.wide_face_dm(), local_velocity);
  Points<Dim> velocities;
  for (const auto& place : exchange_.to_cells(places)) {
    Point<Dim> velocity;
    for (int c = 0; c < Dim; ++c) velocity[c] = interpolate_face<Dim>(grid_, u, place, c);
    velocities.push_back(velocity);
  }
  return exchange_.to_owners(velocities);
}

template class Probe<2>;
template class Probe<3>;

}  // namespace washfsi
