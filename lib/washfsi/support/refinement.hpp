// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/support/options.hpp"

namespace washfsi {

/// How many times finer than its options say a run is: -refine. What the options give as a count is multiplied by it,
/// what they give as a numerical length or step is divided.
class Refinement {
 public:
  /// Reads -refine. What is recorded are the options of the refined run, which repeat it without -refine. Errors:
  /// InputError.
  static Refinement from_options(Options& options);

  /// Multiplies the counts of an option and records the new ones, rounded to whole numbers, two or more. A count of one
  /// stays. Multiplies count - ends, then adds ends: 1 where the count is of points and the intervals are refined.
  void multiply(Options& options, const std::string& name, std::vector<double>& counts, double ends = 0) const;
  /// Divides the length [m] or step [s] of an option and records the new one; 0, for the program's choice, stays.
  void divide(Options& options, const std::string& name, double& value) const;

 private:
  double factor_ = 1;
};

}  // namespace washfsi
