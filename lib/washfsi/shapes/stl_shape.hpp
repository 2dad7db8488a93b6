// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/shapes/shape.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// -NAME_file, -NAME_scale and -NAME_sample_spacing.
struct StlOptions {
  std::string file;
  double scale = 1;           ///< [m] per unit of the file
  double sample_spacing = 0;  ///< spacing of the lattice on which the distance is sampled [m]

  void read(OptionBlock& block);
};

/// The solid in the closed surface of an STL file, its distance sampled on a lattice around it. `name` is the prefix of
/// its options. Warns of shells that may be cavities turned outwards. Errors: InputError. Collective.
ShapePtr<3> shape_from_stl(Options& options, const StlOptions& stl, const std::string& name);

}  // namespace washfsi
