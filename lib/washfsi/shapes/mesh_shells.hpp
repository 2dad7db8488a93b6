// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/shapes/mesh_distance.hpp"

namespace washfsi {

/// The connected parts of a surface, each closed: two shells share no vertex.
std::vector<TriangleMesh> shells_of(const TriangleMesh& mesh);

/// The solid of several closed surfaces: the union, for each that faces outwards, of its inside without the cavities in
/// it, which face inwards. They may lie apart, in each other or overlap. Where they overlap the distance is that of the
/// one in which a place lies deepest: a bound, never beyond the true one.
class MeshShells : public Shape<3> {
 public:
  /// Errors: InputError, which begins with `start`, if a cavity lies in no solid.
  MeshShells(std::vector<TriangleMesh> shells, const std::string& start);
  double distance(const Point<3>& place) const override;
  /// How many shells that face outwards lie in the solid of another one: perhaps cavities that face the wrong way.
  std::size_t shells_within_others() const;

 private:
  struct Solid {
    std::unique_ptr<MeshDistance> outside;
    Points<3> vertices;
    double volume = 0;
    std::vector<std::unique_ptr<MeshDistance>> cavities;

    double distance(const Point<3>& place) const;
  };
  Solid& around(const Point<3>& place, const std::string& start);

  std::vector<Solid> solids_;
};

}  // namespace washfsi
