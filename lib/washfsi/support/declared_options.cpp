// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/declared_options.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace washfsi {

void DeclaredOptions::add(DeclaredOption option) {
  values_[option.name] = option.value;
  option.required = required_.contains(option.name);
  list_.push_back(std::move(option));
}

void DeclaredOptions::mark_idle(const std::string& reason, const std::vector<std::string>& names) {
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

// A default for all groups or bodies has an effect if it has one on any.
std::map<std::string, std::string> DeclaredOptions::idle_as_given(const GivenOptions& given) const {
  std::map<std::string, std::string> found;
  for (const auto& [name, used] : given_as_)
    if (const auto idle = idle_.find(name);
        idle != idle_.end() && !is_off(values_.at(name)) && !given.is_recorded(used))
      found[used] = idle->second;
  for (const auto& [name, used] : given_as_)
    if (!idle_.contains(name)) found.erase(used);
  return found;
}

}  // namespace washfsi
