// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
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

// Also tells -help of it.
PetscErrorCode ask_string(PetscOptionItems* PetscOptionsObject, const char* flag, const char* help, const char* current,
                          char* value, std::size_t length, PetscBool* given) {
  PetscFunctionBeginUser;
  PetscCall(PetscOptionsString(flag, help, "washfsi", current, value, length, given));
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

void Options::refuse_unread(const std::string& name, const std::string& value) const {
  const std::string suggestion = nearest(name);
  throw InputError("-" + name + (value.empty() ? "" : " " + value) + ": no part of this run reads this option" +
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
  for (const auto& [reason, names] : without_effect)
    notes_.push_back("warning: " + reason + ", so without effect: " + join(names, " "));
}

std::string Options::resolved() const {
  std::string text = "# every option of the run with the value used; solver options as they were given\n";
  for (const auto& [name, value] : values_)
    if (!value.empty()) text += "-" + name + " " + quoted(value) + "\n";
  for (const auto& [name, value] : database())
    if (!values_.contains(name) && !left_out_.contains(name) && name != "options_file")
      text += "-" + name + (value.empty() ? "" : " " + quoted(value)) + "\n";
  return text;
}

std::optional<std::string> OptionBlock::ask(const std::string& name, const std::string& current,
                                            const Description& description) {
  if (!options_.leaving_out_.empty()) {
    options_.left_out_.emplace(prefix_ + name, options_.leaving_out_);
    if (!fallback_.empty()) options_.left_out_.emplace(fallback_ + name, options_.leaving_out_);
    return std::nullopt;
  }
  const std::string brackets = description.unit.empty() ? description.allowed : description.unit;
  const std::string help = description.meaning + (brackets.empty() ? "" : " [" + brackets + "]"), option = "-" + name;
  // asked even where the group has its own: so it counts as read
  const bool for_all = !fallback_.empty() && petsc::option_given("", "-" + fallback_ + name);
  std::string value = for_all ? Options::database().at(fallback_ + name) : current;
  std::vector<char> buffer(1 << 20);  // lists of corners may be long
  PetscBool given = PETSC_FALSE;
  if (options_.values_.contains(prefix_ + name))  // told already: several laws or shapes have it
    WASH_PETSC(PetscOptionsGetString(nullptr, prefix_.c_str(), option.c_str(), buffer.data(), buffer.size(), &given));
  else
    WASH_PETSC(ask_string(items_, option.c_str(), help.c_str(), value.c_str(), buffer.data(), buffer.size(), &given));
  if (given) value = buffer.data();
  options_.values_[prefix_ + name] = value;
  options_.declared_.push_back({title_, prefix_ + name, value, description.unit, description.meaning,
                                description.allowed, options_.required_.contains(prefix_ + name)});
  if (!given && !for_all) return std::nullopt;
  return value;
}

void OptionBlock::refuse(const std::string& name, const std::string& value, const std::string& allowed) const {
  throw InputError("-" + as_given(name) + " " + value + ": must be " + allowed);
}

double OptionBlock::number(const std::string& name, const std::string& word, const Range& range) const {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole_word = error == std::errc{} && end == word.data() + word.size();
  if (!whole_word || !std::isfinite(value) || !range.contains(value)) refuse(name, word, range.text);
  constexpr double huge = 1e100;  // beyond it, squares and quotients leave the range of numbers
  if (value != 0 && (std::abs(value) > huge || std::abs(value) < 1 / huge))
    refuse(name, word, "0, or between 1e-100 and 1e100 in size");
  return value;
}

void OptionBlock::real(const std::string& name, double& value, const char* unit, const Range& range, const char* help) {
  const auto given = ask(name, to_text(value), {help, unit, range.text});
  if (given) value = number(name, *given, range);
}

void OptionBlock::integer(const std::string& name, PetscInt& value, const Range& range, const char* help) {
  const auto given = ask(name, std::to_string(value), {help, "-", range.text});
  if (!given) return;
  const double result = number(name, *given, range);
  if (result != std::floor(result)) refuse(name, *given, range.text);
  value = static_cast<PetscInt>(result);
}

void OptionBlock::boolean(const std::string& name, bool& value, const char* help) {
  const auto given = ask(name, value ? "true" : "false", {help, "", "true|false"});
  if (!given) return;
  const std::string& word = *given;
  const bool yes = word.empty() || word == "true" || word == "1" || word == "yes";
  if (!yes && word != "false" && word != "0" && word != "no") refuse(name, word, "true or false");
  options_.values_[prefix_ + name] = yes ? "true" : "false";
  value = yes;
}

void OptionBlock::text(const std::string& name, std::string& value, const char* help) {
  const auto given = ask(name, value, {help, "", ""});
  if (!given) return;
  const bool blank = std::any_of(given->begin(), given->end(), [](unsigned char c) { return std::isspace(c); });
  if (given->empty() || blank) refuse(name, *given, "a text without blanks");
  value = *given;
}

void OptionBlock::file(const std::string& name, std::string& value, const char* help) {
  const auto given = ask(name, value, {help, "", ""});
  if (!given) return;
  if (options_.given_.lacks_value(as_given(name))) refuse(name, "", "the name of a file");
  value = options_.given_.resolve(as_given(name), *given);
  if (!value.empty()) options_.record(prefix_ + name, std::filesystem::absolute(value).lexically_normal().string());
}

void OptionBlock::choice(const std::string& name, std::string& value, const std::vector<std::string>& allowed,
                         const char* help) {
  const std::string list = join(allowed, "|");
  const auto given = ask(name, value, {help, "", list});
  if (!given) return;
  if (std::find(allowed.begin(), allowed.end(), *given) == allowed.end()) refuse(name, *given, "one of " + list);
  value = *given;
}

void OptionBlock::names(const std::string& name, std::vector<std::string>& value, const char* help) {
  const auto given = ask(name, join(value, ","), {help, "", "names"});
  if (!given) return;
  value = split(*given, ',');
  for (std::size_t i = 0; i < value.size(); ++i) {
    const bool valid =
        !value[i].empty() && std::isalpha(static_cast<unsigned char>(value[i][0])) &&
        std::all_of(value[i].begin(), value[i].end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    if (!valid || std::find(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(i), value[i]) !=
                      value.begin() + static_cast<std::ptrdiff_t>(i))
      refuse(name, *given, "different names of letters, digits and _, separated by commas");
  }
}

void OptionBlock::reals(const std::string& name, std::vector<double>& value, std::size_t fewest, std::size_t most,
                        const char* unit, const char* help) {
  std::vector<std::string> words;
  for (const double v : value) words.push_back(to_text(v));
  const std::string count = std::to_string(fewest) +
                            (most > fewest && most < 1000 ? " or " + std::to_string(most) : "") +
                            (most == 1 ? " number" : " numbers");
  const auto given = ask(name, join(words, ","), {help, unit, most < 1000 ? count : "any numbers"});
  if (!given) return;
  words = split(*given, ',');
  if (words.size() < fewest || words.size() > most) {
    refuse(name, *given, count + " separated by commas (" + std::to_string(words.size()) + " given)");
  }
  if (std::find(words.begin(), words.end(), "") != words.end()) refuse(name, *given, "numbers separated by commas");
  value.clear();
  for (const auto& word : words) value.push_back(number(name, word, any_number));
}

bool OptionBlock::given(const std::string& name) const {
  return petsc::option_given("", "-" + prefix_ + name) ||
         (!fallback_.empty() && petsc::option_given("", "-" + fallback_ + name));
}

// As the user wrote it, with the prefix for all or an old name.
std::string OptionBlock::as_given(const std::string& name) const {
  const bool is_for_all = !petsc::option_given("", "-" + prefix_ + name) && given(name);
  return options_.as_given((is_for_all ? fallback_ : prefix_) + name);
}

void OptionBlock::require(const std::string& name, const char* meaning) {
  if (!options_.leaving_out_.empty()) return;
  options_.required_.insert(prefix_ + name);
  if (!given(name) && !options_.help()) throw InputError("-" + prefix_ + name + " is missing: " + meaning);
}

}  // namespace washfsi
