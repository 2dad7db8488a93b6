// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "washfsi/grid/grid.hpp"
#include "washfsi/output/frame_folder.hpp"

namespace washfsi {

/// A field in this rank's cells, x fastest.
struct CellField {
  std::string name, unit;
  int components;
  std::vector<double> values;
};

/// slices.h5, slices.xdmf: the flow in the layers of cells in the middle of the box, as surfaces: for a grid in space
/// ParaView shows only the outline by default.
class SliceSeries {
 public:
  /// Collective.
  SliceSeries(const Grid<3>& grid, const std::string& folder, long restart_step);
  /// Stores the part of a field for the next frame.
  void take(const CellField& field);
  /// Writes a frame of the fields taken since the last one. Collective.
  void write(double time, long step);

 private:
  /// The layer across an axis.
  struct Plane {
    int axis;
    std::string name;  ///< names of the axes along it, "xy"
    PetscInt layer;    ///< the cells' index along `axis`
    Box<3> part;       ///< this rank's cells; none if `is_here` is false
    bool is_here;
  };
  /// The part of a field in each plane.
  struct Taken {
    std::string name, unit;
    int components;
    std::array<std::vector<double>, 3> values;
  };
  Slab slab(const Plane& plane, int components) const;
  std::vector<double> values_in(const Plane& plane, const CellField& field) const;
  void write_nodes(Hdf5File& file, const Plane& plane) const;
  std::vector<hsize_t> node_shape(const Plane& plane) const;
  std::string xdmf(const Plane& plane, const Frame& frame) const;

  const Grid<3>& grid_;
  std::vector<Plane> planes_;
  std::vector<Taken> taken_;
  FrameFolder frames_;
};

}  // namespace washfsi
