// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/option_block.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "washfsi/support/errors.hpp"
#include "washfsi/support/petsc_options.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

namespace {

// Asks PETSc for an option, which also declares it for -help.
PetscErrorCode ask_string(PetscOptionItems* PetscOptionsObject, const char* flag, const char* help, const char* current,
                          char* value, std::size_t length, PetscBool* given) {
  PetscFunctionBeginUser;
  PetscCall(PetscOptionsString(flag, help, "washfsi", current, value, length, given));
  PetscFunctionReturn(0);
}

}  // namespace

// The value that the user gave, or none.
std::optional<std::string> OptionBlock::ask(const std::string& name, const std::string& current,
                                            const Description& description) {
  LeftOutOptions& left_out = register_.left_out;
  if (left_out.is_leaving_out()) {
    left_out.add(prefix_ + name);
    if (!fallback_.empty()) left_out.add(fallback_ + name);
    return std::nullopt;
  }
  // asked even where the group has its own: so it counts as read
  const bool for_all = !fallback_.empty() && petsc::option_given("", "-" + fallback_ + name);
  std::string value = for_all ? petsc::option_value("", "-" + fallback_ + name, "") : current;
  const auto given = ask_petsc(name, value, description);
  if (given) value = *given;
  register_.declared.add({title_, prefix_ + name, value, description.unit, description.meaning, description.allowed});
  if (!given && !for_all) return std::nullopt;
  register_.declared.set_given_as(prefix_ + name, as_given(name));
  return value;
}

// What PETSc's database has under the name with the prefix. Declares it for -help the first time: several laws or
// shapes may have an option of this name.
std::optional<std::string> OptionBlock::ask_petsc(const std::string& name, const std::string& current,
                                                  const Description& description) const {
  const std::string brackets = description.unit.empty() ? description.allowed : description.unit;
  const std::string help = description.meaning + (brackets.empty() ? "" : " [" + brackets + "]"), option = "-" + name;
  std::vector<char> buffer(1 << 20);  // lists of corners may be long
  PetscBool given = PETSC_FALSE;
  if (register_.declared.contains(prefix_ + name))
    WASH_PETSC(PetscOptionsGetString(nullptr, prefix_.c_str(), option.c_str(), buffer.data(), buffer.size(), &given));
  else
    WASH_PETSC(ask_string(items_, option.c_str(), help.c_str(), current.c_str(), buffer.data(), buffer.size(), &given));
  return given ? std::optional<std::string>(buffer.data()) : std::nullopt;
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
  register_.declared.record(prefix_ + name, yes ? "true" : "false");
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
  if (register_.given.lacks_value(as_given(name))) refuse(name, "", "the name of a file");
  value = register_.given.resolve(as_given(name), *given);
  if (!value.empty())
    register_.declared.record(prefix_ + name, std::filesystem::absolute(value).lexically_normal().string());
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

// The name as the user wrote it, with the prefix for all or an old name.
std::string OptionBlock::as_given(const std::string& name) const {
  const bool is_for_all = !petsc::option_given("", "-" + prefix_ + name) && given(name);
  return register_.old_names.as_given((is_for_all ? fallback_ : prefix_) + name);
}

void OptionBlock::require(const std::string& name, const char* meaning) {
  if (register_.left_out.is_leaving_out()) return;
  register_.declared.require(prefix_ + name);
  if (!given(name) && !register_.help) throw InputError("-" + prefix_ + name + " is missing: " + meaning);
}

}  // namespace washfsi
