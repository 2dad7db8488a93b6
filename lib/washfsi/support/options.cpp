// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/options.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <sstream>
#include <string_view>

#include "washfsi/support/errors.hpp"
#include "washfsi/support/petsc_options.hpp"

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

}  // namespace

Options::Options(MPI_Comm comm, bool documents, GivenOptions given)
    : comm_(comm), documents_(documents), given_(std::move(given)) {
  PetscBool asked = PETSC_FALSE;
  WASH_PETSC(PetscOptionsHasHelp(nullptr, &asked));
  help_ = asked == PETSC_TRUE || documents;
}

std::vector<std::string> Options::examples(const char* name, const char* placeholder) const {
  if (!help_) return {};
  return {documents_ ? placeholder : name};
}

void Options::block(const std::string& prefix, const std::string& title,
                    const std::function<void(OptionBlock&)>& declare, const std::string& fallback) {
  if (!leaving_out_.empty()) {
    OptionBlock block(*this, nullptr, title, prefix, fallback);
    return declare(block);
  }
  std::exception_ptr failure;  // an exception must not leave PETSc's block half open
  WASH_PETSC(open_block(comm_, prefix.c_str(), title.c_str(), [&](PetscOptionItems* items) {
    try {
      OptionBlock block(*this, items, title, prefix, fallback);
      declare(block);
    } catch (...) {
      failure = std::current_exception();
    }
  }));
  if (failure) std::rethrow_exception(failure);
}

void Options::claim_prefix(const std::string& name, const std::string& option) {
  static constexpr std::array<std::string_view, 16> ours{
      "grid",  "bc",      "fluid",    "body",     "bodies", "machine", "cloth",      "cloths",
      "delta", "contact", "momentum", "pressure", "time",   "output",  "checkpoint", "coupling"};
  const std::string lower = documents_ ? name : lower_case(name);  // PETSc takes no notice of case
  const bool reserved = std::find(ours.begin(), ours.end(), lower) != ours.end() || belongs_to_petsc(lower + "_");
  if (reserved || !claimed_.insert(lower).second)
    throw InputError(option + " " + name + ": this name is taken by another part of the run; choose another");
}

void Options::alias(const std::string& old_name, const std::string& name) {
  aliases_.emplace_back(old_name, name);
  if (!petsc::option_given("", "-" + old_name)) return;
  const bool both = petsc::option_given("", "-" + name);
  const bool old_on_line = given_.on_command_line(old_name), new_on_line = given_.on_command_line(name);
  if (both && old_on_line == new_on_line)
    throw InputError("-" + old_name + ": is the old name of -" + name + ", which is given too; leave one out");
  const std::string value = database().at(old_name);
  WASH_PETSC(PetscOptionsClearValue(nullptr, ("-" + old_name).c_str()));
  if (both && new_on_line) return;  // it overrides the file
  WASH_PETSC(PetscOptionsSetValue(nullptr, ("-" + name).c_str(), value.empty() ? nullptr : value.c_str()));
  old_names_[name] = old_name;
  notes_.push_back("note: -" + old_name + " is the old name of -" + name);
}

void Options::alias_value(const std::string& name, const std::string& old_value, const std::string& value) {
  if (petsc::option_value("", "-" + name, "") != old_value) return;
  WASH_PETSC(PetscOptionsSetValue(nullptr, ("-" + name).c_str(), value.c_str()));
  notes_.push_back("note: -" + name + " " + old_value + " is the old name of " + value);
}

std::string Options::as_given(const std::string& name) const {
  const auto old = old_names_.find(name);
  return old == old_names_.end() ? name : old->second;
}

void Options::record(const std::string& name, double value) {
  record(name, to_text(value));
}

std::map<std::string, std::string> Options::database() {
  char* text = nullptr;
  WASH_PETSC(PetscOptionsGetAll(nullptr, &text));
  std::map<std::string, std::string> entries;
  std::istringstream words(text);
  std::string key;
  for (std::string word; words >> word;) {
    if (is_option_name(word))
      entries[key = word.substr(1)];
    else if (!key.empty())
      entries[key] += (entries[key].empty() ? "" : " ") + word;
  }
  (void)PetscFree(text);
  return entries;
}

std::string Options::nearest(const std::string& name) const {
  std::string best;
  std::size_t smallest = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const auto* names : {&values_, &left_out_})
    for (const auto& [known, value] : *names) {
      const std::size_t distance = edit_distance(name, known);
      if (distance < smallest) {
        smallest = distance;
        best = known;
      }
    }
  return best;
}

