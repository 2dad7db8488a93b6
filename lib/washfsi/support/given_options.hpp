// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace washfsi {

/// The first line of a file in which a run has written its options.
inline constexpr const char* resolved_head =
    "# every option of the run with the value used; solver options as they were given";

/// An option as the user gave it, in a file or on the command line.
struct GivenOption {
  std::string word;        ///< the option with its dash
  std::string value;       ///< its value, perhaps empty
  bool has_value = false;  ///< whether it has a value, perhaps an empty one
  std::string file;        ///< file in which it stands, or the preset; empty: the command line
  bool recorded = false;   ///< whether the program wrote it, a run or a preset, with options without effect

  /// The name without the dash, in lower case: PETSc ignores case.
  std::string name() const;
};

/// All given options, in files and on the command line; the last of a name counts. PETSc's database has only that.
class GivenOptions {
 public:
  void add(GivenOption option) { options_.push_back(std::move(option)); }
  const std::vector<GivenOption>& all() const { return options_; }

  /// The value that counts; empty if there is none.
  std::string value(const std::string& name) const;
  bool on_command_line(const std::string& name) const;
  /// Whether an option was given without a value, not even "".
  bool lacks_value(const std::string& name) const;
  /// Whether an option stands in a file in which a run has recorded its options, or in a preset.
  bool is_recorded(const std::string& name) const;
  /// A file name that was given as this option's value: relative to the folder of the options file in which it stands;
  /// on the command line to the working directory.
  std::string resolve(const std::string& name, const std::string& path) const;
  /// The names in earlier values of a list that are not in its present one.
  std::vector<std::string> dropped(const std::string& list, const std::vector<std::string>& present) const;
  /// Whether another value of this option was given before, or another file has options that begin with `prefix` before
  /// it, perhaps for the default of this one.
  bool overridden(const std::string& name, const std::string& prefix) const;

  /// Whether another place, a later file or the command line after the files, has given `other` after `name`.
  bool given_elsewhere_after(const std::string& name, const std::string& other) const;

  /// Packs all into one text, to be sent; and unpacks it.
  std::string packed() const;
  static GivenOptions unpacked(const std::string& text);

 private:
  const GivenOption* last(const std::string& name) const;

  std::vector<GivenOption> options_;
};

}  // namespace washfsi
