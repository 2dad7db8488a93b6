// SPDX-License-Identifier: BSD-3-Clause
//
// The fabrics of which cloth is made. What a law of fabric must offer is in cloth/fabric_law.hpp.
#pragma once

#include <variant>

#include "washfsi/cloth/crimp_fabric.hpp"
#include "washfsi/cloth/linear_fabric.hpp"

namespace washfsi {

/// One of the laws; the first is the default. This is the list of them: the choices of -NAME_fabric come from it.
using Fabric = std::variant<LinearFabric, CrimpFabric>;

template <class Laws>
inline constexpr bool all_are_laws = false;
template <class... Laws>
inline constexpr bool all_are_laws<std::variant<Laws...>> = (FabricLaw<Laws> && ...);
static_assert(all_are_laws<Fabric>);

/// Reads the law (-NAME_fabric) of a group of cloths and its options. Collective.
Fabric fabric_from_options(Options& options, const std::string& group, std::size_t directions);

inline BendingModuli bending_of(const Fabric& fabric) {
  return std::visit([](const auto& law) -> BendingModuli { return law.bending(); }, fabric);
}
inline LargestModuli largest_moduli_of(const Fabric& fabric) {
  return std::visit([](const auto& law) -> LargestModuli { return law.largest_moduli(); }, fabric);
}

}  // namespace washfsi
