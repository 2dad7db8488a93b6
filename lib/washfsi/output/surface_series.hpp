// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/grid/grid.hpp"
#include "washfsi/motion/body.hpp"
#include "washfsi/output/frame_folder.hpp"

namespace washfsi {

/// surfaces.h5, surfaces.xdmf: the bodies' surfaces as triangles, in the plane lines, with the number of the body.
/// Found once within the box, with the bodies as at t = 0; then they move. A periodic body is shown as the image whose
/// middle lies in the box, completely. A restart continues the series if the connectivity is unchanged.
template <int Dim>
class SurfaceSeries {
 public:
  /// Collective.
  SurfaceSeries(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const std::string& folder,
                long restart_step);
  /// Collective.
  void write(double time, long step);

 private:
  /// The surfaces of all bodies on rank 0; empty on other ranks.
  struct Surfaces {
    Points<Dim> vertices;           ///< vertices in the frame of their body [m]
    std::vector<double> owner;      ///< number of the body of each vertex
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
