// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/fabric.hpp"

#include <type_traits>

namespace washfsi {

namespace {

// Reads the options of the law that the user chose; for -help those of all laws, each in a block of its own.
template <class... Laws>
Fabric read_fabric(Options& options, const std::string& group, std::size_t directions,
                   std::type_identity<std::variant<Laws...>>) {
  Fabric fabric;
  const std::vector<std::string> names{Laws::name...};
  std::string chosen = names.front();
  options.block(
      group + "_", "Fabric of group " + group,
      [&](OptionBlock& block) { block.choice("fabric", chosen, names, "law of its elasticity"); }, "cloths_");
  const auto read = [&]<class Law>(std::type_identity<Law>) {
    const auto declare = [&] {
      options.block(
          group + "_", "Group " + group + ", fabric " + Law::name,
          [&](OptionBlock& block) {
            const Law law = Law::from_options(block, directions);
            if (chosen == Law::name) fabric = law;
          },
          "cloths_");
    };
    if (chosen == Law::name || options.help()) return declare();
    if (options.given().overridden(group + "_fabric", group + "_"))
      options.leave_out("-" + group + "_fabric is another now", declare);
  };
  (read(std::type_identity<Laws>{}), ...);
  return fabric;
}

}  // namespace

Fabric fabric_from_options(Options& options, const std::string& group, std::size_t directions) {
  return read_fabric(options, group, directions, std::type_identity<Fabric>{});
}

}  // namespace washfsi
