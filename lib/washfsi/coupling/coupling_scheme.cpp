// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/coupling_scheme.hpp"

#include <functional>

#include "washfsi/coupling/cloth_alone.hpp"
#include "washfsi/coupling/explicit_coupling.hpp"
#include "washfsi/coupling/fluid_alone.hpp"
#include "washfsi/coupling/implicit_cloth_alone.hpp"
#include "washfsi/coupling/implicit_coupling.hpp"
#include "washfsi/coupling/midpoint_coupling.hpp"
#include "washfsi/coupling/semi_implicit_coupling.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

const ChoiceNames<TimeScheme>& names_of(TimeScheme) {
  static const ChoiceNames<TimeScheme> names{{"trapezoidal", TimeScheme::trapezoidal},
                                             {"backward_euler", TimeScheme::backward_euler}};
  return names;
}

const ChoiceNames<Mobility>& names_of(Mobility) {
  static const ChoiceNames<Mobility> names{{"matrix", Mobility::matrix}, {"row_sums", Mobility::row_sums}};
  return names;
}

namespace {

constexpr Range one_or_two{1.0, 2.0, false, "1 or 2"};

template <int Dim>
struct NamedScheme {
  std::string name;
  bool takes_inertia;  ///< whether the cloths may carry their own mass
  bool takes_seepage;  ///< whether they may let water through
  std::function<std::unique_ptr<CouplingScheme<Dim>>(System<Dim>&, const CouplingOptions&)> make;
};

template <int Dim, class Scheme>
NamedScheme<Dim> named(const char* name) {
  return {name, Scheme::takes_inertia, Scheme::takes_seepage, [](System<Dim>& system, const CouplingOptions& options) {
            if constexpr (std::is_default_constructible_v<Scheme>)
              return std::make_unique<Scheme>();
            else
              return std::make_unique<Scheme>(system, options);
          }};
}

// Every scheme of water and cloth that there is.
template <int Dim>
const std::vector<NamedScheme<Dim>>& coupling_schemes() {
  static const std::vector<NamedScheme<Dim>> schemes{
      named<Dim, ExplicitCoupling<Dim>>("explicit"),
      named<Dim, MidpointCoupling<Dim>>("midpoint"),
      named<Dim, SemiImplicitCoupling<Dim>>("semi_implicit"),
      named<Dim, ImplicitCoupling<Dim>>("implicit"),
  };
  return schemes;
}

template <int Dim>
const NamedScheme<Dim>& scheme_named(const std::string& name) {
  for (const auto& scheme : coupling_schemes<Dim>())
    if (scheme.name == name) return scheme;
  throw InputError("-coupling_scheme " + name + ": there is no such scheme");
}

}  // namespace

CouplingOptions CouplingOptions::from_options(Options& options) {
  CouplingOptions coupling;
  coupling.read_scheme(options);
  coupling.mass_carrier = scheme_named<2>(coupling.scheme).takes_inertia ? MassCarrier::cloth : MassCarrier::water;
  options.block("cloth_", "Coupling of cloth and water", [&](OptionBlock& block) {
    block.choice("inertia", coupling.mass_carrier,
                 "what carries the cloths' excess mass: they themselves (semi_implicit, implicit); or the water, into "
                 "which it is smeared, as in the thesis");
  });
  if (coupling.mass_carrier == MassCarrier::cloth) coupling.sweeps = most_sweeps_with_inertia;
  coupling.read_solution(options);
  return coupling;
}

void CouplingOptions::read_scheme(Options& options) {
  std::vector<std::string> schemes;
  for (const auto& known : coupling_schemes<2>()) schemes.push_back(known.name);
  options.alias("cloth_coupling", "coupling_scheme");
  for (const char* name : {"time_scheme", "mobility", "mobility_factor", "tolerance", "sweeps", "slip_tolerance"})
    options.alias(std::string("cloth_") + name, std::string("coupling_") + name);
  options.block("coupling_", "Coupling of cloth and water", [&](OptionBlock& block) {
    block.choice("scheme", scheme, schemes, "how cloth and water are coupled in a step");
    scheme_given = block.given("scheme");
    scheme_option = options.as_given("coupling_scheme");
  });
}

