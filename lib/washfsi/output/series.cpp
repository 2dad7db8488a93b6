// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/series.hpp"

#include "washfsi/grid/field_slab.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

// The grid's corner and spacing, for readers other than ParaView.
template <int Dim>
FrameFolder::Attributes attributes_of(const Grid<Dim>& grid) {
  FrameFolder::Attributes attributes;
  for (int d = 0; d < Dim; ++d) {
    const std::string axis(1, "xyz"[d]);
    attributes.emplace_back("lower_" + axis, grid.lower()[d]);
    attributes.emplace_back("spacing_" + axis, grid.spacing()[d]);
  }
  return attributes;
}

template <int Dim>
std::vector<std::string> nodes() {
  return Dim == 2 ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{};
}

// The places of the nodes of a plane grid, along each axis. ParaView reads no cells' values on a plane that is one
// layer of nodes of a regular grid in space, and puts a regular grid in the plane into the y,z plane.
template <int Dim>
void write_nodes(const Grid<Dim>& grid, const FrameFolder& frames) {
  if constexpr (Dim == 2)
    frames.write_constants([&](Hdf5File& file) {
      for (int d = 0; d < Dim; ++d) {
        std::vector<double> nodes;
        for (PetscInt n = 0; n <= grid.cells()[d]; ++n) nodes.push_back(grid.lower()[d] + n * grid.spacing()[d]);
        const bool writes = rank_of(grid.comm()) == 0;  // for all ranks
        file.write(d == 0 ? "/x" : "/y", {{nodes.size()}, {0}, {writes ? nodes.size() : 0}}, nodes);
      }
    });
}

// XDMF text of the grid of cells, slowest axis first: in space by counts of nodes, origin and spacing.
template <int Dim>
std::string xdmf_mesh(const Grid<Dim>& grid, const FrameFolder& frames) {
  std::vector<std::string> nodes, origin, spacing;
  for (int d = Dim; d-- > 0;) {
    nodes.push_back(std::to_string(grid.cells()[d] + 1));
    origin.push_back(to_text(grid.lower()[d]));
    spacing.push_back(to_text(grid.spacing()[d]));
  }
  const std::string counts = " Dimensions=\"" + join(nodes, " ") + "\"/>\n";
  if constexpr (Dim == 2) {
    const auto size = [&](int d) { return std::vector<hsize_t>{static_cast<hsize_t>(grid.cells()[d] + 1)}; };
    return "<Topology TopologyType=\"2DRectMesh\"" + counts + "<Geometry GeometryType=\"VXVY\">\n" +
           frames.constant_item("/x", size(0)) + frames.constant_item("/y", size(1)) + "</Geometry>\n";
  } else {
    const std::string item = "<DataItem Format=\"XML\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"3\">";
    return "<Topology TopologyType=\"3DCoRectMesh\"" + counts + "<Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n" + item +
           join(origin, " ") + "</DataItem>\n" + item + join(spacing, " ") + "</DataItem>\n</Geometry>\n";
  }
}

/// The velocity at cell centres.
template <int Dim>
class CentredVelocity {
 public:
  CentredVelocity(const Grid<Dim>& grid, const Boundary<Dim>& boundary, Vec face_velocity, double time)
      : grid_(grid), local_(boundary, grid.face_dm(), face_velocity, time), u_(grid.face_dm(), local_) {}

  /// The velocity with three components.
  CellField field() const {
    return of_cells({"velocity", "m/s", 3, {}}, [&](const Index<Dim>& cell, std::vector<double>& values) {
      for (int c = 0; c < 3; ++c) values.push_back(c < Dim ? at(cell, c) : 0.0);
    });
  }
  /// The vorticity by central differences.
  CellField vorticity() const {
    return of_cells({"vorticity", "1/s", Dim == 2 ? 1 : 3, {}},
                    [&](const Index<Dim>& cell, std::vector<double>& values) {
                      if constexpr (Dim == 3) {
                        values.push_back(slope(cell, 2, 1) - slope(cell, 1, 2));
                        values.push_back(slope(cell, 0, 2) - slope(cell, 2, 0));
                      }
                      values.push_back(slope(cell, 1, 0) - slope(cell, 0, 1));
                    });
  }

