// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace washfsi {

/// The frame of a program: starts MPI, calls `body`, which starts PETSc itself, tells the terminal of errors in one
/// line, ends PETSc and MPI. Returns the exit status: 0, or 2, 3, 4 for InputError, DivergedError, FileError; 2, too,
/// for an error of PETSc that its options explain. Any other error, which may be one rank's alone, aborts all with
/// status 1 and with PETSc's trace.
int run_program(const char* name, const std::function<void()>& body);

}  // namespace washfsi
