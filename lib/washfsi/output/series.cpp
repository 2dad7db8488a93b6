// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/series.hpp"

#include "washfsi/output/field_slab.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

// The grid's corner and spacing as attributes of the file, for readers other than ParaView.
template <int Dim>
void write_grid_attributes(const Grid<Dim>& grid, const FrameFile& frames) {
  Hdf5File file = frames.open();
  for (int d = 0; d < Dim; ++d) {
    const std::string axis(1, "xyz"[d]);
    file.set_attribute("/", "lower_" + axis, grid.lower()[d]);
    file.set_attribute("/", "spacing_" + axis, grid.spacing()[d]);
  }
  file.close();
}

// XDMF text of the grid of cells: counts of nodes, origin and spacing, slowest axis first. A plane is one layer of
// nodes in three dimensions: ParaView puts two-dimensional meshes into the y,z plane.
template <int Dim>
std::string xdmf_mesh(const Grid<Dim>& grid) {
  std::vector<std::string> nodes, origin, spacing;
  for (int d = 3; d-- > 0;) {
    nodes.push_back(std::to_string(d < Dim ? grid.cells()[d] + 1 : 1));
    origin.push_back(d < Dim ? to_text(grid.lower()[d]) : "0");
    spacing.push_back(d < Dim ? to_text(grid.spacing()[d]) : "1");
  }
  const std::string item = "<DataItem Format=\"XML\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"3\">";
  return "<Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"" + join(nodes, " ") + "\"/>\n" +
         "<Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n" + item + join(origin, " ") + "</DataItem>\n" + item +
         join(spacing, " ") + "</DataItem>\n</Geometry>\n";
}

/// Velocity at cell centres with three components, and the curl of it by central differences.
template <int Dim>
struct CentredFlow {
  std::vector<double> velocity, vorticity;

  CentredFlow(const Grid<Dim>& grid, const Boundary<Dim>& boundary, Vec face_velocity, double time) {
    const GhostedVelocity<Dim> local(boundary, grid.face_dm(), face_velocity, time);
    const ConstFaceView<Dim> u(grid.face_dm(), local);
    const auto centred = [&](const Index<Dim>& cell, int c) {
      return 0.5 * (u(cell, c) + u(shifted<Dim>(cell, c, 1), c));
    };
    const auto slope = [&](const Index<Dim>& cell, int c, int d) {
      return (centred(shifted<Dim>(cell, d, 1), c) - centred(shifted<Dim>(cell, d, -1), c)) / (2 * grid.spacing()[d]);
    };
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
      for (int c = 0; c < 3; ++c) velocity.push_back(c < Dim ? centred(cell, c) : 0.0);
      if constexpr (Dim == 3) {
        vorticity.push_back(slope(cell, 2, 1) - slope(cell, 1, 2));
        vorticity.push_back(slope(cell, 0, 2) - slope(cell, 2, 0));
      }
      vorticity.push_back(slope(cell, 1, 0) - slope(cell, 0, 1));
    });
  }
};

}  // namespace

template <int Dim>
FlowSeries<Dim>::FlowSeries(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::string& folder,
                            long restart_step)
    : grid_(grid), boundary_(boundary), file_(grid.comm(), folder, "flow", restart_step) {
  if (file_.is_new()) write_grid_attributes(grid, file_);
}

template <int Dim>
void FlowSeries<Dim>::write(double time, long step, Vec velocity, Vec pressure) {
  const petsc::LogPart part("output");
  const CentredFlow<Dim> flow(grid_, boundary_, velocity, time);
  std::vector<double> p;
  {
    const ConstCellView<Dim> view(grid_.cell_dm(), pressure);
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) { p.push_back(view(cell)); });
  }
  constexpr int curl_components = Dim == 2 ? 1 : 3;
  const Slab vector = field_slab(grid_, 3), scalar = field_slab(grid_, 1), curl = field_slab(grid_, curl_components);
  file_.add(
      time, step,
      [&](Hdf5File& file, const std::string& group) {
        file.write(group + "/velocity", vector, flow.velocity);
        file.write(group + "/pressure", scalar, p);
        file.write(group + "/vorticity", curl, flow.vorticity);
      },
      [&](const Frame& frame) {
        const auto item = [&](const char* name, const Slab& slab) {
          return xdmf_data_item("flow", frame.group + "/" + name, slab.shape);
        };
        return xdmf_mesh(grid_) + xdmf_attribute("velocity", "Vector", "Cell", item("velocity", vector)) +
               xdmf_attribute("pressure", "Scalar", "Cell", item("pressure", scalar)) +
               xdmf_attribute("vorticity", Dim == 2 ? "Scalar" : "Vector", "Cell", item("vorticity", curl));
      });
}