 private:
  template <class Add>
  CellField of_cells(CellField field, const Add& add) const {
    field.values.reserve(grid_.owned().count() * static_cast<std::size_t>(field.components));
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) { add(cell, field.values); });
    return field;
  }
  double at(const Index<Dim>& cell, int c) const { return 0.5 * (u_(cell, c) + u_(shifted<Dim>(cell, c, 1), c)); }
  double slope(const Index<Dim>& cell, int c, int d) const {
    return (at(shifted<Dim>(cell, d, 1), c) - at(shifted<Dim>(cell, d, -1), c)) / (2 * grid_.spacing()[d]);
  }

  const Grid<Dim>& grid_;
  GhostedVelocity<Dim> local_;
  ConstFaceView<Dim> u_;
};

template <int Dim>
CellField pressure_field(const Grid<Dim>& grid, Vec pressure) {
  CellField field{"pressure", "Pa", 1, {}};
  const ConstCellView<Dim> p(grid.cell_dm(), pressure);
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) { field.values.push_back(p(cell)); });
  return field;
}

}  // namespace

template <int Dim>
FlowSeries<Dim>::FlowSeries(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::string& folder,
                            long restart_step)
    : grid_(grid),
      boundary_(boundary),
      frames_(grid.comm(), folder, "flow", restart_step, attributes_of(grid), nodes<Dim>()) {
  write_nodes(grid, frames_);
  if constexpr (Dim == 3) slices_.emplace(grid, folder, restart_step);
}

template <int Dim>
void FlowSeries<Dim>::write(double time, long step, Vec velocity, Vec pressure, const std::vector<CellField>& further) {
  const petsc::LogPart part("output");
  std::vector<CellField> written;  // without their values: there is one field at a time
  frames_.add(
      time, step,
      [&](Hdf5File& file) {
        const auto write = [&](const CellField& field) {
          write_with_unit(file, "/" + field.name, field.unit, field_slab(grid_, field.components), field.values);
          if (slices_) slices_->take(field);
          written.push_back({field.name, field.unit, field.components, {}});
        };
        const CentredVelocity<Dim> centred(grid_, boundary_, velocity, time);
        write(centred.field());
        write(pressure_field(grid_, pressure));
        write(centred.vorticity());
        for (const CellField& field : further) write(field);
      },
      [&](const Frame& frame) {
        std::string text = xdmf_mesh(grid_, frames_);
        for (const CellField& field : written)
          text +=
              xdmf_attribute(field.name, field.components == 1 ? "Scalar" : "Vector", "Cell",
                             frames_.frame_item(frame, "/" + field.name, field_slab(grid_, field.components).shape));
        return text;
      });
  if (slices_) slices_->write(time, step);
}

template <int Dim>
BodySeries<Dim>::BodySeries(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const std::string& folder,
                            long restart_step)
    : grid_(grid),
      bodies_(bodies),
      frames_(grid.comm(), folder, "bodies", restart_step, attributes_of(grid), nodes<Dim>()) {
  write_nodes(grid, frames_);
}

template <int Dim>
void BodySeries<Dim>::write(double time, long step) {
  const petsc::LogPart part("output");
  const Slab scalar = field_slab(grid_, 1);
  frames_.add(
      time, step,
      [&](Hdf5File& file) {
        const PosedBodies<Dim> posed(bodies_, time);
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
          std::vector<double> distances;
          for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
            distances.push_back(posed.distance(b, grid_.cell_center(cell)));
          });
          write_with_unit(file, "/" + bodies_[b].name, "m", scalar, distances);
        }
      },
      [&](const Frame& frame) {
        std::string text = xdmf_mesh(grid_, frames_);
        for (const auto& body : bodies_)
          text += xdmf_attribute(body.name, "Scalar", "Cell", frames_.frame_item(frame, "/" + body.name, scalar.shape));
        return text;
      });
}

