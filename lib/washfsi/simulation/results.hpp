// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "washfsi/measure/measures.hpp"
#include "washfsi/output/profile.hpp"
#include "washfsi/output/series.hpp"
#include "washfsi/output/surface_series.hpp"
#include "washfsi/trust/finding.hpp"

namespace washfsi {

/// The end of a run, for summary.json.
struct RunSummary {
  std::string case_name, status;
  long steps = 0;
  double time = 0;          ///< simulated time [s]
  double wall_seconds = 0;  ///< wall time since this start of the program [s]
  double seconds_per_step = 0;
  Findings at_start, at_end;  ///< findings on how far to trust it
};

/// All output of a run in its folder.
template <int Dim>
class Results {
 public:
  /// Collective. Errors: FileError. `restart_step` < 0: a new run.
  Results(const System<Dim>& system, Measures<Dim>& measures, std::vector<Profile<Dim>> profiles, std::string folder,
          long restart_step);

  /// Whether a folder contains the history of an earlier run. Collective.
  static bool holds_a_run(MPI_Comm comm, const std::string& folder);

  /// Whether a folder contains the summary, which a run writes last. Collective.
  static bool holds_an_end(MPI_Comm comm, const std::string& folder);

  /// Removes the summary of an earlier run, for a run that continues it. Collective.
  static void remove_summary(MPI_Comm comm, const std::string& folder);
  /// Removes all files that an earlier run wrote at its end, or for a restart. Collective.
  static void remove_ends(MPI_Comm comm, const std::string& folder);

  /// Starts history.csv, tracks.csv and cycles.csv, or continues them after `restart_step`. Collective. Errors:
  /// FileError.
  void open_history(long restart_step);
  /// Writes a frame of each series.
  void write_frame(long step);
  /// Writes a row of history.csv and of tracks.csv, and one of cycles.csv if a cycle ends.
  void write_row(long step);
  /// Writes profiles and the final marker table.
  void write_final() const;
  void write_summary(const RunSummary& summary) const;

 private:
  const System<Dim>& system_;
  Measures<Dim>& measures_;
  std::vector<Profile<Dim>> profiles_;
  std::string folder_;
  FlowSeries<Dim> flow_;
  std::optional<BodySeries<Dim>> bodies_;
  std::optional<SurfaceSeries<Dim>> surfaces_;
  std::optional<ClothSeries<Dim>> cloth_;
  std::optional<History> history_, tracks_, cycles_;
  long last_frame_ = -1;
};

/// Largest resident memory of all ranks together [bytes]. Collective.
double peak_memory(MPI_Comm comm);

extern template class Results<2>;
extern template class Results<3>;

}  // namespace washfsi
