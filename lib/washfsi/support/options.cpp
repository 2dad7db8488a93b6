// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/options.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>

#include "washfsi/support/errors.hpp"
#include "washfsi/support/petsc.hpp"
#include "washfsi/support/petsc_options.hpp"
#include "washfsi/support/unread_options.hpp"

namespace washfsi {

namespace {

// PetscOptionsBegin expands to PetscCall, so it needs a function that returns PetscErrorCode.
PetscErrorCode open_block(MPI_Comm comm, const char* prefix, const char* title,
                          const std::function<void(PetscOptionItems*)>& body) {
  PetscFunctionBeginUser;
  PetscOptionsBegin(comm, prefix, title, "washfsi");
  body(PetscOptionsObject);
  PetscOptionsEnd();
  PetscFunctionReturn(0);
}

}  // namespace

Options::Options(MPI_Comm comm, bool documents, GivenOptions given) : comm_(comm), documents_(documents) {
  register_.given = std::move(given);
  PetscBool asked = PETSC_FALSE;
  WASH_PETSC(PetscOptionsHasHelp(nullptr, &asked));
  register_.help = asked == PETSC_TRUE || documents;
}

std::vector<std::string> Options::examples(const char* name, const char* placeholder) const {
  if (!register_.help) return {};
  return {documents_ ? placeholder : name};
}

void Options::block(const std::string& prefix, const std::string& title,
                    const std::function<void(OptionBlock&)>& declare, const std::string& fallback) {
  if (register_.left_out.is_leaving_out()) {
    OptionBlock block(register_, nullptr, title, prefix, fallback);
    return declare(block);
  }
  std::exception_ptr failure;  // an exception must not leave PETSc's block half open
  WASH_PETSC(open_block(comm_, prefix.c_str(), title.c_str(), [&](PetscOptionItems* items) {
    try {
      OptionBlock block(register_, items, title, prefix, fallback);
      declare(block);
    } catch (...) {
      failure = std::current_exception();
    }
  }));
  if (failure) std::rethrow_exception(failure);
}

void Options::claim_prefix(const std::string& name, const std::string& option) {
  static constexpr std::array<std::string_view, 18> ours{
      "grid",    "bc",       "fluid",    "body", "bodies", "machine",    "cloth",    "cloths", "delta",
      "contact", "momentum", "pressure", "time", "output", "checkpoint", "coupling", "walls",  "statistics"};
  const std::string lower = documents_ ? name : lower_case(name);  // PETSc takes no notice of case
  const bool reserved = std::find(ours.begin(), ours.end(), lower) != ours.end() || belongs_to_petsc(lower + "_");
  if (reserved || !claimed_.insert(lower).second)
    throw InputError(option + " " + name + ": this name is taken by another part of the run; choose another");
}

void Options::alias(const std::string& old_name, const std::string& name) {
  if (register_.old_names.replace(old_name, name, register_.given))
    notes_.push_back("note: -" + old_name + " is the old name of -" + name);
}

void Options::alias_value(const std::string& name, const std::string& old_value, const std::string& value) {
  if (petsc::option_value("", "-" + name, "") != old_value) return;
  WASH_PETSC(PetscOptionsSetValue(nullptr, ("-" + name).c_str(), value.c_str()));
  notes_.push_back("note: -" + name + " " + old_value + " is the old name of " + value);
}

void Options::leave_out(const std::string& reason, const std::function<void()>& declare) {
  if (!register_.help) register_.left_out.leave_out(reason, declare);
}

void Options::leave_out_dropped(const std::string& list, const std::vector<std::string>& present,
                                const std::function<void(const std::string& name)>& declare) {
  for (const std::string& name : register_.given.dropped(list, present))
    leave_out("-" + list + " does not name " + name + " any more", [&] { declare(name); });
}

void Options::reject_unread() {
  const std::vector<std::string> without_effect = reject_unread_options(register_);
  notes_.insert(notes_.end(), without_effect.begin(), without_effect.end());
}

std::string Options::resolved() const {
  std::string text = std::string(resolved_head) + "\n";
  for (const auto& [name, value] : register_.declared.values())
    if (!value.empty()) text += "-" + name + " " + quoted(value) + "\n";
  const auto& left_out = register_.left_out.reasons();
  for (const auto& [name, value] : options_in_database())
    if (!register_.declared.contains(name) && !left_out.contains(name) && name != "options_file")
      text += "-" + name + (value.empty() ? "" : " " + quoted(value)) + "\n";
  return text;
}

}  // namespace washfsi
