// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "washfsi/support/given_options.hpp"
#include "washfsi/support/petsc.hpp"
#include "washfsi/support/point.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

/// The values an option may take.
struct Range {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool excludes_lowest = false;
  const char* text = "any number";

  bool contains(double value) const { return value <= highest && (excludes_lowest ? value > lowest : value >= lowest); }
};
inline constexpr Range any_number{};
inline constexpr Range positive{0.0, std::numeric_limits<double>::infinity(), true, "a number > 0"};
inline constexpr Range non_negative{0.0, std::numeric_limits<double>::infinity(), false, "a number >= 0"};
inline constexpr Range tight{0.0, 0.1, true, "a number > 0 and at most 0.1"};  ///< tolerances
inline constexpr Range at_least_one{1.0, 1e9, false, "a whole number >= 1"};
inline constexpr Range non_negative_integer{0.0, 2e9, false, "a whole number >= 0"};

/// The values of an enumeration with their names for users, in the order of help. For each enumeration that is an
/// option there is a function `names_of(Enum)` beside it.
template <class Enum>
using ChoiceNames = std::vector<std::pair<std::string, Enum>>;

/// The name of a value, as users write it.
template <class Enum>
std::string name_of(Enum value) {
  for (const auto& [name, named] : names_of(value))
    if (named == value) return name;
  return {};
}

class Options;

/// An option as it was declared.
struct DeclaredOption {
  std::string block, name, value;      ///< title of its block; the value used, or the default
  std::string unit, meaning, allowed;  ///< unit, description, and allowed values
  bool required = false;
};

/// The options of one part of the program: each call declares one (for -help), reads it from PETSc's database
/// and checks it. Errors: InputError naming option, value and what is allowed. Collective.
class OptionBlock {
 public:
  OptionBlock(Options& options, PetscOptionItems* items, std::string title, std::string prefix, std::string fallback)
      : options_(options),
        items_(items),
        title_(std::move(title)),
        prefix_(std::move(prefix)),
        fallback_(std::move(fallback)) {}

  void real(const std::string& name, double& value, const char* unit, const Range& range, const char* help);
  void integer(const std::string& name, PetscInt& value, const Range& range, const char* help);
  void boolean(const std::string& name, bool& value, const char* help);
  void text(const std::string& name, std::string& value, const char* help);
  /// The name of a file to be read: relative to the folder of the options file that gives it, or on the command line to
  /// the working directory; recorded as an absolute one. An empty one, "", is none.
  void file(const std::string& name, std::string& value, const char* help);
  void choice(const std::string& name, std::string& value, const std::vector<std::string>& allowed, const char* help);
  /// One of the values of an enumeration, by its name (see `ChoiceNames`); of those in `allowed` if that is not empty.
  template <class Enum>
  void choice(const std::string& name, Enum& value, const char* help, const std::vector<Enum>& allowed = {}) {
    std::vector<std::string> names;
    for (const auto& [known, of] : names_of(value))
      if (allowed.empty() || std::find(allowed.begin(), allowed.end(), of) != allowed.end()) names.push_back(known);
    std::string chosen = name_of(value);
    choice(name, chosen, names, help);
    for (const auto& [known, of] : names_of(value))
      if (known == chosen) value = of;
  }
  void names(const std::string& name, std::vector<std::string>& value, const char* help);
  /// A list whose length must be from `fewest` to `most`.
  void reals(const std::string& name, std::vector<double>& value, std::size_t fewest, std::size_t most,
             const char* unit, const char* help);

  /// A list of exactly Dim numbers.
  template <int Dim>
  void point(const std::string& name, Point<Dim>& value, const char* unit, const char* help) {
    std::vector<double> list(value.data(), value.data() + Dim);
    reals(name, list, Dim, Dim, unit, help);
    for (int d = 0; d < Dim; ++d) value[d] = list[d];
  }

  /// Whether the user gave this option, or the one for all.
  bool given(const std::string& name) const;
  /// Stops with one line unless the user gave this option; to be called before it is read.
  void require(const std::string& name, const char* meaning);
  /// Stops with one line: the option, its value, "must be" and what is allowed.
  [[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& allowed) const;

 private:
  struct Description {
    std::string meaning, unit, allowed;
  };
  std::optional<std::string> ask(const std::string& name, const std::string& current, const Description& description);
  double number(const std::string& name, const std::string& word, const Range& range) const;
  std::string as_given(const std::string& name) const;

  Options& options_;
  PetscOptionItems* items_;
  std::string title_, prefix_, fallback_;
};

/// Every option the program knows, as it is declared: for the resolved options file and for spelling help.
class Options {
 public:
  /// `documents`: only to tell what options there are. `given`: where PETSc's options come from.
  explicit Options(MPI_Comm comm, bool documents = false, GivenOptions given = {});

