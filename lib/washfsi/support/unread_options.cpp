// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/unread_options.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "washfsi/support/errors.hpp"
#include "washfsi/support/petsc.hpp"
#include "washfsi/support/petsc_options.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

// The known name that is most like another; empty if none is.
std::string nearest(const OptionRegister& options, const std::string& name) {
  std::string best;
  std::size_t smallest = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const auto* names : {&options.declared.values(), &options.left_out.reasons()})
    for (const auto& [known, value] : *names) {
      const std::size_t distance = edit_distance(name, known);
      if (distance < smallest) {
        smallest = distance;
        best = known;
      }
    }
  return best;
}

bool is_unread(const OptionRegister& options, const std::string& name, const std::string& value) {
  PetscBool used = PETSC_FALSE;
  WASH_PETSC(PetscOptionsUsed(nullptr, name.c_str(), &used));
  if (!used && lacks_prefix(name))
    throw InputError("-" + name + (value.empty() ? "" : " " + value) +
                     ": no solver is without a prefix; say -pressure_" + name + ", -momentum_" + name + " or -cloth_" +
                     name);
  return !used && !options.declared.contains(name) && !belongs_to_petsc(name) && !is_read_after_solving(name);
}

[[noreturn]] void refuse_unread(const OptionRegister& options, const std::string& name, const std::string& value) {
  const std::string start = "-" + name + (value.empty() ? "" : " " + value) + ": ";
  if (const auto answer = options.answers.find(name); answer != options.answers.end())
    throw InputError(start + answer->second);
  const std::string suggestion = nearest(options, name);
  throw InputError(start + "no part of this run reads this option" +
                   (suggestion.empty() ? " (-help lists all)" : "; did you mean -" + suggestion + "?"));
}

using NamesByReason = std::map<std::string, std::vector<std::string>>;

// The options in PETSc's database that were left out.
NamesByReason left_out_of_database(const OptionRegister& options) {
  NamesByReason names;
  const auto& reasons = options.left_out.reasons();
  for (const auto& [name, value] : options_in_database()) {
    if (!is_unread(options, name, value)) continue;
    const auto left_out = reasons.find(name);
    if (left_out == reasons.end()) refuse_unread(options, name, value);
    if (!options.given.is_recorded(name)) names[left_out->second].push_back("-" + name);
  }
  return names;
}

}  // namespace

std::vector<std::string> reject_unread_options(const OptionRegister& options) {
  NamesByReason without_effect = left_out_of_database(options), overridden;
  for (const auto& [name, reason] : options.declared.idle_as_given(options.given)) {
    const std::string cause = reason.substr(0, reason.find(' '));
    const bool later = cause.starts_with('-') &&
                       options.given.given_elsewhere_after(name, options.old_names.as_given(cause.substr(1)));
    (later ? overridden : without_effect)[reason].push_back("-" + name);
  }
  std::vector<std::string> notes;
  const auto tell = [&](const std::string& kind, const NamesByReason& reasons) {
    for (const auto& [reason, names] : reasons)
      notes.push_back(kind + reason + ", so without effect: " + join(names, " "));
  };
  tell("warning: ", without_effect);
  tell("note: ", overridden);
  return notes;
}

}  // namespace washfsi
