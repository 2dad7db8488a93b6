// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/options.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "washfsi/support/errors.hpp"

namespace washfsi {

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
  if (group.model == "love") refuse(group, "model love", "not for a closed cloth (-..._shape ellipse); use energy");
  for (const Point<Dim>& force : {group.end_force_first, group.end_force_last})
    if (force != Point<Dim>::Zero()) refuse(group, "end_force_...", "a closed cloth (-..._shape ellipse) has no ends");
}

template <int Dim>
void check_love(const ClothGroup<Dim>& group) {
  const Sheet& sheet = group.sheet;
  if (Dim == 3 && (sheet.ke_s != sheet.ke_r || sheet.kb_s != sheet.kb_r))
    refuse(group, "model love", "is for isotropic cloth only (one value in -..._ke and -..._kb); use energy");
  if (Dim == 3 && (group.markers[0] < 3 || group.markers[1] < 3))
    refuse(group, "model love", "needs at least 3,3 markers; use energy");
}

// Reads a list of one value, for both directions, or two: along warp and weft.
void read_pair(OptionBlock& block, const char* name, std::array<double, 2>& pair, std::size_t most, const char* unit,
               const char* help) {
  std::vector<double> list(pair.begin(), pair.begin() + static_cast<long>(most));
  block.reals(name, list, 1, most, unit, help);
  for (std::size_t d = 0; d < most; ++d) pair[d] = list[std::min(d, list.size() - 1)];
}

template <int Dim>
void read_lattice(OptionBlock& block, ClothGroup<Dim>& group) {
  constexpr std::size_t directions = Dim - 1;
  std::array<double, 2> markers{static_cast<double>(group.markers[0]), static_cast<double>(group.markers[1])};
  read_pair(block, "markers", markers, directions, "-",
            Dim == 2 ? "markers along a cloth" : "markers along warp and weft; one number for both");
  read_pair(block, "size", group.size, directions, "m",
            Dim == 2 ? "physical length of a cloth: markers times spacing"
                     : "physical lengths along warp and weft: markers times spacing; one number for both");
  for (std::size_t d = 0; d < directions; ++d) {
    const double fewest = d == 0 ? 2 : 1;
    if (markers[d] != std::floor(markers[d]) || markers[d] < fewest || markers[d] > 1e6)
      refuse(group, "markers", to_text(markers[d]) + " is not a whole number >= " + to_text(fewest));
    if (!(group.size[d] > 0)) refuse(group, "size", to_text(group.size[d]) + " is not a number > 0");
    group.markers[d] = static_cast<PetscInt>(markers[d]);
  }
}

// nu_sr Ke_r = nu_rs Ke_s (3.3.5), or the strain energy would not exist.
template <int Dim>
double symmetric_poisson(const ClothGroup<Dim>& group, double along, std::optional<double> across) {
  const double ratio = group.sheet.ke_r / group.sheet.ke_s, wanted = along * ratio;
  if (across && std::abs(*across - wanted) > 1e-6 * std::max(std::abs(wanted), std::abs(*across)))
    refuse(group, "poisson " + to_text(along) + "," + to_text(*across),
           "must be symmetric, nu_sr Ke_r = nu_rs Ke_s: the second must be " + to_text(wanted));
  const double mean = along * std::sqrt(ratio);
  if (!(std::abs(mean) < 1)) refuse(group, "poisson", "sqrt(nu_sr nu_rs) must be below 1");
  return mean;
}

