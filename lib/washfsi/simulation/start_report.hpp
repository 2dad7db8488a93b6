// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/simulation/case.hpp"
#include "washfsi/simulation/options.hpp"
#include "washfsi/trust/finding.hpp"

namespace washfsi {

/// What a run tells before its first step, beside what the system itself is.
struct StartReport {
  std::string coupling;            ///< to what cloths are coupled, and how
  std::vector<std::string> notes;  ///< notes and warnings on the options
  Findings findings;               ///< findings on the case
};

/// Finds how far to trust the system as it is at the start, also of a restart. Forces look at what is near. Collective.
template <int Dim>
Findings judge_start(System<Dim>& system, const Measures<Dim>& measures, const RunOptions& run,
                     const CaseOptions<Dim>& chosen);

/// Refuses what the program warns of, for -strict. Errors: InputError if there are warnings or doubtful findings.
void refuse_doubts(const StartReport& report);

extern template Findings judge_start<2>(System<2>&, const Measures<2>&, const RunOptions&, const CaseOptions<2>&);
extern template Findings judge_start<3>(System<3>&, const Measures<3>&, const RunOptions&, const CaseOptions<3>&);

}  // namespace washfsi
