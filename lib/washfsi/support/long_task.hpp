// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include <mpi.h>

namespace washfsi {

/// Prints what the program is doing if that takes longer than two seconds, from construction to destruction of this
/// object. Rank 0 prints, from a thread that does not use MPI.
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