template <int Dim>
void read_material(OptionBlock& block, ClothGroup<Dim>& group) {
  constexpr std::size_t directions = Dim - 1;
  Sheet& sheet = group.sheet;
  std::array<double, 2> ke{8e3, 8e3}, kb{1e-5, 1e-5};
  read_pair(block, "ke", ke, directions, "N/m",
            Dim == 2 ? "extensional stiffness" : "extensional stiffness along warp and weft; one number for both");
  read_pair(block, "kb", kb, directions, "N m",
            Dim == 2 ? "bending stiffness" : "bending stiffness along warp and weft; one number for both");
  for (std::size_t d = 0; d < directions; ++d) {
    if (!(ke[d] > 0)) refuse(group, "ke", to_text(ke[d]) + " is not a number > 0");
    if (!(kb[d] >= 0)) refuse(group, "kb", to_text(kb[d]) + " is not a number >= 0");
  }
  sheet.ke_s = ke[0];
  sheet.kb_s = kb[0];
  if (Dim == 2) return;
  sheet.ke_r = ke[1];
  sheet.kb_r = kb[1];
  std::vector<double> poisson{0};
  block.reals("poisson", poisson, 1, 2, "-", "Poisson's ratio nu_sr, and nu_rs = nu_sr Ke_r/Ke_s if given");
  sheet.poisson = symmetric_poisson(group, poisson[0], poisson.size() > 1 ? std::optional(poisson[1]) : std::nullopt);
  sheet.ks = 0.5 * (1 - sheet.poisson) * std::sqrt(ke[0] * ke[1]);
  sheet.kt = (1 - sheet.poisson) * std::sqrt(kb[0] * kb[1]);
  block.real("ks", sheet.ks, "N/m", non_negative, "shear stiffness; default: that of an isotropic sheet");
  block.real("kt", sheet.kt, "N m", non_negative, "twisting stiffness; default: that of an isotropic sheet");
}

template <int Dim>
void read_loads(OptionBlock& block, ClothGroup<Dim>& group) {
  block.choice("hold", group.hold, {"none", "middle", "first", "corners", "edge"},
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

const std::vector<std::string>& shapes_in(int dimension) {
  static const std::vector<std::string> in_plane{"flat", "ellipse", "mode", "bar_mode", "crumpled"},
      in_space{"flat", "mode", "bar_mode", "crumpled"};
  return dimension == 2 ? in_plane : in_space;
}

}  // namespace

template <int Dim>
ClothGroup<Dim> ClothGroup<Dim>::from_options(Options& options, const std::string& name) {
  ClothGroup group;
  group.name = name;
  Sheet& sheet = group.sheet;
  sheet.thickness = 2.4e-4;
  if (Dim == 3) {
    group.markers = {10, 10};
    group.size = {0.25, 0.25};
  }
  options.block(name + "_", "Cloth group " + name, [&](OptionBlock& block) {
    block.integer("count", group.count, at_least_one, "number of cloths in this group");
    read_lattice(block, group);
    read_material(block, group);
    block.real("excess_mass", group.excess_mass, "kg/m2", non_negative, "mass over that of the water displaced");
    block.real("thickness", sheet.thickness, "m", positive, "thickness, for stresses");
    block.real("damping", sheet.damping, "s", non_negative,
               "Kelvin-Voigt time of the edges; the semi-implicit coupling does not use it");
    block.choice("model", group.model, {"energy", "love"},
                 "elastic model: discrete energy, or the thesis's strong form");
    block.choice("shape", group.shape, shapes_in(Dim),
                 Dim == 2 ? "at the start; an ellipse is a closed cloth" : "at the start");
    read_loads(block, group);
  });
  sheet.width = static_cast<std::size_t>(group.markers[1]);
  sheet.ds = group.size[0] / static_cast<double>(group.markers[0]);
  sheet.dr = group.size[1] / static_cast<double>(group.markers[1]);
  sheet.closed = group.shape == "ellipse";
  if (group.hold_stiffness == 0) group.hold_stiffness = sheet.ke_s * sheet.dr / sheet.ds;
  if (sheet.closed) check_closed(group);
  if (group.model == "love") check_love(group);
  return group;
}

namespace {

// The one or two in the middle of so many.
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
std::vector<PetscInt> ClothGroup<Dim>::held_markers() const {
  const auto all_of = [&](const std::vector<PetscInt>& rows, const std::vector<PetscInt>& columns) {
    std::vector<PetscInt> held;
    for (const PetscInt i : rows)
      for (const PetscInt j : columns) held.push_back(i * markers[1] + j);
    return held;
  };
  if (hold == "first") return all_of({0}, up_to(markers[1]));
  if (hold == "corners") return all_of(both_ends(markers[0]), both_ends(markers[1]));
  if (hold == "edge") return all_of({0, 1}, up_to(markers[1]));
  if (hold == "middle") return all_of(middle_of(markers[0]), middle_of(markers[1]));
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
