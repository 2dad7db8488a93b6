// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>

#include "washfsi/support/petsc.hpp"

namespace washfsi::test {

/// PETSc's options are those of a text as long as this lives.
class OptionDatabase {
 public:
  explicit OptionDatabase(const std::string& text) {
    std::string line = text.starts_with('#') ? text.substr(text.find('\n')) : text;  // resolved options begin so
    std::replace(line.begin(), line.end(), '\n', ' ');
    WASH_PETSC(PetscOptionsCreate(&database_));
    WASH_PETSC(PetscOptionsInsertString(database_, line.c_str()));
    WASH_PETSC(PetscOptionsPush(database_));
  }
  ~OptionDatabase() {
    (void)PetscOptionsPop();
    (void)PetscOptionsDestroy(&database_);
  }
  OptionDatabase(const OptionDatabase&) = delete;
  OptionDatabase& operator=(const OptionDatabase&) = delete;

 private:
  PetscOptions database_ = nullptr;
};

}  // namespace washfsi::test
