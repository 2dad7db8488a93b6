// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/options.hpp"

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

template <int Dim>
void check(const ClothGroup<Dim>& group) {
  if (!group.fibre.closed) return;
  if (group.markers < 4)
    throw InputError("-" + group.name + "_markers " + std::to_string(group.markers) +
                     ": a closed cloth (-..._shape ellipse) needs at least 4");
  if (group.model == "love")
    throw InputError("-" + group.name + "_model love: not for a closed cloth (-..._shape ellipse); use energy");
  for (const Point<Dim>& force : {group.end_force_first, group.end_force_last})
    if (force != Point<Dim>::Zero())
      throw InputError("-" + group.name + "_end_force_...: a closed cloth (-..._shape ellipse) has no ends");
}

}  // namespace

template <int Dim>
ClothGroup<Dim> ClothGroup<Dim>::from_options(Options& options, const std::string& name) {
  ClothGroup group;
  group.name = name;
  group.fibre = {.spacing = 0, .ke = 8e3, .kb = 1e-5, .damping = 0, .thickness = 2.4e-4, .closed = false};
  constexpr Range two_or_more{2.0, 1e9, false, "a whole number >= 2"};
  const char* force = Dim == 2 ? "N/m" : "N";
  options.block(name + "_", "Cloth group " + name, [&](OptionBlock& block) {
    block.integer("count", group.count, at_least_one, "number of cloths in this group");
    block.real("size", group.size, "m", positive, "physical length of a cloth: markers times spacing");
    block.integer("markers", group.markers, two_or_more, "markers along a cloth");
    block.real("ke", group.fibre.ke, "N/m", positive, "extensional stiffness");
    block.real("kb", group.fibre.kb, "N m", non_negative, "bending stiffness");
    block.real("excess_mass", group.excess_mass, "kg/m2", non_negative, "mass over that of the water displaced");
    block.real("thickness", group.fibre.thickness, "m", positive, "thickness, for stresses");
    block.real("damping", group.fibre.damping, "s", non_negative,
               "Kelvin-Voigt time of the edges, in the explicit couplings");
    block.choice("model", group.model, {"energy", "love"},
                 "elastic model: discrete energy, or the thesis's strong form");
    block.choice("shape", group.shape, {"flat", "ellipse", "mode", "crumpled"},
                 "at the start; an ellipse is a closed cloth");
    block.choice("hold", group.hold, {"none", "middle", "first", "corners", "edge"},
                 "where springs hold it: nowhere, in the middle, at the first marker (hinge), at both ends, at the"
                 " first two markers (clamp)");
    block.real("hold_stiffness", group.hold_stiffness, Dim == 2 ? "N/m2" : "N/m", non_negative,
               "of the spring at each held marker; 0: that of an edge of the cloth");
    block.template point<Dim>("load", group.load, "N/m2", "constant force per undeformed area");
    block.template point<Dim>("end_force_first", group.end_force_first, force,
                              "constant force at the end before the first marker");
    block.template point<Dim>("end_force_last", group.end_force_last, force,
                              "constant force at the end after the last marker");
  });
  group.fibre.spacing = group.size / static_cast<double>(group.markers);
  group.fibre.closed = group.shape == "ellipse";
  if (group.hold_stiffness == 0) group.hold_stiffness = group.fibre.ke / group.fibre.spacing;
  check(group);
  return group;
}

template <int Dim>
std::vector<PetscInt> ClothGroup<Dim>::held_markers() const {
  if (hold == "first") return {0};
  if (hold == "corners") return {0, markers - 1};
  if (hold == "edge") return {0, 1};
  if (hold == "middle" && markers % 2 == 1) return {markers / 2};
  if (hold == "middle") return {markers / 2 - 1, markers / 2};
  return {};
}

template <int Dim>
std::vector<ClothGroup<Dim>> cloth_groups_from_options(Options& options) {
  std::vector<std::string> names;
  options.block("", "Cloth",
                [&](OptionBlock& block) { block.names("cloths", names, "names of the groups of cloths"); });
  if (options.help() && names.empty()) names = {"towel"};  // so that -help shows a group's options
  std::vector<ClothGroup<Dim>> groups;
  for (const auto& name : names) options.claim_prefix(name, "-cloths");
  for (const auto& name : names) groups.push_back(ClothGroup<Dim>::from_options(options, name));
  return groups;
}

template struct ClothGroup<2>;
template struct ClothGroup<3>;
template std::vector<ClothGroup<2>> cloth_groups_from_options<2>(Options&);
template std::vector<ClothGroup<3>> cloth_groups_from_options<3>(Options&);

}  // namespace washfsi
