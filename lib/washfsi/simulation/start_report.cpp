// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/start_report.hpp"

#include "washfsi/coupling/coupling_operations.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/trust/start_findings.hpp"

namespace washfsi {

template <int Dim>
Findings judge_start(System<Dim>& system, const Measures<Dim>& measures, const RunOptions& run,
                     const CaseOptions<Dim>& chosen) {
  begin_step(system, system.state.positions, system.state.clock.time, 0);  // forces look at what is near
  const StatisticsOptions& statistics = chosen.measure.statistics;
  const PhaseStatistics* phases = measures.phases();
  const bool samples = statistics.take || phases;
  return start_findings(system, measures.cycles(),
                        {.end = run.time_end,
                         .checkpoint_interval = run.checkpoint_interval,
                         .output_interval = run.output_interval,
                         .history_interval = run.history_interval,
                         .verify_interval = chosen.model.cloth.verify_interval,
                         .sampling_start = samples ? statistics.start : 0,
                         .sampling_interval = samples ? statistics.interval : 0,
                         .phase_period = phases && phases->count() > 1 ? phases->options().period : 0});
}

void refuse_doubts(const StartReport& report) {
  std::vector<std::string> doubts;
  const std::string start = "warning: ";
  for (const std::string& note : report.notes)
    if (note.starts_with(start)) doubts.push_back(note.substr(start.size()));
  for (const Finding& finding : doubtful(report.findings)) doubts.push_back("of " + finding.name + ", " + finding.text);
  if (doubts.empty()) return;
  throw InputError("-strict: " + std::to_string(doubts.size()) + (doubts.size() == 1 ? " warning" : " warnings") +
                   ", the first " + doubts.front());
}

template Findings judge_start<2>(System<2>&, const Measures<2>&, const RunOptions&, const CaseOptions<2>&);
template Findings judge_start<3>(System<3>&, const Measures<3>&, const RunOptions&, const CaseOptions<3>&);

}  // namespace washfsi
