// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include <mpi.h>

namespace washfsi {

/// Says what the program is doing if that takes longer than two seconds: from its construction to its destruction.
/// Rank 0 speaks, by a thread that knows nothing of MPI.
class LongTask {
 public:
  LongTask(MPI_Comm comm, std::string what);
  ~LongTask();
  LongTask(const LongTask&) = delete;
  LongTask& operator=(const LongTask&) = delete;

 private:
  void speak_unless_done();

  std::string what_;
  bool done_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::thread speaker_;
};

}  // namespace washfsi
