// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <petscdmda.h>
#include <petscksp.h>
#include <petscsf.h>
#include <petscsnes.h>

namespace washfsi::petsc {

/// A PETSc call failed. Unless muted, PETSc has printed its own trace.
class Error : public std::runtime_error {
 public:
  Error(PetscErrorCode code, const char* call, const char* file, int line)
      : std::runtime_error(std::string(file) + ":" + std::to_string(line) + ": " + call + " returned PETSc error " +
                           std::to_string(code)),
        code_(code) {}
  PetscErrorCode code() const noexcept { return code_; }

 private:
  PetscErrorCode code_;
};

/// Turns a PETSc return code into an exception.
void check(PetscErrorCode code, const char* call, const char* function, const char* file, int line);

/// Calls PETSc from C++ code. Not for use in `main` itself, where PETSc would abort.
#define WASH_PETSC(call) ::washfsi::petsc::check((call), #call, __func__, __FILE__, __LINE__)

/// Runs C++ code inside a callback that PETSc calls: no exception may cross C frames.
template <std::invocable Body>
PetscErrorCode guarded(Body&& body) noexcept {
  try {
    std::forward<Body>(body)();
    return 0;
  } catch (const Error& error) {
    return error.code();
  } catch (const std::exception& error) {
    return PetscError(PETSC_COMM_SELF, __LINE__, "callback", __FILE__, PETSC_ERR_LIB, PETSC_ERROR_INITIAL, "%s",
                      error.what());
  }
}

/// Sole owner of one reference to a PETSc object. Destruction is collective on its communicator.
template <class T, PetscErrorCode (*Destroy)(T*)>
class Handle {
 public:
  Handle() = default;
  Handle(Handle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { reset(); }

  /// The address to give to a PETSc function that creates the object.
  [[nodiscard]] T* put() noexcept {
    reset();
    return &object_;
  }
  operator T() const noexcept { return object_; }

  /// Destroys the object, unless an exception is unwinding: other ranks may not come here, so it is leaked instead.
  void reset() noexcept {
    PetscBool finalized = PETSC_FALSE;
    (void)PetscFinalized(&finalized);
    if (object_ && !finalized && std::uncaught_exceptions() == 0) (void)Destroy(&object_);
    object_ = nullptr;
  }

 private:
  T object_ = nullptr;
};

using Dm = Handle<DM, DMDestroy>;
using Vector = Handle<Vec, VecDestroy>;
using Matrix = Handle<Mat, MatDestroy>;
using Solver = Handle<KSP, KSPDestroy>;
using NonlinearSolver = Handle<SNES, SNESDestroy>;
using StarForest = Handle<PetscSF, PetscSFDestroy>;
using NullSpace = Handle<MatNullSpace, MatNullSpaceDestroy>;
using Layout = Handle<PetscLayout, PetscLayoutDestroy>;

/// A new vector of the same layout, set to zero.
Vector zeros_like(Vec vector);
/// A copy of a vector.
Vector copy_of(Vec vector);

/// A star forest whose leaf i has the root `sources[i]` (rank and place there), among `roots` roots on this rank.
/// Collective.
StarForest star_forest(MPI_Comm comm, std::size_t roots, const std::vector<PetscSFNode>& sources);

/// A temporary vector of a DM, returned at the end of the scope, so that its memory is reused; its initial values are
/// arbitrary.
template <auto Get, auto Restore>
class TemporaryVector {
 public:
  explicit TemporaryVector(DM dm) : dm_(dm) { WASH_PETSC(Get(dm_, &vector_)); }
  ~TemporaryVector() { (void)Restore(dm_, &vector_); }
  TemporaryVector(const TemporaryVector&) = delete;
  TemporaryVector& operator=(const TemporaryVector&) = delete;
  operator Vec() const noexcept { return vector_; }

 private:
  DM dm_;
  Vec vector_ = nullptr;
};

using GlobalVector = TemporaryVector<DMGetGlobalVector, DMRestoreGlobalVector>;

/// A temporary local (ghosted) vector.
class LocalVector : public TemporaryVector<DMGetLocalVector, DMRestoreLocalVector> {
 public:
  using TemporaryVector::TemporaryVector;
  /// Starts as the ghosted copy of a global vector. Collective.
  LocalVector(DM dm, Vec global) : LocalVector(dm) { WASH_PETSC(DMGlobalToLocal(dm, global, INSERT_VALUES, *this)); }
};

/// The DM that a vector was created by.
DM dm_of(Vec vector);

/// The version of an object, by which later changes are detected: PETSc counts them.
struct Version {
  PetscObjectId id = 0;
  PetscObjectState state = 0;

  Version() = default;
  explicit Version(Vec vector);  ///< null is a version too
  bool operator==(const Version&) const = default;
};

/// While it lives, a failing PETSc call prints nothing; `message` keeps the first thing PETSc said.
class MutedErrors {
 public:
  MutedErrors() { (void)PetscPushErrorHandler(remember, this); }
  ~MutedErrors() { (void)PetscPopErrorHandler(); }
  MutedErrors(const MutedErrors&) = delete;
  MutedErrors& operator=(const MutedErrors&) = delete;
  const std::string& message() const noexcept { return message_; }

 private:
  static PetscErrorCode remember(MPI_Comm, int, const char*, const char*, PetscErrorCode code, PetscErrorType,
                                 const char* text, void* self);
  std::string message_;
};

/// While it lives, and no `MutedErrors`, failing PETSc calls print nothing; it stores the last failure and the calls
/// that led to it.
class ErrorTrace {
 public:
  ErrorTrace() { (void)PetscPushErrorHandler(remember, this); }
  ErrorTrace(const ErrorTrace&) = delete;
  ErrorTrace& operator=(const ErrorTrace&) = delete;
  const std::string& message() const noexcept { return message_; }
  PetscErrorCode code() const noexcept { return code_; }
  const std::string& calls() const noexcept { return calls_; }  ///< one a line, the innermost first

 private:
  static PetscErrorCode remember(MPI_Comm, int line, const char* function, const char* file, PetscErrorCode code,
                                 PetscErrorType type, const char* text, void* self);
  std::string message_, calls_;
  PetscErrorCode code_ = 0;
};

/// Whether an option is in the database, set by the user or as a default of ours. Names begin with a dash.
bool option_given(const std::string& prefix, const std::string& name);
/// The value of an option in the database, or a default.
std::string option_value(const std::string& prefix, const std::string& name, const std::string& otherwise);
/// Sets an option in the database unless the user has: how our solver defaults reach options-only settings.
void set_default_option(const std::string& name, const std::string& value);

/// Counts and times one part of the method in -log_view, as a stage and as an event, from construction to the end of
/// the scope.
class LogPart {
 public:
  explicit LogPart(const char* name);
  ~LogPart();
  LogPart(const LogPart&) = delete;
  LogPart& operator=(const LogPart&) = delete;

 private:
  PetscLogEvent event_ = 0;
};

}  // namespace washfsi::petsc
