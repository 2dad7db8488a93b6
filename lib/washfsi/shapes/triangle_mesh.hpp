// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "washfsi/shapes/stl_file.hpp"

namespace washfsi {

/// A surface of triangles that share their vertices; counter-clockwise seen from outside.
struct TriangleMesh {
  using Facet = std::array<std::uint32_t, 3>;
  Points<3> vertices;
  std::vector<Facet> facets;

  /// Corners with equal coordinates become one vertex.
  static TriangleMesh weld(const std::vector<Triangle>& triangles);

  Triangle triangle(const Facet& facet) const { return {vertices[facet[0]], vertices[facet[1]], vertices[facet[2]]}; }

  /// The enclosed volume, if it is closed; negative if it faces inwards [m3].
  double volume() const;

  /// Describes why this is no closed surface that faces outwards everywhere; empty if it is. Does not check for facets
  /// that cross each other.
  std::string flaw() const;
};

}  // namespace washfsi
