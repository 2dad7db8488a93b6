// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/refinement.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/text.hpp"

namespace washfsi {

Refinement Refinement::from_options(Options& options) {
  constexpr Range factors{0.1, 10.0, false, "a number from 0.1 to 10"};
  Refinement refinement;
  options.block("", "Refinement", [&](OptionBlock& block) {
    block.real("refine", refinement.factor_, "-", factors,
               "so many times as many cells and markers along each axis, so many times shorter -time_step and contact "
               "distances, where they are given; below 1: coarser");
  });
  if (refinement.factor_ != 1) options.record("refine", "1");
  return refinement;
}

void Refinement::multiply(Options& options, const std::string& name, std::vector<double>& counts, double ends) const {
  if (factor_ == 1) return;
  std::vector<std::string> texts;
  for (double& count : counts) {
    if (count > 1) count = std::max(2.0, std::round(factor_ * (count - ends)) + ends);
    texts.push_back(to_text(count));
  }
  options.record(name, join(texts, ","));
}

void Refinement::divide(Options& options, const std::string& name, double& value) const {
  if (factor_ == 1 || value == 0) return;
  value /= factor_;
  options.record(name, to_text(value));
}

}  // namespace washfsi
