// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/progress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/format_text.hpp"

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

void Pace::begin(double wall, long step, double time) {
  from_ = next_ = now_ = {wall, step, time};
  first_ = step;
}

void Pace::advance(double wall, long step, double time) {
  dt_ = (time - now_.time) / static_cast<double>(std::max(1L, step - now_.step));
  if (now_.step == first_ + 1) from_ = next_ = now_;
  now_ = {wall, step, time};
  constexpr double seconds = 20;  // and at least as many steps: frames and checkpoints are part of the pace
  constexpr long steps = 20;
  if (now_.wall - next_.wall < seconds || now_.step - next_.step < steps) return;
  from_ = next_;
  next_ = now_;
}

double Pace::seconds_per_step() const {
  return (now_.wall - from_.wall) / static_cast<double>(std::max(1L, now_.step - from_.step));
}

double Pace::seconds_left(double end) const {
  if (dt_ <= 0 || now_.time >= end) return 0;  // the last step may pass the end
  return seconds_per_step() * std::ceil((end - now_.time) / dt_ - 1e-6);
}

Progress::Progress(MPI_Comm comm)
    : speaks_(rank_of(comm) == 0), on_terminal_(user_sees_a_terminal()), start_(Clock::now()), shown_(start_) {}

double Progress::wall_seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::show(const ProgressState& state) {
  pace_.advance(wall_seconds(), state.step, state.time);
  const auto now = Clock::now();
  const double since = std::chrono::duration<double>(now - shown_).count();
  if (!speaks_ || since < (on_terminal_ ? 0.2 : 5.0)) return;
  shown_ = now;
  std::array<char, 256> line{};
  (void)std::snprintf(line.data(), line.size(),
                      "step %ld  t %.4g of %.4g s  %5.1f %%  CFL %.3f  iterations %.0f + %.0f  %.2f ms/step",
                      state.step, state.time, state.end, std::min(100.0, 100 * state.time / state.end), state.courant,
                      state.momentum_iterations, state.pressure_iterations, 1e3 * pace_.seconds_per_step());
  const std::string left = pace_.is_known() ? format_text("  %.0f s left", pace_.seconds_left(state.end)) : "";
  (void)std::printf(on_terminal_ ? "\r%s%s\033[K" : "%s%s\n", line.data(), left.c_str());
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
