// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/viscosity_models.hpp"

#include "washfsi/fluid/eddy_viscosity.hpp"

namespace washfsi {

// Every model that there is: reads its options and gives nothing if it is not asked for.
template <int Dim>
ViscosityModels<Dim> viscosity_models_from_options(Options& options) {
  ViscosityModels<Dim> models{eddy_viscosity_from_options<Dim>(options)};
  std::erase(models, nullptr);
  return models;
}

template ViscosityModels<2> viscosity_models_from_options<2>(Options&);
template ViscosityModels<3> viscosity_models_from_options<3>(Options&);

}  // namespace washfsi
