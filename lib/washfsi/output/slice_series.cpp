// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/slice_series.hpp"

#include <array>

#include "washfsi/grid/field_slab.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr std::array names{"yz", "xz", "xy"};  // names of the planes across x, y and z

}  // namespace

SliceSeries::SliceSeries(const Grid<3>& grid, const std::string& folder, long restart_step)
    : grid_(grid), frames_(grid.comm(), folder, "slices", restart_step, {}, {names.begin(), names.end()}) {
  for (int axis = 0; axis < 3; ++axis) {
    Plane plane{axis, names[static_cast<std::size_t>(axis)], grid.cells()[axis] / 2, grid.owned(), false};
    plane.is_here = plane.part.lower[axis] <= plane.layer && plane.layer < plane.part.upper[axis];
    plane.part.lower[axis] = plane.layer;
    plane.part.upper[axis] = plane.layer + (plane.is_here ? 1 : 0);
    planes_.push_back(plane);
  }
  frames_.write_constants([&](Hdf5File& file) {
    for (const Plane& plane : planes_) write_nodes(file, plane);
  });
}

// This rank's part of a dataset of the plane, without the axis across it.
Slab SliceSeries::slab(const Plane& plane, int components) const {
  Slab slab = field_slab(grid_, components);
  for (auto* sizes : {&slab.shape, &slab.offset, &slab.count}) sizes->erase(sizes->begin() + (2 - plane.axis));
  if (!plane.is_here) slab.count.assign(slab.count.size(), 0);
  return slab;
}

std::vector<hsize_t> SliceSeries::node_shape(const Plane& plane) const {
  std::vector<hsize_t> shape = slab(plane, 3).shape;
  ++shape[0];
  ++shape[1];
  return shape;
}

// Writes the corners of a plane's cells, in the middle of the layer, on rank 0.
void SliceSeries::write_nodes(Hdf5File& file, const Plane& plane) const {
  Box<3> nodes{{}, shifted<3>(shifted<3>(shifted<3>(grid_.cells(), 0, 1), 1, 1), 2, 1)};
  nodes.lower[plane.axis] = plane.layer;
  nodes.upper[plane.axis] = plane.layer + 1;
  std::vector<double> places;
  const bool writes = rank_of(grid_.comm()) == 0;
  if (writes)
    for_each<3>(nodes, [&](const Index<3>& node) {
      for (int d = 0; d < 3; ++d) {
        const double middle = d == plane.axis ? 0.5 : 0.0;
        places.push_back(grid_.lower()[d] + (static_cast<double>(node[d]) + middle) * grid_.spacing()[d]);
      }
    });
  const std::vector<hsize_t> shape = node_shape(plane), none(shape.size(), 0);
  write_with_unit(file, "/" + plane.name + "/position", "m", {shape, none, writes ? shape : none}, places);
}

std::vector<double> SliceSeries::values_in(const Plane& plane, const CellField& field) const {
  const Box<3>& owned = grid_.owned();
  const auto width = [&](int d) { return static_cast<std::size_t>(owned.upper[d] - owned.lower[d]); };
  const auto along = [&](const Index<3>& cell, int d) { return static_cast<std::size_t>(cell[d] - owned.lower[d]); };
  const auto components = static_cast<std::size_t>(field.components);
  std::vector<double> values;
  for_each<3>(plane.part, [&](const Index<3>& cell) {
    const std::size_t place = (along(cell, 2) * width(1) + along(cell, 1)) * width(0) + along(cell, 0);
    for (std::size_t c = 0; c < components; ++c) values.push_back(field.values[place * components + c]);
  });
  return values;
}

std::string SliceSeries::xdmf(const Plane& plane, const Frame& frame) const {
  const std::vector<hsize_t> nodes = node_shape(plane);
  std::string text = "<Grid Name=\"" + plane.name + "\" GridType=\"Uniform\">\n<Topology TopologyType=\"2DSMesh\"" +
                     " Dimensions=\"" + std::to_string(nodes[0]) + " " + std::to_string(nodes[1]) +
                     "\"/>\n<Geometry GeometryType=\"XYZ\">\n" +
                     frames_.constant_item("/" + plane.name + "/position", nodes) + "</Geometry>\n";
  for (const Taken& field : taken_)
    text += xdmf_attribute(
        field.name, field.components == 1 ? "Scalar" : "Vector", "Cell",
        frames_.frame_item(frame, "/" + plane.name + "/" + field.name, slab(plane, field.components).shape));
  return text + "</Grid>\n";
}

void SliceSeries::take(const CellField& field) {
  Taken& taken = taken_.emplace_back(Taken{field.name, field.unit, field.components, {}});
  for (const Plane& plane : planes_) taken.values[static_cast<std::size_t>(plane.axis)] = values_in(plane, field);
}

void SliceSeries::write(double time, long step) {
  const auto write_fields = [&](Hdf5File& file) {
    for (const Plane& plane : planes_)
      for (const Taken& field : taken_)
        write_with_unit(file, "/" + plane.name + "/" + field.name, field.unit, slab(plane, field.components),
                        field.values[static_cast<std::size_t>(plane.axis)]);
  };
  const auto describe = [&](const Frame& frame) {
    std::string text;
    for (const Plane& plane : planes_) text += xdmf(plane, frame);
    return text;
  };
  frames_.add(time, step, write_fields, describe, FrameFolder::Parts::several);
  taken_.clear();
}

}  // namespace washfsi
