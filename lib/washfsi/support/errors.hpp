// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace washfsi {

/// A mistake of the user, found before the first step. Thrown by all ranks alike; the program prints its one
/// line on rank 0 and ends with status 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The run has failed (not finite, too fast, a solver that diverges). Thrown by all ranks; status 3.
class DivergedError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or folder cannot be written. Thrown by all ranks; status 4.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace washfsi
