// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/mesh_shells.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

/// The connected vertices: each points towards the first of its shell.
class Joined {
 public:
  explicit Joined(std::size_t vertices) : towards_(vertices) { std::iota(towards_.begin(), towards_.end(), 0U); }

  std::uint32_t first(std::uint32_t vertex) {
    while (towards_[vertex] != vertex) vertex = towards_[vertex] = towards_[towards_[vertex]];
    return vertex;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t one = first(a), other = first(b);
    towards_[std::max(one, other)] = std::min(one, other);
  }

 private:
  std::vector<std::uint32_t> towards_;
};

}  // namespace

std::vector<TriangleMesh> shells_of(const TriangleMesh& mesh) {
  Joined joined(mesh.vertices.size());
  for (const auto& facet : mesh.facets)
    for (std::size_t k = 1; k < 3; ++k) joined.join(facet[0], facet[k]);
  std::vector<TriangleMesh> shells;
  std::map<std::uint32_t, std::size_t> shell_of;
  std::vector<std::uint32_t> number(mesh.vertices.size());
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const auto [entry, is_new] = shell_of.try_emplace(joined.first(v), shells.size());
    if (is_new) shells.emplace_back();
    TriangleMesh& shell = shells[entry->second];
    number[v] = static_cast<std::uint32_t>(shell.vertices.size());
    shell.vertices.push_back(mesh.vertices[v]);
  }
  for (const auto& facet : mesh.facets)
    shells[shell_of.at(joined.first(facet[0]))].facets.push_back(
        {number[facet[0]], number[facet[1]], number[facet[2]]});
  return shells;
}

MeshShells::MeshShells(std::vector<TriangleMesh> shells, const std::string& start) {
  std::vector<TriangleMesh> cavities;
  for (TriangleMesh& shell : shells) {
    const double volume = shell.volume();
    if (volume > 0) {
      Solid& solid = solids_.emplace_back();
      solid.vertices.assign(shell.vertices.begin(), shell.vertices.end());
      solid.outside = std::make_unique<MeshDistance>(std::move(shell));
      solid.volume = volume;
    } else {
      cavities.push_back(std::move(shell));
    }
  }
  for (TriangleMesh& cavity : cavities) {
    Solid& solid = around(cavity.vertices.front(), start);
    solid.cavities.push_back(std::make_unique<MeshDistance>(std::move(cavity)));
  }
}

// The smallest solid that a cavity with this vertex can be in.
MeshShells::Solid& MeshShells::around(const Point<3>& place, const std::string& start) {
  Solid* smallest = nullptr;
  for (Solid& solid : solids_)
    if (solid.outside->distance(place) < 0 && (!smallest || solid.volume < smallest->volume)) smallest = &solid;
  if (!smallest)
    throw InputError(start + "the part of it at (" + list_text<3>(place) +
                     ") faces inwards and lies in no other: turn its facets round");
  return *smallest;
}

double MeshShells::Solid::distance(const Point<3>& place) const {
  double here = outside->distance(place);
  for (const auto& cavity : cavities) here = std::max(here, cavity->distance(place));
  return here;
}

std::size_t MeshShells::shells_within_others() const {
  const auto is_within = [](const Solid& inner, const Solid& outer) {
    return inner.volume < outer.volume &&
           std::ranges::all_of(inner.vertices, [&](const Point<3>& vertex) { return outer.distance(vertex) < 0; });
  };
  return static_cast<std::size_t>(std::ranges::count_if(solids_, [&](const Solid& inner) {
    return std::ranges::any_of(solids_, [&](const Solid& outer) { return is_within(inner, outer); });
  }));
}

double MeshShells::distance(const Point<3>& place) const {
  double nearest = std::numeric_limits<double>::max();
  for (const Solid& solid : solids_) nearest = std::min(nearest, solid.distance(place));
  return nearest;
}

}  // namespace washfsi
