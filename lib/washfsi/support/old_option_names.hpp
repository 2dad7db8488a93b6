// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "washfsi/support/given_options.hpp"

namespace washfsi {

/// Options that have got another name: the old one still holds.
class OldOptionNames {
 public:
  /// Lets an old name stand for the present one, to be called before that is read: PETSc's database then has the
  /// present one alone. What is on the command line counts more than what is in a file, by either name. Returns whether
  /// the value is that of the old name. Errors: InputError if the user gave both in one place.
  bool replace(const std::string& old_name, const std::string& name, const GivenOptions& given);

  /// All old names with the present ones.
  const std::vector<std::pair<std::string, std::string>>& all() const { return all_; }
  /// A name as the user gave it: the old one, perhaps.
  std::string as_given(const std::string& name) const;

 private:
  std::vector<std::pair<std::string, std::string>> all_;
  std::map<std::string, std::string> used_;  ///< old names that the user gave, by the present ones
};

}  // namespace washfsi