  /// Opens a block of options that share a prefix (may be empty). Where the user gives none, one with the prefix
  /// `fallback` counts: -cloths_ke for the -NAME_ke of each group of cloths. Collective.
  void block(const std::string& prefix, const std::string& title, const std::function<void(OptionBlock&)>& declare,
             const std::string& fallback = "");

  /// Lets an old name stand for the present one, to be called before that is read; `notes` say so. What is on the
  /// command line counts more than what is in a file, by either name. Errors: InputError if the user gave both in one
  /// place.
  void alias(const std::string& old_name, const std::string& name);
  /// Lets an old value of an option stand for the present one; `notes` say so.
  void alias_value(const std::string& name, const std::string& old_value, const std::string& value);
  /// All old names with the present ones.
  const std::vector<std::pair<std::string, std::string>>& aliases() const { return aliases_; }
  /// A name as the user gave it: the old one, perhaps.
  std::string as_given(const std::string& name) const;
  /// A line for each old name that the user gave.
  const std::vector<std::string>& notes() const { return notes_; }

  /// Replaces the recorded value of an option by one that the program has computed.
  void record(const std::string& name, const std::string& value) { values_[name] = value; }
  void record(const std::string& name, double value);

  /// Takes a name that the user chose as the prefix of options: it must be no other part's. Errors: InputError.
  void claim_prefix(const std::string& name, const std::string& option);

  const GivenOptions& given() const { return given_; }
  /// Registers the options of a part that a later option has switched off, so that `reject_unread` accepts them: those
  /// in `declare` are neither declared, read nor checked. `reason` is the text of the warning.
  void leave_out(const std::string& reason, const std::function<void()>& declare);
  /// `leave_out` of each part that an earlier value of a list names, and `present` does not.
  void leave_out_dropped(const std::string& list, const std::vector<std::string>& present,
                         const std::function<void(const std::string& name)>& declare);

  /// Marks options that were read but have no effect because of others: `reject_unread` warns of those that the user
  /// gave and did not switch off; if the option with which the reason begins was given later, overriding an earlier
  /// file, it prints a note instead. A name may end with *, for all that begin so.
  void mark_idle(const std::string& reason, const std::vector<std::string>& names);
  /// Adds a warning on the user's options to the notes.
  void warn(const std::string& text) { notes_.push_back("warning: " + text); }
  /// Sets the message for an option that does not exist, in place of the usual one that nobody reads it.
  void answer(const std::string& name, const std::string& text) { answers_[name] = text; }

  /// Stops if the user gave an option that nobody read; PETSc's own options pass, and those that were left out or are
  /// idle become `notes`. Call once all parts are set up.
  void reject_unread();

  /// An options file that repeats the run: ours with the values used, then PETSc's as the user gave them.
  std::string resolved() const;

  /// Every option in PETSc's database with its value.
  static std::map<std::string, std::string> database();

  MPI_Comm comm() const { return comm_; }
  /// True if the user asked for -help or a document, or in `leave_out`: required options are then not required, and
  /// nothing is built.
  bool help() const { return help_ || !leaving_out_.empty(); }
  /// Example names for lists of names that the user leaves empty, so that help (`name`) and document (`placeholder`)
  /// show the options of one. Empty otherwise.
  std::vector<std::string> examples(const char* name, const char* placeholder) const;
  /// All options in the order in which they were declared.
  const std::vector<DeclaredOption>& declared() const { return declared_; }

 private:
  friend class OptionBlock;
  std::string nearest(const std::string& name) const;
  bool is_unread(const std::string& name, const std::string& value) const;
  [[noreturn]] void refuse_unread(const std::string& name, const std::string& value) const;
  std::map<std::string, std::string> idle_as_given() const;

  MPI_Comm comm_;
  bool help_ = false, documents_ = false;
  std::vector<DeclaredOption> declared_;
  std::map<std::string, std::string> values_;
  std::set<std::string> required_;
  std::vector<std::pair<std::string, std::string>> aliases_;
  std::map<std::string, std::string> old_names_;  ///< old names that the user gave, by the present ones
  std::vector<std::string> notes_;
  std::set<std::string> claimed_;  ///< prefixes chosen by the user
  GivenOptions given_;
  std::map<std::string, std::string> left_out_;  ///< options that are switched off, each with the reason
  std::string leaving_out_;                      ///< the reason, during `leave_out`
  std::map<std::string, std::string> idle_;      ///< options without effect, each with the reason
  std::map<std::string, std::string> given_as_;  ///< options that the user gave, each with the name used
  std::map<std::string, std::string> answers_;   ///< messages for options that do not exist
};

}  // namespace washfsi