template <int Dim>
ClothSeries<Dim>::ClothSeries(MPI_Comm comm, const Cloths<Dim>& cloths, const std::string& folder, long restart_step)
    : comm_(comm),
      cloths_(cloths),
      topology_(topology()),
      frames_(comm, folder, "cloth", restart_step, {}, {"topology", "group", "cloth"}) {
  frames_.write_constants([&](Hdf5File& file) { write_constants(file); });
}

// XDMF's mixed topology: a polyline (type 2, number of markers, markers) for each fibre, a quadrilateral (type 5, its
// four markers) for each quad of a sheet.
template <int Dim>
typename ClothSeries<Dim>::Topology ClothSeries<Dim>::topology() const {
  Topology topology;
  for (const Piece& piece : cloths_.pieces()) {
    if (cloths_.groups()[piece.group].markers[1] == 1) {
      topology.entries.insert(topology.entries.end(), {2, piece.count});
      for (PetscInt k = 0; k < piece.count; ++k) topology.entries.push_back(piece.first + k);
      ++topology.elements;
      continue;
    }
    for (const auto& quad : cloths_.quads(piece)) {
      topology.entries.push_back(5);
      topology.entries.insert(topology.entries.end(), quad.begin(), quad.end());
      ++topology.elements;
    }
  }
  return topology;
}

template <int Dim>
void ClothSeries<Dim>::write_constants(Hdf5File& file) const {
  const hsize_t size = topology_.entries.size();
  const bool writes = rank_of(comm_) == 0;  // for all ranks
  file.write("/topology", {{size}, {0}, {writes ? size : 0}}, topology_.entries);
  std::vector<double> group, cloth;
  for (const std::size_t piece : cloths_.piece_of_marker()) {
    group.push_back(static_cast<double>(cloths_.pieces()[piece].group));
    cloth.push_back(static_cast<double>(piece));
  }
  const Slab markers = cloths_.slab(1);
  file.write("/group", markers, group);
  std::vector<std::string> names;
  for (const auto& of_group : cloths_.groups()) names.push_back(of_group.name);
  file.set_text("/group", "names", join(names, ","));
  file.write("/cloth", markers, cloth);
}

template <int Dim>
void ClothSeries<Dim>::write(double time, long step, const Points<Dim>& positions, const Points<Dim>& velocities,
                             const std::vector<MarkerField>& fields) {
  const petsc::LogPart part("output");
  const Slab vector = cloths_.slab(3);
  const Slab scalar = cloths_.slab(1);
  frames_.add(
      time, step,
      [&](Hdf5File& file) {
        write_with_unit(file, "/position", "m", vector, flattened<Dim>(positions, 3));
        write_with_unit(file, "/velocity", "m/s", vector, flattened<Dim>(velocities, 3));
        for (const MarkerField& field : fields)
          write_with_unit(file, "/" + field.name, field.unit, scalar, field.values);
      },
      [&](const Frame& frame) {
        const auto item = [&](const std::string& dataset, const Slab& slab) {
          return frames_.frame_item(frame, dataset, slab.shape);
        };
        std::string attributes = xdmf_attribute("velocity", "Vector", "Node", item("/velocity", vector));
        for (const MarkerField& field : fields)
          attributes += xdmf_attribute(field.name, "Scalar", "Node", item("/" + field.name, scalar));
        for (const char* name : {"group", "cloth"})
          attributes +=
              xdmf_attribute(name, "Scalar", "Node", frames_.constant_item(std::string("/") + name, scalar.shape));
        return "<Topology TopologyType=\"Mixed\" NumberOfElements=\"" + std::to_string(topology_.elements) + "\">\n" +
               frames_.constant_item("/topology", {topology_.entries.size()}, "NumberType=\"Int\" Precision=\"8\"") +
               "</Topology>\n<Geometry GeometryType=\"XYZ\">\n" + item("/position", vector) + "</Geometry>\n" +
               attributes;
      });
}

template class FlowSeries<2>;
template class FlowSeries<3>;
template class BodySeries<2>;
template class BodySeries<3>;
template class ClothSeries<2>;
template class ClothSeries<3>;

}  // namespace washfsi
