// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/surface_series.hpp"

#include <numeric>

#include "washfsi/body/zero_surface.hpp"
#include "washfsi/output/field_slab.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

template <int Dim>
SurfaceSeries<Dim>::SurfaceSeries(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies,
                                  const std::string& folder, long restart_step)
    : grid_(grid), bodies_(bodies), frames_(grid.comm(), folder, "surfaces", restart_step, {}, {"topology", "body"}) {
  find_surfaces();
  share();
  write_constants();
}

template <int Dim>
void SurfaceSeries<Dim>::find_surfaces() {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto pose = bodies_[b].motion.pose(0);
    const auto mesh = zero_surface<Dim>(
        grid_, [&](const Point<Dim>& place) { return bodies_[b].shape->distance(pose.in_body_frame(place)); });
    for (const auto& facet : mesh.facets)
      for (const std::size_t vertex : facet) facets_.push_back(static_cast<long long>(vertices_.size() + vertex));
    for (const auto& vertex : mesh.vertices) vertices_.push_back(pose.in_body_frame(vertex));
    owner_.resize(vertices_.size(), b);
  }
}

// The numbers of this rank's vertices and facets among those of all.
template <int Dim>
void SurfaceSeries<Dim>::share() {
  const auto slab = [&](std::size_t own, hsize_t columns) {
    std::vector<double> counts(static_cast<std::size_t>(ranks_of(grid_.comm())), 0.0);
    const auto rank = static_cast<std::size_t>(rank_of(grid_.comm()));
    counts[rank] = static_cast<double>(own);
    counts = ordered_sum(grid_.comm(), counts);
    const auto first =
        static_cast<hsize_t>(std::accumulate(counts.begin(), counts.begin() + static_cast<long>(rank), 0.0));
    const auto all = static_cast<hsize_t>(std::accumulate(counts.begin(), counts.end(), 0.0));
    if (columns == 1) return Slab{{all}, {first}, {own}};
    return Slab{{all, columns}, {first, 0}, {own, own == 0 ? 0 : columns}};
  };
  scalar_ = slab(vertices_.size(), 1);
  vector_ = slab(vertices_.size(), 3);
  topology_ = slab(facets_.size() / Dim, Dim);
  for (long long& vertex : facets_) vertex += static_cast<long long>(scalar_.offset[0]);
}

template <int Dim>
void SurfaceSeries<Dim>::write_constants() const {
  if (topology_.shape[0] == 0) return;  // no body's surface is in the box
  frames_.write_constants([&](Hdf5File& file) {
    file.write("/topology", topology_, facets_);
    file.write("/body", scalar_, std::vector<double>(owner_.begin(), owner_.end()));
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
  for (const auto& body : bodies_) poses.push_back(body.motion.pose(time));
  Points<Dim> places;
  for (std::size_t v = 0; v < vertices_.size(); ++v) places.push_back(poses[owner_[v]].in_space(vertices_[v]));
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
