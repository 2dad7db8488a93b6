// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/options.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "washfsi/cloth/warp_weft.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

const ChoiceNames<Hold>& names_of(Hold) {
  static const ChoiceNames<Hold> names{{"none", Hold::none},
                                       {"middle", Hold::middle},
                                       {"first", Hold::first},
                                       {"corners", Hold::corners},
                                       {"edge", Hold::edge}};
  return names;
}

const ChoiceNames<ClothShape>& names_of(ClothShape) {
  static const ChoiceNames<ClothShape> names{{"flat", ClothShape::flat},
                                             {"ellipse", ClothShape::ellipse},
                                             {"mode", ClothShape::mode},
                                             {"bar_mode", ClothShape::bar_mode},
                                             {"crumpled", ClothShape::crumpled}};
  return names;
}

const ChoiceNames<MarkerLattice>& names_of(MarkerLattice) {
  static const ChoiceNames<MarkerLattice> names{{"centred", MarkerLattice::centred}, {"nodal", MarkerLattice::nodal}};
  return names;
}

const ChoiceNames<ElasticModel>& names_of(ElasticModel) {
  static const ChoiceNames<ElasticModel> names{{"energy", ElasticModel::energy}, {"love", ElasticModel::love}};
  return names;
}

namespace {

template <int Dim>
[[noreturn]] void refuse(const ClothGroup<Dim>& group, const std::string& option, const std::string& why) {
  throw InputError("-" + group.name + "_" + option + ": " + why);
}

template <int Dim>
void check_closed(const ClothGroup<Dim>& group) {
  if (group.markers[0] < 4)
    refuse(group, "markers " + std::to_string(group.markers[0]),
           "a closed cloth (-..._shape ellipse) needs at least 4");
  if (group.model == ElasticModel::love)
    refuse(group, "model love", "not for a closed cloth (-..._shape ellipse); use energy");
  if (group.sheet.lattice == MarkerLattice::nodal)
    refuse(group, "lattice nodal", "a closed cloth (-..._shape ellipse) has no edges; use centred");
  for (const Point<Dim>& force : {group.end_force_first, group.end_force_last})
    if (force != Point<Dim>::Zero()) refuse(group, "end_force_...", "a closed cloth (-..._shape ellipse) has no ends");
}

template <int Dim>
void check_love(const ClothGroup<Dim>& group) {
  const auto* linear = std::get_if<LinearFabric>(&group.sheet.fabric);
  if (!linear) refuse(group, "model love", "is for linear fabric only (-..._fabric linear); use energy");
  if (Dim == 3 && !linear->is_isotropic())
    refuse(group, "model love", "is for isotropic cloth only (one value in -..._ke and -..._kb); use energy");
  if (group.sheet.lattice == MarkerLattice::nodal)
    refuse(group, "model love", "is for the centred lattice only (-..._lattice centred); use energy");
  if (Dim == 3 && (group.markers[0] < 3 || group.markers[1] < 3))
    refuse(group, "model love", "needs at least 3,3 markers; use energy");
}

template <int Dim>
void read_lattice(OptionBlock& block, ClothGroup<Dim>& group) {
  constexpr std::size_t directions = Dim - 1;
  WarpWeft markers{static_cast<double>(group.markers[0]), static_cast<double>(group.markers[1])};
  read_warp_weft(block, "markers", markers, directions, "-", any_number, "markers of a cloth");
  read_warp_weft(block, "size", group.size, directions, "m", positive, "physical length of a cloth,");
  block.choice("lattice", group.sheet.lattice,
               "of the markers: centred, each in the middle of an equal part; or nodal, the outermost on the edges");
  for (std::size_t d = 0; d < directions; ++d) {
    const double fewest = d == 0 ? 2 : 1;
    if (markers[d] != std::floor(markers[d]) || markers[d] < fewest || markers[d] > 1e6)
      block.refuse("markers", to_text(markers[d]), "a whole number >= " + to_text(fewest));
    group.markers[d] = static_cast<PetscInt>(markers[d]);
  }
}

template <int Dim>
void refine_lattice(Options& options, const Refinement& refinement, ClothGroup<Dim>& group) {
  std::vector<double> markers(group.markers.begin(), group.markers.begin() + Dim - 1);
  refinement.multiply(options, group.name + "_markers", markers, group.sheet.lattice == MarkerLattice::nodal ? 1 : 0);
  for (std::size_t d = 0; d < markers.size(); ++d) group.markers[d] = static_cast<PetscInt>(markers[d]);
}

template <int Dim>
void read_loads(OptionBlock& block, ClothGroup<Dim>& group) {
  block.choice("hold", group.hold,
               Dim == 2
                   ? "where springs hold it: nowhere, in the middle, at the first marker (hinge), at both ends, at"
                     " the first two markers (clamp)"
                   : "where springs hold it: nowhere, in the middle, along the first row of markers (hinge), at the"
                     " corners, along the first two rows (clamp)");
  block.real("hold_stiffness", group.hold_stiffness, Dim == 2 ? "N/m2" : "N/m", non_negative,
             "of the spring at each held marker; 0: that of an edge of the cloth");
  block.template point<Dim>("load", group.load, "N/m2", "constant force per undeformed area");
  const char* force = Dim == 2 ? "N/m" : "N";
  block.template point<Dim>("end_force_first", group.end_force_first, force,
                            "constant force at the edge before the first row of markers");
  block.template point<Dim>("end_force_last", group.end_force_last, force,
                            "constant force at the edge after the last row of markers");
}

// All shapes in the plane; in space none that is a ring.
std::vector<ClothShape> shapes_in(int dimension) {
  if (dimension == 2) return {};
  return {ClothShape::flat, ClothShape::mode, ClothShape::bar_mode, ClothShape::crumpled};
}

}  // namespace

