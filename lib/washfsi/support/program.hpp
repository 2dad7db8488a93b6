// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <cstdlib>
#include <functional>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// The frame of a program: starts MPI, calls `body`, which starts PETSc itself, tells rank 0's terminal of errors in
/// one line, ends PETSc and MPI. Returns the exit status: 0, or 2, 3, 4 for InputError, DivergedError, FileError. An
/// error of another kind, which may be one rank's alone, aborts all.
inline int run_program(const char* name, const std::function<void()>& body) {
  MPI_Init(nullptr, nullptr);
  const auto report = [name](const std::exception& error, int status) {
    if (rank_of(MPI_COMM_WORLD) == 0) std::fprintf(stderr, "%s: %s\n", name, error.what());
    return status;
  };
  int status = 0;
  try {
    body();
  } catch (const InputError& error) {
    status = report(error, 2);
  } catch (const DivergedError& error) {
    status = report(error, 3);
  } catch (const FileError& error) {
    (void)report(error, 4);
    // HDF5 would try once more to close the files that cannot be completed, and crash or hang: leave without it
    MPI_Barrier(MPI_COMM_WORLD);
    std::_Exit(4);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: rank %d: %s\n", name, rank_of(MPI_COMM_WORLD), error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  PetscBool initialized = PETSC_FALSE;
  (void)PetscInitialized(&initialized);
  if (initialized) (void)PetscFinalize();
  MPI_Finalize();
  return status;
}

}  // namespace washfsi
