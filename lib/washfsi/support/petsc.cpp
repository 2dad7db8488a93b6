// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/petsc.hpp"

#include <array>

#include <petsc/private/petscimpl.h>  // PetscObjectStateGet is documented for users but declared here

namespace washfsi::petsc {

void check(PetscErrorCode code, const char* call, const char* function, const char* file, int line) {
  if (PetscLikely(code == 0)) return;
  (void)PetscError(PETSC_COMM_SELF, line, function, file, code, PETSC_ERROR_REPEAT, " ");
  throw Error(code, call, file, line);
}

Vector zeros_like(Vec vector) {
  Vector result;
  WASH_PETSC(VecDuplicate(vector, result.put()));
  WASH_PETSC(VecZeroEntries(result));
  return result;
}

Vector copy_of(Vec vector) {
  Vector result;
  WASH_PETSC(VecDuplicate(vector, result.put()));
  WASH_PETSC(VecCopy(vector, result));
  return result;
}

StarForest star_forest(MPI_Comm comm, std::size_t roots, const std::vector<PetscSFNode>& sources) {
  StarForest forest;
  std::vector<PetscSFNode> copy = sources;  // PETSc asks for writable memory
  WASH_PETSC(PetscSFCreate(comm, forest.put()));
  WASH_PETSC(PetscSFSetGraph(forest, static_cast<PetscInt>(roots), static_cast<PetscInt>(copy.size()), nullptr,
                             PETSC_COPY_VALUES, copy.data(), PETSC_COPY_VALUES));
  WASH_PETSC(PetscSFSetUp(forest));
  return forest;
}

PetscErrorCode MutedErrors::remember(MPI_Comm, int, const char*, const char*, PetscErrorCode code, PetscErrorType,
                                     const char* text, void* self) {
  auto& message = static_cast<MutedErrors*>(self)->message_;
  if (message.empty() && text) message = text;
  return code;
}

PetscErrorCode ErrorTrace::remember(MPI_Comm, int line, const char* function, const char* file, PetscErrorCode code,
                                    PetscErrorType type, const char* text, void* self) {
  auto& trace = *static_cast<ErrorTrace*>(self);
  if (type == PETSC_ERROR_INITIAL) {
    trace.message_ = text ? text : "";
    trace.calls_.clear();
    trace.code_ = code;
  }
  if (file)
    trace.calls_ += "  " + std::string(function ? function : "?") + " at " + file + ":" + std::to_string(line) + "\n";
  return code;
}

bool option_given(const std::string& prefix, const std::string& name) {
  PetscBool given = PETSC_FALSE;
  WASH_PETSC(PetscOptionsHasName(nullptr, prefix.empty() ? nullptr : prefix.c_str(), name.c_str(), &given));
  return given == PETSC_TRUE;
}

std::string option_value(const std::string& prefix, const std::string& name, const std::string& otherwise) {
  const char* value = nullptr;
  PetscBool given = PETSC_FALSE;
  WASH_PETSC(PetscOptionsFindPair(nullptr, prefix.empty() ? nullptr : prefix.c_str(), name.c_str(), &value, &given));
  if (!given) return otherwise;
  return value ? value : "";
}

void set_default_option(const std::string& name, const std::string& value) {
  if (!option_given("", name)) WASH_PETSC(PetscOptionsSetValue(nullptr, name.c_str(), value.c_str()));
}

LogPart::LogPart(const char* name) {
  PetscLogStage stage = 0;
  WASH_PETSC(PetscLogStageGetId(name, &stage));
  if (stage < 0) WASH_PETSC(PetscLogStageRegister(name, &stage));
  WASH_PETSC(PetscLogEventGetId(name, &event_));
  if (event_ < 0) {
    PetscClassId class_id = 0;
    WASH_PETSC(PetscClassIdRegister("washfsi", &class_id));
    WASH_PETSC(PetscLogEventRegister(name, class_id, &event_));
  }
  WASH_PETSC(PetscLogStagePush(stage));
  WASH_PETSC(PetscLogEventBegin(event_, 0, 0, 0, 0));
}

LogPart::~LogPart() {
  (void)PetscLogEventEnd(event_, 0, 0, 0, 0);
  (void)PetscLogStagePop();
}

DM dm_of(Vec vector) {
  DM dm = nullptr;
  WASH_PETSC(VecGetDM(vector, &dm));
  return dm;
}

Version::Version(Vec vector) {
  if (!vector) return;
  WASH_PETSC(PetscObjectGetId(reinterpret_cast<PetscObject>(vector), &id));
  WASH_PETSC(PetscObjectStateGet(reinterpret_cast<PetscObject>(vector), &state));
}

}  // namespace washfsi::petsc
