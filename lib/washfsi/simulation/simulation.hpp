// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "washfsi/output/progress.hpp"
#include "washfsi/simulation/case.hpp"
#include "washfsi/simulation/checkpoint.hpp"
#include "washfsi/simulation/options.hpp"
#include "washfsi/simulation/results.hpp"
#include "washfsi/simulation/schedule.hpp"
#include "washfsi/simulation/start_report.hpp"
#include "washfsi/simulation/stop_signals.hpp"
#include "washfsi/simulation/time_step_control.hpp"
#include "washfsi/support/folder_lock.hpp"

namespace washfsi {

/// A run from options to results.
template <int Dim>
class Simulation {
 public:
  /// Reads all options and sets everything up. Collective. Errors: InputError, FileError.
  Simulation(Options& options, const std::string& case_name);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Runs to the end, to a stop signal, or (-check) not at all. Collective. Errors: DivergedError, FileError.
  void run();

 private:
  void set_up(Options& options, const CaseOptions<Dim>& chosen);
  void go_on_from_checkpoint(MPI_Comm comm);
  void take_notes(Options& options);
  void open_folder(const Options& options);
  void start_results(MPI_Comm comm, std::vector<Profile<Dim>> profiles);
  void print_banner();
  void check_only();
  void step();
  void observe(bool all);
  void write_due(bool all);
  void save_checkpoint();
  void watch_step_bound();
  const Clock& clock() const { return system_->state.clock; }
  RunSummary summarised(const std::string& status) const;
  void end(const std::string& status);

  struct Attempt {
    long step = 0;
    double start = 0;  ///< time before the step [s]
  };

  RunOptions run_;
  std::unique_ptr<FolderLock> lock_;
  std::unique_ptr<System<Dim>> system_;
  std::unique_ptr<CouplingScheme<Dim>> scheme_;
  std::unique_ptr<TimeStepControl<Dim>> steps_;
  std::unique_ptr<Measures<Dim>> measures_;
  std::unique_ptr<Results<Dim>> results_;
  Progress progress_;
  RunState state_;
  Schedule schedule_{run_, state_};
  StartReport start_;
  Attempt attempt_;      ///< the step that was begun last
  long kept_step_ = -1;  ///< step of the last checkpoint in the output folder; -1: none
  bool warned_of_step_ = false;
};

extern template class Simulation<2>;
extern template class Simulation<3>;

}  // namespace washfsi