template <int Dim>
ClothGroup<Dim> ClothGroup<Dim>::from_options(Options& options, const std::string& name, const Refinement& refinement) {
  ClothGroup group;
  group.name = name;
  Sheet& sheet = group.sheet;
  sheet.thickness = 2.4e-4;
  if (Dim == 3) {
    group.markers = {10, 10};
    group.size = {0.25, 0.25};
  }
  options.block(
      name + "_", "Cloth group " + name,
      [&](OptionBlock& block) {
        block.integer("count", group.count, at_least_one, "number of cloths in this group");
        read_lattice(block, group);
        block.real("excess_mass", group.excess_mass, "kg/m2", non_negative,
                   "mass over that of the water displaced; 0: it neither sinks nor rises, not with -fluid none");
        block.real("permeance", group.permeance, "m/(s Pa)", non_negative,
                   "speed of water through it over the jump of pressure; 0: tight (semi_implicit, implicit)");
        block.real("held_water", sheet.held_water, "kg/m2", non_negative,
                   "water in its pores, which moves with it along -cloth_wall_model equilibrium; 0: none");
        block.real("thickness", sheet.thickness, "m", positive, "thickness, for stresses");
        block.real("damping", sheet.damping, "s", non_negative,
                   "Kelvin-Voigt time of the edges; 0: undamped; the semi-implicit coupling does not use it");
        block.choice("model", group.model, "elastic model: discrete energy, or the thesis's strong form");
        block.choice("shape", group.shape, Dim == 2 ? "at the start; an ellipse is a closed cloth" : "at the start",
                     shapes_in(Dim));
        block.template point<Dim>("velocity", group.velocity, "m/s", "of the cloths at the start");
        read_loads(block, group);
      },
      "cloths_");
  refine_lattice(options, refinement, group);
  sheet.fabric = fabric_from_options(options, name, Dim - 1);
  sheet.width = static_cast<std::size_t>(group.markers[1]);
  sheet.ds = group.size[0] / group.row(0).parts();
  sheet.dr = group.size[1] / group.row(1).parts();
  sheet.closed = group.shape == ClothShape::ellipse;
  if (group.hold_stiffness == 0) group.hold_stiffness = largest_moduli_of(sheet.fabric).s * sheet.dr / sheet.ds;
  const double shorter = Dim == 3 ? std::min(group.size[0], group.size[1]) : group.size[0];
  if (sheet.thickness > 0.1 * shorter && !options.help())
    refuse(group, "thickness " + to_text(sheet.thickness),
           "must be at most a tenth of the cloth's shorter side, " + to_text(shorter) + " m");
  if (group.hold == Hold::none) options.mark_idle("-" + name + "_hold is none", {name + "_hold_stiffness"});
  if (sheet.closed) check_closed(group);
  if (group.model == ElasticModel::love) check_love(group);
  return group;
}

namespace {

// The one or two markers in the middle of `count`.
std::vector<PetscInt> middle_of(PetscInt count) {
  if (count % 2 == 1) return {count / 2};
  return {count / 2 - 1, count / 2};
}

std::vector<PetscInt> up_to(PetscInt end) {
  std::vector<PetscInt> numbers(static_cast<std::size_t>(end));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

std::vector<PetscInt> both_ends(PetscInt count) {
  if (count == 1) return {0};
  return {0, count - 1};
}

}  // namespace

template <int Dim>
double ClothGroup<Dim>::face_area() const {
  double shares = 0;
  for (PetscInt m = 0; m < marker_count(); ++m) shares += marker_share(m);
  const PetscInt faces = Dim == 3 ? 2 * (markers[0] - 1) * (markers[1] - 1) : markers[0] - (sheet.closed ? 0 : 1);
  return faces > 0 ? shares * sheet.part_area() / static_cast<double>(faces) : 0;
}

template <int Dim>
std::vector<PetscInt> ClothGroup<Dim>::held_markers() const {
  const auto all_of = [&](const std::vector<PetscInt>& rows, const std::vector<PetscInt>& columns) {
    std::vector<PetscInt> held;
    for (const PetscInt i : rows)
      for (const PetscInt j : columns) held.push_back(i * markers[1] + j);
    return held;
  };
  if (hold == Hold::first) return all_of({0}, up_to(markers[1]));
  if (hold == Hold::corners) return all_of(both_ends(markers[0]), both_ends(markers[1]));
  if (hold == Hold::edge) return all_of({0, 1}, up_to(markers[1]));
  if (hold == Hold::middle) return all_of(middle_of(markers[0]), middle_of(markers[1]));
  return {};
}

template <int Dim>
std::vector<ClothGroup<Dim>> cloth_groups_from_options(Options& options, const Refinement& refinement) {
  std::vector<std::string> names;
  options.block("", "Cloth",
                [&](OptionBlock& block) { block.names("cloths", names, "names of the groups of cloths"); });
  if (names.empty()) names = options.examples("towel", "CLOTH");
  std::vector<ClothGroup<Dim>> groups;
  for (const auto& name : names) options.claim_prefix(name, "-cloths");
  const auto read = [&](const std::string& name) { return ClothGroup<Dim>::from_options(options, name, refinement); };
  for (const auto& name : names) groups.push_back(read(name));
  options.leave_out_dropped("cloths", names, read);
  return groups;
}

template struct ClothGroup<2>;
template struct ClothGroup<3>;
template std::vector<ClothGroup<2>> cloth_groups_from_options<2>(Options&, const Refinement&);
template std::vector<ClothGroup<3>> cloth_groups_from_options<3>(Options&, const Refinement&);

}  // namespace washfsi
