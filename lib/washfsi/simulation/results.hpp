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

/// How a run ended, for summary.json.
struct RunSummary {
  std::string case_name, status;
  long steps = 0;
  double time = 0;          ///< simulated [s]
  double wall_seconds = 0;  ///< of this start of the program
  double seconds_per_step = 0;
  Findings at_start, at_end;  ///< how far to believe it
};

/// Everything that a run leaves in its output folder.
template <int Dim>
class Results {
 public:
  /// Collective. Errors: FileError. `restart_step` < 0: a new run.
  Results(const System<Dim>& system, Measures<Dim>& measures, std::vector<Profile<Dim>> profiles, std::string folder,
          long restart_step);

  /// Whether a folder has the history of an earlier run. Collective.
  static bool holds_a_run(MPI_Comm comm, const std::string& folder);

  /// Whether it has the summary that a run writes last. Collective.
  static bool holds_an_end(MPI_Comm comm, const std::string& folder);

  /// Removes what an earlier run wrote last, for a run that goes on from it. Collective.
  static void remove_summary(MPI_Comm comm, const std::string& folder);
  /// Removes all that an earlier run wrote at its end, or to go on from. Collective.
  static void remove_ends(MPI_Comm comm, const std::string& folder);

  /// Starts history.csv, tracks.csv and cycles.csv, or continues them after `restart_step`. Collective. Errors:
  /// FileError.
  void open_history(long restart_step);
  /// A frame of each series.
  void write_frame(long step);
  /// A row of history.csv and of tracks.csv, and one of cycles.csv if a cycle ends.
  void write_row(long step);
  /// Profiles and the final marker table.
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
