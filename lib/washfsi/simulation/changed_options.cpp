// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/changed_options.hpp"

#include <map>
#include <set>
#include <sstream>

#include "washfsi/support/petsc_options.hpp"

namespace washfsi {

namespace {

std::map<std::string, std::string> options_in(const std::string& text) {
  std::map<std::string, std::string> options;
  std::istringstream lines(text);
  std::string name, value;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    name = value = "";
    words >> name >> std::ws;
    std::getline(words, value);  // a quoted value may contain blanks
    if (name.starts_with('-')) options[name.substr(1)] = value;
  }
  return options;
}

}  // namespace

std::string case_options(const std::string& resolved) {
  static const std::set<std::string> of_the_run{
      "time_end", "max_steps", "output_dir", "history_interval", "case_name", "output_interval", "checkpoint_interval",
      "restart",  "check",     "strict"};
  std::string text;
  for (const auto& [name, value] : options_in(resolved))
    if (!of_the_run.contains(name) && !belongs_to_petsc(name)) text += "-" + name + " " + value + "\n";
  return text;
}

std::vector<std::string> changed_options(const std::string& before, const std::string& now) {
  std::vector<std::string> changes;
  if (before.empty()) return changes;
  auto old_options = options_in(before), new_options = options_in(now);
  std::set<std::string> names;
  for (const auto& options : {old_options, new_options})
    for (const auto& [name, value] : options) names.insert(name);
  const auto told = [](const std::string& value) { return value.empty() ? "not given" : value; };
  for (const std::string& name : names)
    if (const std::string was = old_options[name], is = new_options[name]; was != is)
      changes.push_back("note: -" + name + " was " + told(was) + ", is now " + told(is));
  return changes;
}

std::string repeatable(const std::string& resolved) {
  std::istringstream lines(resolved);
  std::string text;
  for (std::string line; std::getline(lines, line);)
    text += line.starts_with("-restart ") ? "# the run went on from " + line.substr(9) + "\n" : line + "\n";
  return text;
}

}  // namespace washfsi
