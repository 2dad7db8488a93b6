// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mpi.h>

namespace washfsi {

/// While it lives, SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGXCPU and SIGUSR1 ask for a stop after the step instead of
/// killing the program.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Whether any rank has been asked to stop. Collective.
  bool requested(MPI_Comm comm) const;
};

}  // namespace washfsi