void Options::leave_out(const std::string& reason, const std::function<void()>& declare) {
  if (help_) return;
  const std::string before = std::exchange(leaving_out_, reason);
  try {
    declare();
  } catch (const InputError&) {  // defaults that do not fit each other matter to nobody
  }
  leaving_out_ = before;
}

void Options::leave_out_dropped(const std::string& list, const std::vector<std::string>& present,
                                const std::function<void(const std::string& name)>& declare) {
  for (const std::string& name : given_.dropped(list, present))
    leave_out("-" + list + " does not name " + name + " any more", [&] { declare(name); });
}

bool Options::is_unread(const std::string& name, const std::string& value) const {
  PetscBool used = PETSC_FALSE;
  WASH_PETSC(PetscOptionsUsed(nullptr, name.c_str(), &used));
  if (!used && lacks_prefix(name))
    throw InputError("-" + name + (value.empty() ? "" : " " + value) +
                     ": no solver is without a prefix; say -pressure_" + name + ", -momentum_" + name + " or -cloth_" +
                     name);
  return !used && !values_.contains(name) && !belongs_to_petsc(name) && !is_read_after_solving(name);
}

void Options::mark_idle(const std::string& reason, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const bool many = name.ends_with('*');
    const std::string start = many ? name.substr(0, name.size() - 1) : name;
    for (auto found = values_.lower_bound(start); found != values_.end() && found->first.starts_with(start); ++found)
      if (many || found->first == name) idle_.emplace(found->first, reason);
  }
}

namespace {

// Whether a value switches its option off.
bool is_off(const std::string& value) {
  static constexpr std::array<std::string_view, 4> words{"", "none", "false", "no"};
  if (std::find(words.begin(), words.end(), value) != words.end()) return true;
  return value.find_first_not_of("0.,") == std::string::npos;
}

}  // namespace

// Idle options with their reasons, without those that a run recorded, as it does with all options. A default for all
// groups or bodies has an effect if it has one on any.
std::map<std::string, std::string> Options::idle_as_given() const {
  std::map<std::string, std::string> found;
  for (const auto& [name, given] : given_as_)
    if (const auto idle = idle_.find(name);
        idle != idle_.end() && !is_off(values_.at(name)) && !given_.is_recorded(given))
      found[given] = idle->second;
  for (const auto& [name, given] : given_as_)
    if (!idle_.contains(name)) found.erase(given);
  return found;
}

void Options::refuse_unread(const std::string& name, const std::string& value) const {
  const std::string start = "-" + name + (value.empty() ? "" : " " + value) + ": ";
  if (const auto answer = answers_.find(name); answer != answers_.end()) throw InputError(start + answer->second);
  const std::string suggestion = nearest(name);
  throw InputError(start + "no part of this run reads this option" +
                   (suggestion.empty() ? " (-help lists all)" : "; did you mean -" + suggestion + "?"));
}

void Options::reject_unread() {
  std::map<std::string, std::vector<std::string>> without_effect;  // by the reason
  for (const auto& [name, value] : database()) {
    if (!is_unread(name, value)) continue;
    const auto left_out = left_out_.find(name);
    if (left_out == left_out_.end()) refuse_unread(name, value);
    without_effect[left_out->second].push_back("-" + name);
  }
  std::map<std::string, std::vector<std::string>> overridden;
  for (const auto& [name, reason] : idle_as_given()) {
    const std::string cause = reason.substr(0, reason.find(' '));
    const bool later = cause.starts_with('-') && given_.given_elsewhere_after(name, as_given(cause.substr(1)));
    (later ? overridden : without_effect)[reason].push_back("-" + name);
  }
  const auto tell = [&](const std::string& kind, const auto& reasons) {
    for (const auto& [reason, names] : reasons)
      notes_.push_back(kind + reason + ", so without effect: " + join(names, " "));
  };
  tell("warning: ", without_effect);
  tell("note: ", overridden);
}

std::string Options::resolved() const {
  std::string text = std::string(resolved_head) + "\n";
  for (const auto& [name, value] : values_)
    if (!value.empty()) text += "-" + name + " " + quoted(value) + "\n";
  for (const auto& [name, value] : database())
    if (!values_.contains(name) && !left_out_.contains(name) && name != "options_file")
      text += "-" + name + (value.empty() ? "" : " " + quoted(value)) + "\n";
  return text;
}

}  // namespace washfsi
