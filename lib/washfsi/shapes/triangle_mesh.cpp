// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/triangle_mesh.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "washfsi/support/options.hpp"

namespace washfsi {

TriangleMesh TriangleMesh::weld(const std::vector<Triangle>& triangles) {
  TriangleMesh mesh;
  std::map<std::array<double, 3>, std::uint32_t> known;
  for (const auto& triangle : triangles) {
    Facet facet{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point<3>& corner = triangle[k];
      const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
      const auto [entry, is_new] = known.try_emplace({corner[0], corner[1], corner[2]}, next);
      if (is_new) mesh.vertices.push_back(corner);
      facet[k] = entry->second;
    }
    mesh.facets.push_back(facet);
  }
  return mesh;
}

namespace {

// A facet thinner than this part of its longest side has no normal to rely on.
constexpr double thinnest = 1e-6;

bool is_degenerate(const Triangle& t) {
  const double longest2 =
      std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
  return (t[1] - t[0]).cross(t[2] - t[0]).norm() <= thinnest * longest2;
}

/// How often facets pass an edge from its lower to its higher vertex, and back.
struct Passes {
  int up = 0, down = 0;
};
using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::map<Edge, Passes> passes_of(const std::vector<TriangleMesh::Facet>& facets) {
  std::map<Edge, Passes> passes;
  for (const auto& facet : facets)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = facet[k], to = facet[(k + 1) % 3];
      Passes& edge = passes[std::minmax(from, to)];
      (from < to ? edge.up : edge.down) += 1;
    }
  return passes;
}

std::string flaw_of_edge(const Passes& edge) {
  if (edge.up == 1 && edge.down == 1) return "";
  if (edge.up + edge.down == 1) return "it is open";
  if (edge.up + edge.down == 2) return "two facets face opposite ways";
  return "more than two facets meet";
}

}  // namespace

double TriangleMesh::volume() const {
  double volume = 0;
  for (const auto& facet : facets) {
    const Triangle t = triangle(facet);
    volume += (t[0] - vertices[0]).dot((t[1] - vertices[0]).cross(t[2] - vertices[0])) / 6;
  }
  return volume;
}

std::string TriangleMesh::flaw() const {
  if (facets.empty()) return "it has no facets";
  for (std::size_t f = 0; f < facets.size(); ++f)
    if (is_degenerate(triangle(facets[f]))) return "facet " + std::to_string(f + 1) + " has no area";
  for (const auto& [edge, passes] : passes_of(facets)) {
    const std::string flaw = flaw_of_edge(passes);
    if (!flaw.empty())
      return flaw + " at the edge from (" + list_text<3>(vertices[edge.first]) + ") to (" +
             list_text<3>(vertices[edge.second]) + ")";
  }
  if (!(volume() > 0)) return "its facets face inwards; turn them round (flip or recalculate the normals)";
  return "";
}

}  // namespace washfsi