void CouplingOptions::read_solution(Options& options) {
  options.block("coupling_", "How the coupling is solved", [&](OptionBlock& block) {
    block.choice("time_scheme", time_scheme,
                 "of the implicit coupling: as in the thesis, or damping more; both of first order");
    block.integer("order", order, one_or_two,
                  "in time: 2 follows smooth motions; 1 damps waves that the step is long for (semi_implicit)");
    block.choice("mobility", mobility,
                 "what stands for the mobility of the markers: that without pressure, or its row sums (semi_implicit)");
    block.real("mobility_factor", mobility_factor, "-", {0.01, 100.0, false, "a number from 0.01 to 100"},
               "of what stands for the markers' mobility; too small: unstable; large: slow to follow (semi_implicit)");
    block.real("tolerance", tolerance, "-", tight,
               "rms residual of the markers' velocities over the flow's speed (semi_implicit, implicit)");
    block.integer("sweeps", sweeps, at_least_one, "solves of the cloth and corrections at most (semi_implicit)");
    block.real("slip_tolerance", slip_tolerance, "-", {0.0, 1.0, false, "a number from 0 to 1"},
               "slip between cloth and water below which no further sweep is made; 0: all of -coupling_sweeps are made "
               "(semi_implicit)");
  });
}

namespace {

// Explicit, unless the user chooses implicit or a contact with a step limit requires it. The default scheme in water
// leaves the choice open.
template <int Dim>
std::unique_ptr<CouplingScheme<Dim>> cloth_alone(const CouplingOptions& options, System<Dim>& system) {
  if (options.scheme == "midpoint")
    throw InputError("-" + options.scheme_option + " midpoint: without fluid (-fluid none) only explicit or implicit");
  for (const auto& group : system.model.cloths.groups())
    if (group.excess_mass == 0)
      throw InputError("-" + group.name + "_excess_mass 0: without fluid (-fluid none) cloth needs a mass");
  const bool is_chosen = options.scheme_given && options.scheme != "semi_implicit";
  const bool is_implicit = is_chosen ? options.scheme == "implicit" : system.model.forces.have_step_limit();
  if (is_implicit) return std::make_unique<ImplicitClothAlone<Dim>>(system, options);
  return std::make_unique<ClothAlone<Dim>>();
}

}  // namespace

template <int Dim>
std::unique_ptr<CouplingScheme<Dim>> make_coupling_scheme(const CouplingOptions& options, System<Dim>& system) {
  if (!system.model.has_fluid) return cloth_alone(options, system);
  if (system.model.cloths.marker_count() == 0) return std::make_unique<FluidAlone<Dim>>();
  const NamedScheme<Dim>& scheme = scheme_named<Dim>(options.scheme);
  if (system.model.cloth_treatment.mass_carrier == MassCarrier::cloth && !scheme.takes_inertia)
    throw InputError("-cloth_inertia cloth: not with -" + options.scheme_option + " " + options.scheme +
                     ", which needs water");
  if (scheme.takes_seepage && options.mobility == Mobility::matrix) return scheme.make(system, options);
  const std::string needs = ": needs -coupling_scheme semi_implicit or implicit, with -coupling_mobility matrix";
  if (system.model.cloth_treatment.films_drain) throw InputError("-contact_drainage" + needs);
  if (system.model.cloth_treatment.wall_model != WallTreatment::none)
    throw InputError("-cloth_wall_model " + name_of(system.model.cloth_treatment.wall_model) + needs);
  for (const auto& group : system.model.cloths.groups())
    if (group.permeance > 0) throw InputError("-" + group.name + "_permeance" + needs);
  return scheme.make(system, options);
}

template std::unique_ptr<CouplingScheme<2>> make_coupling_scheme<2>(const CouplingOptions&, System<2>&);
template std::unique_ptr<CouplingScheme<3>> make_coupling_scheme<3>(const CouplingOptions&, System<3>&);

}  // namespace washfsi
