// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/fluid/liquid.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// The models that the user asks for, each by options of its own. Errors: InputError.
template <int Dim>
ViscosityModels<Dim> viscosity_models_from_options(Options& options);

}  // namespace washfsi
