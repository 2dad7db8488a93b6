// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/stop_signals.hpp"

#include <array>
#include <csignal>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

volatile std::sig_atomic_t stop_requested = 0;  // a signal handler can reach nothing else

constexpr std::array stopping{SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGXCPU, SIGUSR1};

void request_stop(int) {
  stop_requested = 1;
}

}  // namespace

StopSignals::StopSignals() {
  stop_requested = 0;
  for (const int signal : stopping) (void)std::signal(signal, request_stop);
}

StopSignals::~StopSignals() {
  for (const int signal : stopping) (void)std::signal(signal, SIG_DFL);
}

bool StopSignals::requested(MPI_Comm comm) const {
  return any_rank(comm, stop_requested != 0);
}

}  // namespace washfsi
