// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/options.hpp"

namespace washfsi {

ClothGroup ClothGroup::from_options(Options& options, const std::string& name) {
  ClothGroup group;
  group.name = name;
  group.fibre = {.spacing = 0, .ke = 8e3, .kb = 1e-5, .damping = 0, .thickness = 2.4e-4};
  constexpr Range two_or_more{2.0, 1e9, false, "a whole number >= 2"};
  options.block(name + "_", "Cloth group " + name, [&](OptionBlock& block) {
    block.integer("count", group.count, at_least_one, "number of cloths in this group");
    block.real("size", group.size, "m", positive, "physical length of a cloth: markers times spacing");
    block.integer("markers", group.markers, two_or_more, "markers along a cloth");
    block.real("ke", group.fibre.ke, "N/m", positive, "extensional stiffness");
    block.real("kb", group.fibre.kb, "N m", non_negative, "bending stiffness");
    block.real("excess_mass", group.excess_mass, "kg/m2", non_negative, "mass over that of the water displaced");
    block.real("thickness", group.fibre.thickness, "m", positive, "thickness, for stresses");
    block.real("damping", group.fibre.damping, "s", non_negative, "Kelvin-Voigt time of the edges");
    block.choice("model", group.model, {"energy", "love"},
                 "elastic model: discrete energy, or the thesis's strong form");
  });
  group.fibre.spacing = group.size / static_cast<double>(group.markers);
  return group;
}

std::vector<ClothGroup> cloth_groups_from_options(Options& options) {
  std::vector<std::string> names;
  options.block("", "Cloth",
                [&](OptionBlock& block) { block.names("cloths", names, "names of the groups of cloths"); });
  if (options.help() && names.empty()) names = {"towel"};  // so that -help shows a group's options
  std::vector<ClothGroup> groups;
  for (const auto& name : names) options.claim_prefix(name, "-cloths");
  for (const auto& name : names) groups.push_back(ClothGroup::from_options(options, name));
  return groups;
}

}  // namespace washfsi
