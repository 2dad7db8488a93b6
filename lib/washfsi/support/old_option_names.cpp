// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/old_option_names.hpp"

#include "washfsi/support/errors.hpp"
#include "washfsi/support/petsc.hpp"
#include "washfsi/support/petsc_options.hpp"

namespace washfsi {

bool OldOptionNames::replace(const std::string& old_name, const std::string& name, const GivenOptions& given) {
  all_.emplace_back(old_name, name);
  if (!petsc::option_given("", "-" + old_name)) return false;
  const bool both = petsc::option_given("", "-" + name);
  const bool old_on_line = given.on_command_line(old_name), new_on_line = given.on_command_line(name);
  if (both && old_on_line == new_on_line)
    throw InputError("-" + old_name + ": is the old name of -" + name + ", which is given too; leave one out");
  const std::string value = petsc::option_value("", "-" + old_name, "");
  WASH_PETSC(PetscOptionsClearValue(nullptr, ("-" + old_name).c_str()));
  if (both && new_on_line) return false;  // it overrides the file
  WASH_PETSC(PetscOptionsSetValue(nullptr, ("-" + name).c_str(), value.empty() ? nullptr : value.c_str()));
  used_[name] = old_name;
  return true;
}

std::string OldOptionNames::as_given(const std::string& name) const {
  const auto old = used_.find(name);
  return old == used_.end() ? name : old->second;
}

}  // namespace washfsi
