// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/stl_shape.hpp"

#include <cmath>

#include "washfsi/shapes/mesh_shells.hpp"
#include "washfsi/shapes/sampled.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/format_text.hpp"

namespace washfsi {

namespace {

constexpr double margin_in_points = 8;  // with the default spacing, four cells of the grid

// Refuses a lattice too large for any machine, and suggests a spacing that fits.
void check_size(const Lattice<3>& lattice, double length, const StlOptions& options, const std::string& name) {
  constexpr double most_points = Lattice<3>::most_points;
  if (lattice.size() <= most_points) return;
  const double least = options.sample_spacing * std::cbrt(lattice.size() / most_points);
  throw InputError("-" + name + "_sample_spacing " + to_text(options.sample_spacing) + ": must be at least about " +
                   format_text("%.1e", 1.1 * least) + " for a body " + format_text("%.3g m long", length) +
                   "; if its file is in millimetres, give -" + name + "_scale 0.001");
}

}  // namespace

void StlOptions::read(OptionBlock& block) {
  const double most = 4 * sample_spacing;
  block.require("file", "the STL file of the shape");
  block.file("file", file, "STL file, ASCII or binary, of a closed surface (stl)");
  block.real("scale", scale, "m", positive, "length of the STL file's unit; 1e-3 if it is in millimetres (stl)");
  block.real("sample_spacing", sample_spacing, "m", positive,
             "of the lattice on which the distance is kept (stl); default: half of the smallest cell");
  if (sample_spacing > most)
    block.refuse("sample_spacing", to_text(sample_spacing), "at most two of the smallest cells, " + to_text(most));
}

namespace {

// A shell within another that faces outwards adds nothing to the union: it is more likely a cavity turned inside out.
void warn_of_inner_shells(Options& options, const MeshShells& shells, const std::string& what) {
  const std::size_t count = shells.shells_within_others();
  if (count == 0) return;
  options.warn(what + (count == 1 ? "two shells, united: one lies within the other, and both face outwards; if the "
                                    "inner one is a cavity, turn its facets round"
                                  : std::to_string(count) +
                                        " shells lie within others, and all face outwards, so they are united; if they "
                                        "are cavities, turn their facets round"));
}

}  // namespace

ShapePtr<3> shape_from_stl(Options& options, const StlOptions& stl, const std::string& name) {
  const std::string option = "-" + name + "_file " + stl.file + ": ";
  TriangleMesh mesh = TriangleMesh::weld(read_stl(options.comm(), stl.file, "-" + name + "_file"));
  const std::string flaw = mesh.flaw();
  if (!flaw.empty()) throw InputError(option + "must be a closed surface, but " + flaw);
  Point<3> lower = stl.scale * mesh.vertices[0], upper = lower;
  for (auto& vertex : mesh.vertices) {
    vertex *= stl.scale;
    lower = lower.cwiseMin(vertex);
    upper = upper.cwiseMax(vertex);
  }
  const double spacing = stl.sample_spacing;
  const auto lattice = Lattice<3>::around(lower, upper, margin_in_points * spacing, spacing);
  check_size(lattice, (upper - lower).maxCoeff(), stl, name);
  const MeshShells shells(shells_of(mesh), option);
  warn_of_inner_shells(options, shells, option);
  return Sampled<3>::of(options.comm(), shells, lattice);
}

}  // namespace washfsi
