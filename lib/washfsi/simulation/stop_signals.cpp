// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/stop_signals.hpp"

#include <csignal>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

volatile std::sig_atomic_t stop_requested = 0;  // a signal handler can reach nothing else

void request_stop(int) {
  stop_requested = 1;
}

}  // namespace

StopSignals::StopSignals() {
  stop_requested = 0;
  (void)std::signal(SIGTERM, request_stop);
  (void)std::signal(SIGINT, request_stop);
}

StopSignals::~StopSignals() {
  (void)std::signal(SIGTERM, SIG_DFL);
  (void)std::signal(SIGINT, SIG_DFL);
}

bool StopSignals::requested(MPI_Comm comm) const {
  return any_rank(comm, stop_requested != 0);
}

}  // namespace washfsi
