// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// slices.h5, slices.xdmf: the flow in the layers of cells in the middle of the box, as surfaces: of a grid in space
/// ParaView shows no more than the outline until it is told to.
class SliceSeries {
 public:
  /// Collective.
  SliceSeries(const Grid<3>& grid, const std::string& folder, long restart_step);
  /// Collective.
  void write(double time, long step, const std::vector<CellField>& fields);

 private:
  /// The layer across an axis.
  struct Plane {
    int axis;
    std::string name;  ///< of the axes along it, "xy"
    PetscInt layer;    ///< the cells' index along `axis`
    Box<3> part;       ///< this rank's cells; none if `is_here` is false
    bool is_here;
  };
  Slab slab(const Plane& plane, int components) const;
  std::vector<double> values_in(const Plane& plane, const CellField& field) const;
  void write_nodes(Hdf5File& file, const Plane& plane) const;
  std::vector<hsize_t> node_shape(const Plane& plane) const;
  std::string xdmf(const Plane& plane, const Frame& frame, const std::vector<CellField>& fields) const;

  const Grid<3>& grid_;
  std::vector<Plane> planes_;
  FrameFolder frames_;
};

}  // namespace washfsi
