// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/eddy_viscosity.hpp"

#include <algorithm>

#include "washfsi/fluid/sigma.hpp"
#include "washfsi/fluid/vreman.hpp"
#include "washfsi/fluid/wale.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

struct NamedLaw {
  const char* name;
  double constant;  ///< default of the law's constant
  std::shared_ptr<const ViscosityModel<3>> (*make)(double constant);
};

template <class Law>
std::shared_ptr<const ViscosityModel<3>> make(double constant) {
  return std::make_shared<EddyViscosity<Law>>(constant);
}

// All laws.
constexpr std::array laws{NamedLaw{"vreman", 0.07, make<Vreman>}, NamedLaw{"sigma", 1.35, make<Sigma>},
                          NamedLaw{"wale", 0.5, make<Wale>}};

}  // namespace

template <int Dim>
std::shared_ptr<const ViscosityModel<Dim>> eddy_viscosity_from_options(Options& options) {
  std::string name = "none";
  double constant = 0;
  std::vector<std::string> names{name};
  for (const NamedLaw& law : laws) names.emplace_back(law.name);
  options.block("", "Turbulence", [&](OptionBlock& block) {
    block.choice("turbulence", name, names, "eddy viscosity of what is smaller than a cell, in space");
    block.real("turbulence_constant", constant, "-", {0.0, 10.0, false, "a number from 0 to 10"},
               "its constant; 0: vreman 0.07, sigma 1.35, wale 0.5");
  });
  if (name == "none") {
    options.mark_idle("-turbulence is none", {"turbulence_constant"});
    return nullptr;
  }
  if constexpr (Dim == 2) {
    throw InputError("-turbulence " + name + ": needs three dimensions; eddies in the plane do not break up, use none");
  } else {
    const auto law = std::ranges::find_if(laws, [&](const NamedLaw& one) { return one.name == name; });
    return law->make(constant > 0 ? constant : law->constant);
  }
}

template std::shared_ptr<const ViscosityModel<2>> eddy_viscosity_from_options<2>(Options&);
template std::shared_ptr<const ViscosityModel<3>> eddy_viscosity_from_options<3>(Options&);

}  // namespace washfsi
