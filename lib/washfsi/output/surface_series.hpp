// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/grid/grid.hpp"
#include "washfsi/motion/body.hpp"
#include "washfsi/output/frame_folder.hpp"

namespace washfsi {

/// surfaces.h5, surfaces.xdmf: the bodies' surfaces as triangles, in the plane lines, with the number of the body.
/// Found once, where the bodies are at t = 0, within the box; then they move. Of a body that repeats itself the image
/// is shown whose middle lies in the box, all of it. A restart goes on with the series if they are joined as before.
template <int Dim>
class SurfaceSeries {
 public:
  /// Collective.
  SurfaceSeries(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const std::string& folder,
                long restart_step);
  /// Collective.
  void write(double time, long step);

 private:
  /// Of all bodies, on rank 0; others have none of it.
  struct Surfaces {
    Points<Dim> vertices;           ///< in the frame of their body [m]
    std::vector<double> owner;      ///< the number of the body of each
    std::vector<long long> facets;  ///< their vertices, `Dim` each
  };
  static Surfaces find(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies);
  Pose<Dim> shown(const Body<Dim>& body, double time) const;
  bool are_joined_as_in(const std::string& folder) const;
  Slab slab(hsize_t rows, hsize_t columns) const;
  void write_constants() const;

  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  Surfaces surfaces_;
  Slab scalar_, vector_, topology_;
  FrameFolder frames_;
};

}  // namespace washfsi
