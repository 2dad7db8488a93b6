// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/long_task.hpp"

#include <chrono>
#include <cstdio>

#include "washfsi/support/collective.hpp"

namespace washfsi {

LongTask::LongTask(MPI_Comm comm, std::string what) : what_(std::move(what)) {
  if (rank_of(comm) == 0) speaker_ = std::thread([this] { speak_unless_done(); });
}

LongTask::~LongTask() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  ended_.notify_one();
  if (speaker_.joinable()) speaker_.join();
}

void LongTask::speak_unless_done() {
  std::unique_lock lock(mutex_);
  if (ended_.wait_for(lock, std::chrono::seconds(2), [this] { return done_; })) return;
  (void)std::printf("note: %s ...\n", what_.c_str());
  (void)std::fflush(stdout);
}

}  // namespace washfsi
