// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "washfsi/support/given_options.hpp"

namespace washfsi {

/// An option as it was declared.
struct DeclaredOption {
  std::string block, name, value;      ///< title of its block; the value used, or the default
  std::string unit, meaning, allowed;  ///< unit, description, and allowed values
  bool required = false;
};

/// The options that the program has declared and read, and which of them have no effect.
class DeclaredOptions {
 public:
  /// Adds an option. Several parts may declare one of the same name: each is in the list, and the last value counts.
  void add(DeclaredOption option);
  /// Makes an option, which is added later, a required one.
  void require(const std::string& name) { required_.insert(name); }
  /// Sets the value of an option.
  void record(const std::string& name, const std::string& value) { values_[name] = value; }
  /// Sets the name by which the user gave an option: an old one, or that for all groups or bodies.
  void set_given_as(const std::string& name, const std::string& given) { given_as_[name] = given; }

  bool contains(const std::string& name) const { return values_.contains(name); }
  /// All options in the order in which they were declared.
  const std::vector<DeclaredOption>& list() const { return list_; }
  /// The values used, by name.
  const std::map<std::string, std::string>& values() const { return values_; }

  /// Marks options that have been read but have no effect, with the reason. A name may end with *, for all that begin
  /// so.
  void mark_idle(const std::string& reason, const std::vector<std::string>& names);
  /// The marked options that the user gave and did not switch off, as they were given, with the reasons. Those that a
  /// run recorded are not among them, since it does so with all options.
  std::map<std::string, std::string> idle_as_given(const GivenOptions& given) const;

 private:
  std::vector<DeclaredOption> list_;
  std::map<std::string, std::string> values_;
  std::set<std::string> required_;
  std::map<std::string, std::string> given_as_;  ///< options that the user gave, each with the name used
  std::map<std::string, std::string> idle_;      ///< options without effect, each with the reason
};

}  // namespace washfsi
