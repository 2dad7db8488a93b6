// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/shapes/shape.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// The tree of shapes whose options begin with -NAME_: a primitive, or a combination of the parts that -NAME_parts
/// names, whose own options begin with -NAME_PART_. Every shape may be rounded, turned and moved, repeated and
/// inverted, in this order. Where the user gives no option of this shape, one with the prefix `fallback` counts.
/// `sample_spacing` [m] is the default for shapes sampled on a lattice. May return null if the user asked for -help.
/// Errors: InputError. Collective.
template <int Dim>
ShapePtr<Dim> shape_from_options(Options& options, const std::string& name, double sample_spacing,
                                 const std::string& fallback = "");

}  // namespace washfsi
