// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "washfsi/output/progress.hpp"
#include "washfsi/simulation/case.hpp"
#include "washfsi/simulation/checkpoint.hpp"
#include "washfsi/simulation/options.hpp"
#include "washfsi/simulation/results.hpp"
#include "washfsi/simulation/step_choice.hpp"
#include "washfsi/simulation/stop_signals.hpp"
#include "washfsi/support/folder_lock.hpp"

namespace washfsi {

/// A run from options to results.
template <int Dim>
class Simulation {
 public:
  /// Reads all options and sets everything up. Collective. Errors: InputError, FileError.
  Simulation(Options& options, const std::string& case_name);

  /// Runs to the end, to a stop signal, or (-check) not at all. Collective. Errors: DivergedError, FileError.
  void run();

 private:
  void start_results(Options& options);
  void judge_start(const CaseOptions<Dim>& chosen);
  void refuse_doubts() const;
  void print_banner();
  void check_only();
  void step();
  void save_checkpoint();
  void watch_step_bound();
  void check_markers() const;
  void check_velocity() const;
  std::string where_it_failed() const;
  bool due(double interval, double time) const;
  bool measures_all(long step, double time) const;
  bool ends(long step, double time, int steps_at_rest) const;
  bool finished() const { return ends(clock().step, clock().time, state_.steps_at_rest); }
  const Clock& clock() const { return system_->state.clock; }
  void watch_rest();
  void end(const std::string& status);
  void print_summary(const RunSummary& summary);

  RunOptions run_;
  std::string coupling_;
  std::vector<std::string> notes_;  ///< notes on the options
  std::vector<Profile<Dim>> profiles_;
  std::unique_ptr<FolderLock> lock_;
  std::unique_ptr<System<Dim>> system_;
  std::unique_ptr<CouplingScheme<Dim>> scheme_;
  std::unique_ptr<StepChoice<Dim>> steps_;
  std::unique_ptr<Measures<Dim>> measures_;
  std::unique_ptr<Results<Dim>> results_;
  Progress progress_;
  RunState state_;
  Findings at_start_;  ///< findings on the case before the first step
  long first_step_ = 0, attempted_step_ = 0, kept_step_ = -1;
  double attempt_start_ = 0;  ///< time before the last attempted step [s]
  bool warned_of_step_ = false;
};

extern template class Simulation<2>;
extern template class Simulation<3>;

}  // namespace washfsi
