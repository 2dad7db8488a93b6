// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/progress.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Open MPI gives its processes a pseudo terminal even when mpirun itself is piped: ask for mpirun's own output then.
bool user_sees_a_terminal() {
  if (isatty(STDOUT_FILENO) == 0) return false;
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr) return true;
  const std::string path = "/proc/" + std::to_string(getppid()) + "/fd/1";
  const int output = open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (output < 0) return false;
  const bool terminal = isatty(output) != 0;
  (void)close(output);
  return terminal;
}

}  // namespace

Progress::Progress(MPI_Comm comm)
    : speaks_(rank_of(comm) == 0), on_terminal_(user_sees_a_terminal()), start_(Clock::now()), shown_(start_) {}

double Progress::wall_seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::show(const ProgressState& state) {
  if (first_step_ < 0) first_step_ = state.step - 1;
  const auto now = Clock::now();
  const double since = std::chrono::duration<double>(now - shown_).count();
  if (!speaks_ || since < (on_terminal_ ? 0.2 : 5.0)) return;
  shown_ = now;
  const double per_step = wall_seconds() / static_cast<double>(state.step - first_step_);
  const double dt = state.time / static_cast<double>(state.step);
  const double left = per_step * std::max(0.0, state.end - state.time) / dt;  // the last step may pass the end
  std::array<char, 256> line{};
  (void)std::snprintf(
      line.data(), line.size(),
      "step %ld  t %.4g of %.4g s  %5.1f %%  CFL %.3f  iterations %.0f + %.0f  %.2f ms/step  %.0f s left", state.step,
      state.time, state.end, std::min(100.0, 100 * state.time / state.end), state.courant, state.momentum_iterations,
      state.pressure_iterations, 1e3 * per_step, left);
  (void)std::printf(on_terminal_ ? "\r%s\033[K" : "%s\n", line.data());
  (void)std::fflush(stdout);
  line_open_ = on_terminal_;
}

void Progress::finish() {
  if (speaks_ && line_open_) (void)std::printf("\n");
  line_open_ = false;
  if (speaks_) (void)std::fflush(stdout);
}

void Progress::note(const std::string& line) {
  finish();
  if (speaks_) (void)std::printf("%s\n", line.c_str());
  if (speaks_) (void)std::fflush(stdout);
}

}  // namespace washfsi
