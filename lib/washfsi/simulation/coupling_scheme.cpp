// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/coupling_scheme.hpp"

#include <functional>
#include <map>

#include "washfsi/simulation/cloth_alone.hpp"
#include "washfsi/simulation/explicit_coupling.hpp"
#include "washfsi/simulation/fluid_alone.hpp"
#include "washfsi/simulation/implicit_coupling.hpp"
#include "washfsi/simulation/midpoint_coupling.hpp"
#include "washfsi/simulation/semi_implicit_coupling.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

CouplingOptions CouplingOptions::from_options(Options& options) {
  CouplingOptions coupling;
  options.block("cloth_", "Coupling of cloth and water", [&](OptionBlock& block) {
    block.choice("coupling", coupling.scheme, {"explicit", "midpoint", "semi_implicit", "implicit"},
                 "how cloth and water are coupled in a step");
    coupling.scheme_given = block.given("coupling");
    block.choice("time_scheme", coupling.time_scheme, {"trapezoidal", "backward_euler"},
                 "of the implicit coupling: as in the thesis, or damping more; both of first order");
    block.choice("mobility", coupling.mobility, {"matrix", "row_sums"},
                 "what stands for the mobility of the markers: that without pressure, or its row sums (semi_implicit)");
    block.real("mobility_factor", coupling.mobility_factor, "-", positive,
               "of what stands for the markers' mobility; too small: unstable; large: slow to follow (semi_implicit)");
    block.real("tolerance", coupling.tolerance, "-", positive,
               "rms residual of the markers' velocities over the flow's speed (semi_implicit, implicit)");
    block.integer("sweeps", coupling.sweeps, at_least_one, "elastic solves and corrections at most (semi_implicit)");
    block.real("slip_tolerance", coupling.slip_tolerance, "-", non_negative,
               "slip between cloth and water below which no further sweep is made (semi_implicit)");
  });
  return coupling;
}

namespace {

template <int Dim>
void check(const CouplingOptions& options, const System<Dim>& system) {
  if (!system.has_fluid && options.scheme_given)
    throw InputError("-cloth_coupling " + options.scheme + ": there is no fluid (-fluid none); leave it out");
  if (!system.has_fluid)
    for (const auto& group : system.cloths.groups())
      if (group.excess_mass == 0)
        throw InputError("-" + group.name + "_excess_mass 0: without fluid (-fluid none) cloth needs a mass");
  for (const auto& group : system.cloths.groups())
    if (group.model == "love" && options.scheme == "semi_implicit" && system.has_fluid)
      throw InputError("-" + group.name + "_model love: has no Jacobian; use -cloth_coupling explicit or midpoint");
}

}  // namespace

template <int Dim>
std::unique_ptr<CouplingScheme<Dim>> make_coupling_scheme(const CouplingOptions& options, const System<Dim>& system) {
  check(options, system);
  if (!system.has_fluid) return std::make_unique<ClothAlone<Dim>>();
  if (system.cloths.marker_count() == 0) return std::make_unique<FluidAlone<Dim>>();
  const std::map<std::string, std::function<std::unique_ptr<CouplingScheme<Dim>>()>> schemes{
      {"explicit", [] { return std::make_unique<ExplicitCoupling<Dim>>(); }},
      {"midpoint", [] { return std::make_unique<MidpointCoupling<Dim>>(); }},
      {"semi_implicit", [&] { return std::make_unique<SemiImplicitCoupling<Dim>>(system, options); }},
      {"implicit", [&] { return std::make_unique<ImplicitCoupling<Dim>>(system, options); }}};
  return schemes.at(options.scheme)();
}

template std::unique_ptr<CouplingScheme<2>> make_coupling_scheme<2>(const CouplingOptions&, const System<2>&);
template std::unique_ptr<CouplingScheme<3>> make_coupling_scheme<3>(const CouplingOptions&, const System<3>&);

}  // namespace washfsi
