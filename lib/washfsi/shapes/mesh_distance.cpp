// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/mesh_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include <embree3/rtcore.h>

namespace washfsi {

namespace {

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

}  // namespace

/// Embree's tree over the triangles, in single precision: it only tells which ones to look at.
class MeshDistance::Tree {
 public:
  explicit Tree(const TriangleMesh& mesh) : device_(rtcNewDevice("threads=1")) {
    if (!device_) throw std::runtime_error("Embree could not be started");
    scene_.reset(rtcNewScene(device_.get()));
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), mesh.vertices.size()));
    auto* facets = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.facets.size()));
    if (!vertices || !facets) throw std::bad_alloc();
    for (const auto& vertex : mesh.vertices)
      for (int d = 0; d < 3; ++d) *vertices++ = static_cast<float>(vertex[d]);
    for (const auto& facet : mesh.facets) facets = std::copy(facet.begin(), facet.end(), facets);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_.get());
  }
  RTCScene scene() const { return scene_.get(); }

 private:
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice> device_;
  std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene> scene_;
};

/// The nearest point so far; Embree calls `look` for each triangle in reach.
struct MeshDistance::Search {
  const MeshDistance& mesh;
  const Point<3>& place;
  double least2 = std::numeric_limits<double>::max();
  std::size_t facet = 0;
  NearestOnTriangle nearest{};

  static bool look(RTCPointQueryFunctionArguments* arguments) {
    auto& search = *static_cast<Search*>(arguments->userPtr);
    const MeshDistance& surface = search.mesh;
    const std::size_t facet = arguments->primID;
    const NearestOnTriangle here = nearest_on(surface.mesh_.triangle(surface.mesh_.facets[facet]), search.place);
    const double distance2 = (here.place - search.place).squaredNorm();
    if (distance2 >= search.least2) return false;
    search.least2 = distance2;
    search.facet = facet;
    search.nearest = here;
    // a margin for what the tree's boxes and the query lose in single precision
    constexpr double slack = 1e-6;
    const double distance = std::sqrt(distance2);
    arguments->query->radius = static_cast<float>(distance + slack * (distance + surface.extent_));
    return true;
  }
};

MeshDistance::MeshDistance(TriangleMesh mesh) : mesh_(std::move(mesh)) {
  for (const auto& vertex : mesh_.vertices) extent_ = std::max(extent_, vertex.cwiseAbs().maxCoeff());
  compute_normals();
  tree_ = std::make_unique<Tree>(mesh_);
}

MeshDistance::~MeshDistance() = default;

void MeshDistance::compute_normals() {
  vertex_normals_.assign(mesh_.vertices.size(), Point<3>::Zero());
  std::map<std::pair<std::uint32_t, std::uint32_t>, Point<3>> of_edges;
  for (const auto& facet : mesh_.facets) {
    const Triangle t = mesh_.triangle(facet);
    const Point<3> normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    facet_normals_.push_back(normal);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point<3> next = t[(k + 1) % 3] - t[k], last = t[(k + 2) % 3] - t[k];
      vertex_normals_[facet[k]] += std::atan2(next.cross(last).norm(), next.dot(last)) * normal;
      of_edges.try_emplace(std::minmax(facet[k], facet[(k + 1) % 3]), Point<3>::Zero()).first->second += normal;
    }
  }
  for (const auto& facet : mesh_.facets) {
    auto& normals = edge_normals_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) normals[k] = of_edges.at(std::minmax(facet[k], facet[(k + 1) % 3]));
  }
}

double MeshDistance::distance(const Point<3>& place) const {
  Search search{*this, place};
  RTCPointQuery query{};
  query.x = static_cast<float>(place[0]);
  query.y = static_cast<float>(place[1]);
  query.z = static_cast<float>(place[2]);
  query.radius = std::numeric_limits<float>::infinity();
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(tree_->scene(), &query, &context, Search::look, &search);
  const auto [foot, part, index] = search.nearest;
  const Point<3>& normal = part == TrianglePart::face   ? facet_normals_[search.facet]
                           : part == TrianglePart::edge ? edge_normals_[search.facet][index]
                                                        : vertex_normals_[mesh_.facets[search.facet][index]];
  return std::copysign(std::sqrt(search.least2), normal.dot(place - foot));
}

}  // namespace washfsi
