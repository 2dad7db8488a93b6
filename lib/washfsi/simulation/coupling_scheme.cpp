// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/coupling_scheme.hpp"

#include <functional>
#include <map>

#include "washfsi/simulation/explicit_coupling.hpp"

namespace washfsi {

template <int Dim>
std::unique_ptr<CouplingScheme<Dim>> make_coupling_scheme(const std::string& name) {
  const std::map<std::string, std::function<std::unique_ptr<CouplingScheme<Dim>>()>> schemes{
      {"explicit", [] { return std::make_unique<ExplicitCoupling<Dim>>(); }}};
  return schemes.at(name)();
}

template std::unique_ptr<CouplingScheme<2>> make_coupling_scheme<2>(const std::string&);
template std::unique_ptr<CouplingScheme<3>> make_coupling_scheme<3>(const std::string&);

}  // namespace washfsi
