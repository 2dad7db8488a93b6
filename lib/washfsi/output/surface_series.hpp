// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/body/body.hpp"
#include "washfsi/grid/grid.hpp"
#include "washfsi/output/frame_folder.hpp"

namespace washfsi {

/// surfaces.h5, surfaces.xdmf: the bodies' surfaces as triangles, in the plane lines, with the number of the body.
/// Found once, where the bodies are at t = 0, within the box; then they move.
template <int Dim>
class SurfaceSeries {
 public:
  /// Collective.
  SurfaceSeries(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const std::string& folder,
                long restart_step);
  /// Collective.
  void write(double time, long step);

 private:
  void find_surfaces();
  void share();
  void write_constants() const;

  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  Points<Dim> vertices_;            ///< of this rank, in the frame of their body [m]
  std::vector<std::size_t> owner_;  ///< the body of each
  std::vector<long long> facets_;   ///< of this rank: the vertices, by their numbers among those of all ranks
  Slab scalar_, vector_, topology_;
  FrameFolder frames_;
};

}  // namespace washfsi
