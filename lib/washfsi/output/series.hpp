// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/grid/boundary.hpp"
#include "washfsi/motion/body.hpp"
#include "washfsi/output/frame_folder.hpp"
#include "washfsi/output/slice_series.hpp"

namespace washfsi {

/// flow.h5, flow.xdmf: velocity, pressure and vorticity at cell centres; in space also their slices.
template <int Dim>
class FlowSeries {
 public:
  FlowSeries(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::string& folder, long restart_step);
  bool is_new() const { return frames_.is_new(); }
  /// Writes a frame, with further fields of cells, the same in each frame. Collective.
  void write(double time, long step, Vec velocity, Vec pressure, const std::vector<CellField>& further = {});

 private:
  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  FrameFolder frames_;
  std::optional<SliceSeries> slices_;
};

/// bodies.h5, bodies.xdmf: the signed distance [m] of each body at cell centres; its zero contour is the surface.
template <int Dim>
class BodySeries {
 public:
  BodySeries(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const std::string& folder, long restart_step);
  /// Collective.
  void write(double time, long step);

 private:
  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  FrameFolder frames_;
};

/// A number of each of this rank's markers, by name.
struct MarkerField {
  std::string name, unit;
  std::vector<double> values;
};

/// cloth.h5, cloth.xdmf: markers connected to cloths, with velocity, group and cloth numbers, and fields such as
/// stress.
template <int Dim>
class ClothSeries {
 public:
  ClothSeries(MPI_Comm comm, const Cloths<Dim>& cloths, const std::string& folder, long restart_step);
  /// Collective.
  void write(double time, long step, const Points<Dim>& positions, const Points<Dim>& velocities,
             const std::vector<MarkerField>& fields);

 private:
  struct Topology {
    std::vector<long long> entries;
    std::size_t elements = 0;
  };
  Topology topology() const;
  void write_constants(Hdf5File& file) const;

  MPI_Comm comm_;
  const Cloths<Dim>& cloths_;
  Topology topology_;
  FrameFolder frames_;
};

}  // namespace washfsi
