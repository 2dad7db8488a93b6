// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/surface_series.hpp"

#include <cmath>

#include "washfsi/grid/field_slab.hpp"
#include "washfsi/shapes/zero_surface.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

template <int Dim>
SurfaceSeries<Dim>::SurfaceSeries(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies,
                                  const std::string& folder, long restart_step)
    : grid_(grid),
      bodies_(bodies),
      surfaces_(find(grid, bodies)),
      scalar_(slab(surfaces_.vertices.size(), 1)),
      vector_(slab(surfaces_.vertices.size(), 3)),
      topology_(slab(surfaces_.facets.size() / Dim, Dim)),
      frames_(grid.comm(), folder, "surfaces", are_joined_as_in(folder) ? restart_step : -1, {}, {"topology", "body"}) {
  write_constants();
}

template <int Dim>
typename SurfaceSeries<Dim>::Surfaces SurfaceSeries<Dim>::find(const Grid<Dim>& grid,
                                                               const std::vector<Body<Dim>>& bodies) {
  Surfaces found;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const PosedBody<Dim> body = bodies[b].at(0);
    const auto mesh = zero_surface<Dim>(grid, [&](const Point<Dim>& place) { return body.distance(place); });
    for (const auto& facet : mesh.facets)
      for (const std::size_t vertex : facet)
        found.facets.push_back(static_cast<long long>(found.vertices.size() + vertex));
    for (const auto& vertex : mesh.vertices) {  // of its images in the box, as one body
      Point<Dim> own = body.beside(vertex);
      for (int d = 0; d < Dim; ++d)
        if (bodies[b].repeats.spans(d)) own[d] = vertex[d];
      found.vertices.push_back(body.pose().in_body_frame(own));
    }
    found.owner.resize(found.vertices.size(), static_cast<double>(b));
  }
  return found;
}

// Moves a body's vertices to the image whose middle lies in the box.
template <int Dim>
Pose<Dim> SurfaceSeries<Dim>::shown(const Body<Dim>& body, double time) const {
  Pose<Dim> pose = body.motion.pose(time);
  const Extent<Dim> extent = body.repeats.extent.in_space(pose);
  const Point<Dim> start = body.motion.center_at(0);
  for (int d = 0; d < Dim; ++d) {
    const double period = body.repeats.period[d];
    if (period == 0) continue;
    const double beyond = body.repeats.spans(d)
                              ? pose.center[d] - start[d] + 0.5 * period
                              : 0.5 * (extent.bounds.lower[d] + extent.bounds.upper[d]) - grid_.lower()[d];
    pose.center[d] -= period * std::floor(beyond / period);
  }
  return pose;
}

// The slab of a dataset of which rank 0 has all rows.
template <int Dim>
Slab SurfaceSeries<Dim>::slab(hsize_t rows, hsize_t columns) const {
  const auto all = static_cast<hsize_t>(ordered_sum(grid_.comm(), static_cast<double>(rows)));
  if (columns == 1) return {{all}, {0}, {rows}};
  return {{all, columns}, {0, 0}, {rows, rows == 0 ? 0 : columns}};
}

// Whether the frames in a folder have these facets; their places may differ.
template <int Dim>
bool SurfaceSeries<Dim>::are_joined_as_in(const std::string& folder) const {
  const auto same = [&] {
    try {
      Hdf5File constants(MPI_COMM_SELF, folder + "/surfaces/constants.h5", Hdf5File::Mode::read);
      return constants.read("/topology", topology_) ==
                 std::vector<double>(surfaces_.facets.begin(), surfaces_.facets.end()) &&
             constants.read("/body", scalar_) == surfaces_.owner;
    } catch (const InputError&) {  // there are no facets, or they have another shape
      return false;
    }
  };
  return any_rank(grid_.comm(), rank_of(grid_.comm()) == 0 && same());
}

template <int Dim>
void SurfaceSeries<Dim>::write_constants() const {
  if (topology_.shape[0] == 0) return;  // no body's surface is in the box
  frames_.write_constants([&](Hdf5File& file) {
    file.write("/topology", topology_, surfaces_.facets);
    file.write("/body", scalar_, surfaces_.owner);
    std::vector<std::string> names;
    for (const auto& body : bodies_) names.push_back(body.name);
    file.set_text("/body", "names", join(names, ","));
  });
}

template <int Dim>
void SurfaceSeries<Dim>::write(double time, long step) {
  if (topology_.shape[0] == 0) return;
  const petsc::LogPart part("output");
  std::vector<Pose<Dim>> poses;
  for (const auto& body : bodies_) poses.push_back(shown(body, time));
  Points<Dim> places;
  for (std::size_t v = 0; v < surfaces_.vertices.size(); ++v)
    places.push_back(poses[static_cast<std::size_t>(surfaces_.owner[v])].in_space(surfaces_.vertices[v]));
  frames_.add(
      time, step, [&](Hdf5File& file) { write_with_unit(file, "/position", "m", vector_, flattened<Dim>(places, 3)); },
      [&](const Frame& frame) {
        const std::string type = Dim == 2 ? "Polyline\" NodesPerElement=\"2" : "Triangle";
        return "<Topology TopologyType=\"" + type + "\" NumberOfElements=\"" + std::to_string(topology_.shape[0]) +
               "\">\n" + frames_.constant_item("/topology", topology_.shape, "NumberType=\"Int\" Precision=\"8\"") +
               "</Topology>\n<Geometry GeometryType=\"XYZ\">\n" +
               frames_.frame_item(frame, "/position", vector_.shape) + "</Geometry>\n" +
               xdmf_attribute("body", "Scalar", "Node", frames_.constant_item("/body", scalar_.shape));
      });
}

template class SurfaceSeries<2>;
template class SurfaceSeries<3>;

}  // namespace washfsi
