// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/support/petsc.hpp"

namespace washfsi::test {

/// An option that is set while the guard lives.
class ScopedOption {
 public:
  ScopedOption(std::string name, const char* value) : name_(std::move(name)) {
    if (value) WASH_PETSC(PetscOptionsSetValue(nullptr, name_.c_str(), value));
  }
  ~ScopedOption() { (void)PetscOptionsClearValue(nullptr, name_.c_str()); }
  ScopedOption(const ScopedOption&) = delete;
  ScopedOption& operator=(const ScopedOption&) = delete;

 private:
  std::string name_;
};

}  // namespace washfsi::test
