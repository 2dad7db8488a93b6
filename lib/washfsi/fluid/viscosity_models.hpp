// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/fluid/liquid.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// Returns the models that the user chose, each by options of its own. Errors: InputError.
template <int Dim>
ViscosityModels<Dim> viscosity_models_from_options(Options& options);

}  // namespace washfsi
