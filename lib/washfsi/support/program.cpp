// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/program.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"
#include "washfsi/support/petsc.hpp"
#include "washfsi/support/petsc_options.hpp"

namespace washfsi {

namespace {

// Whether all ranks come here soon: an error may be one rank's alone.
bool all_come() {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  int done = 0;
  const auto start = std::chrono::steady_clock::now();
  while (!done && std::chrono::steady_clock::now() - start < std::chrono::seconds(2))
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  return done != 0;
}

// Exits without finalising MPI, PETSc or HDF5, which may all be in the middle of a call.
[[noreturn]] void leave(int status) {
  (void)all_come();
  std::_Exit(status);
}

// PETSc's error codes that a user's options can cause.
bool may_be_the_user(PetscErrorCode code) {
  static constexpr std::array codes{PETSC_ERR_ARG_OUTOFRANGE, PETSC_ERR_ARG_WRONG, PETSC_ERR_ARG_UNKNOWN_TYPE,
                                    PETSC_ERR_USER_INPUT,     PETSC_ERR_FILE_OPEN, PETSC_ERR_SUP,
                                    PETSC_ERR_ARG_INCOMP,     PETSC_ERR_MEM,       PETSC_ERR_INT_OVERFLOW};
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

// The options for PETSc that may be meant by a message: those whose value is in it; else all.
std::string options_behind(const std::string& message) {
  std::string named, all;
  for (const auto& [name, value] : options_in_database()) {
    if (!is_for_petsc(name)) continue;
    const std::string option = "-" + name + (value.empty() ? "" : " " + value);
    all += (all.empty() ? "" : " ") + option;
    if (!value.empty() && message.find(value) != std::string::npos) named += (named.empty() ? "" : " ") + option;
  }
  return named.empty() ? all : named;
}

void tell(const char* name, const std::string& text, bool on_all) {
  if (on_all || rank_of(MPI_COMM_WORLD) == 0) std::fprintf(stderr, "%s: %s\n", name, text.c_str());
}

// An error that PETSc found.
[[noreturn]] void end_for_petsc(const char* name, const petsc::ErrorTrace& trace) {
  PetscBool initialized = PETSC_FALSE;
  (void)PetscInitialized(&initialized);
  const std::string options = options_behind(trace.message());
  const bool out_of_memory = trace.code() == PETSC_ERR_MEM;
  if (!initialized || (may_be_the_user(trace.code()) && (!options.empty() || out_of_memory))) {
    const bool together = all_come();
    const char* otherwise = initialized ? "out of memory" : "options for PETSc";
    tell(name, (options.empty() ? otherwise : options) + ": " + trace.message(), !together);
    std::_Exit(2);
  }
  tell(name,
       "rank " + std::to_string(rank_of(MPI_COMM_WORLD)) + ": " + trace.message() + "\nThis is an error of " + name +
           " or of PETSc, not yours. Please report it, with the options of the run:",
       true);
  std::fprintf(stderr, "%s", trace.calls().c_str());
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::_Exit(1);
}

// PETSc's stage for a server of solvers, which nobody runs here: -log_view would list it as "Unknown".
void hide_unused_stage() {
  PetscLogStage stage = -1;
  if (PetscLogStageGetId("PCMPI", &stage) == 0 && stage >= 0) (void)PetscLogStageSetVisible(stage, PETSC_FALSE);
}

// PETSc writes reports such as -log_view at its end. After a reported error, another would only distract.
int finalize(const char* name, const petsc::ErrorTrace& trace, bool failed) {
  PetscBool initialized = PETSC_FALSE;
  (void)PetscInitialized(&initialized);
  if (!initialized) return 0;
  const std::string reports = options_behind("");
  hide_unused_stage();
  if (PetscFinalize() == 0 || failed) return 0;
  tell(name, "at the end: " + trace.message() + (reports.empty() ? "" : " (" + reports + ")"), false);
  leave(2);
}

}  // namespace

int run_program(const char* name, const std::function<void()>& body) {
  MPI_Init(nullptr, nullptr);
  const petsc::ErrorTrace trace;
  int status = 0;
  const auto report = [name](const std::exception& error, int with) {
    tell(name, error.what(), false);
    return with;
  };
  try {
    body();
  } catch (const InputError& error) {
    status = report(error, 2);
  } catch (const DivergedError& error) {
    status = report(error, 3);
  } catch (const FileError& error) {
    leave(report(error, 4));  // HDF5 would try once more to close the files that cannot be completed, and crash or hang
  } catch (const petsc::Error&) {
    end_for_petsc(name, trace);
  } catch (const std::bad_alloc&) {
    tell(name, "out of memory: fewer cells, markers or ranks", !all_come());
    std::_Exit(2);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: rank %d: %s\n", name, rank_of(MPI_COMM_WORLD), error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  status = std::max(status, finalize(name, trace, status != 0));
  MPI_Finalize();
  return status;
}

}  // namespace washfsi