template <int Dim>
BodySeries<Dim>::BodySeries(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const std::string& folder,
                            long restart_step)
    : grid_(grid), bodies_(bodies), file_(grid.comm(), folder, "bodies", restart_step) {
  if (file_.is_new()) write_grid_attributes(grid, file_);
}

template <int Dim>
void BodySeries<Dim>::write(double time, long step) {
  const petsc::LogPart part("output");
  const Slab scalar = field_slab(grid_, 1);
  file_.add(
      time, step,
      [&](Hdf5File& file, const std::string& group) {
        for (const auto& body : bodies_) {
          std::vector<double> distance;
          for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
            distance.push_back(body.distance(grid_.cell_center(cell), time));
          });
          file.write(group + "/" + body.name, scalar, distance);
        }
      },
      [&](const Frame& frame) {
        std::string text = xdmf_mesh(grid_);
        for (const auto& body : bodies_)
          text += xdmf_attribute(body.name, "Scalar", "Cell",
                                 xdmf_data_item("bodies", frame.group + "/" + body.name, scalar.shape));
        return text;
      });
}

template <int Dim>
ClothSeries<Dim>::ClothSeries(MPI_Comm comm, const Cloths<Dim>& cloths, const std::string& folder, long restart_step)
    : comm_(comm), cloths_(cloths), file_(comm, folder, "cloth", restart_step) {
  if (file_.is_new()) write_topology();
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
void ClothSeries<Dim>::write_topology() {
  Hdf5File file = file_.open();
  std::vector<long long> entries = topology().entries;
  Slab slab{{entries.size()}, {0}, {entries.size()}};
  if (rank_of(comm_) != 0) slab.count = {0};  // rank 0 writes for all
  file.write("/topology", slab, entries);
  std::vector<double> group, cloth;
  for (const std::size_t piece : cloths_.piece_of_marker()) {
    group.push_back(static_cast<double>(cloths_.pieces()[piece].group));
    cloth.push_back(static_cast<double>(piece));
  }
  const Slab markers = marker_slab(cloths_.marker_count(), cloths_.begin(), cloths_.end(), 1);
  file.write("/group", markers, group);
  file.write("/cloth", markers, cloth);
  file.close();
}

template <int Dim>
void ClothSeries<Dim>::write(double time, long step, const Points<Dim>& positions, const Points<Dim>& velocities,
                             const std::vector<MarkerField>& fields) {
  const petsc::LogPart part("output");
  const Slab vector = marker_slab(cloths_.marker_count(), cloths_.begin(), cloths_.end(), 3);
  const Slab scalar = marker_slab(cloths_.marker_count(), cloths_.begin(), cloths_.end(), 1);
  file_.add(
      time, step,
      [&](Hdf5File& file, const std::string& group) {
        file.write(group + "/position", vector, flattened<Dim>(positions, 3));
        file.write(group + "/velocity", vector, flattened<Dim>(velocities, 3));
        for (const MarkerField& field : fields) file.write(group + "/" + field.name, scalar, field.values);
      },
      [&](const Frame& frame) {
        const auto item = [&](const std::string& dataset, const Slab& slab) {
          return xdmf_data_item("cloth", dataset, slab.shape);
        };
        const Topology mesh = topology();
        std::string attributes;
        for (const MarkerField& field : fields)
          attributes += xdmf_attribute(field.name, "Scalar", "Node", item(frame.group + "/" + field.name, scalar));
        return "<Topology TopologyType=\"Mixed\" NumberOfElements=\"" + std::to_string(mesh.elements) + "\">\n" +
               xdmf_data_item("cloth", "/topology", {mesh.entries.size()}, "NumberType=\"Int\" Precision=\"8\"") +
               "</Topology>\n<Geometry GeometryType=\"XYZ\">\n" + item(frame.group + "/position", vector) +
               "</Geometry>\n" + xdmf_attribute("velocity", "Vector", "Node", item(frame.group + "/velocity", vector)) +
               attributes + xdmf_attribute("group", "Scalar", "Node", item("/group", scalar)) +
               xdmf_attribute("cloth", "Scalar", "Node", item("/cloth", scalar));
      });
}

template class FlowSeries<2>;
template class FlowSeries<3>;
template class BodySeries<2>;
template class BodySeries<3>;
template class ClothSeries<2>;
template class ClothSeries<3>;

}  // namespace washfsi
