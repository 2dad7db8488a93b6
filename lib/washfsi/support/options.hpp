// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "washfsi/support/petsc.hpp"
#include "washfsi/support/point.hpp"

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
inline constexpr Range at_least_one{1.0, 1e9, false, "a whole number >= 1"};
inline constexpr Range non_negative_integer{0.0, 2e9, false, "a whole number >= 0"};

class Options;

/// The options of one part of the program: each call declares one (for -help), reads it from PETSc's database
/// and checks it. Errors: InputError naming option, value and what is allowed. Collective.
class OptionBlock {
 public:
  OptionBlock(Options& options, PetscOptionItems* items, std::string prefix)
      : options_(options), items_(items), prefix_(std::move(prefix)) {}

  void real(const std::string& name, double& value, const char* unit, const Range& range, const char* help);
  void integer(const std::string& name, PetscInt& value, const Range& range, const char* help);
  void boolean(const std::string& name, bool& value, const char* help);
  void text(const std::string& name, std::string& value, const char* help);
  void choice(const std::string& name, std::string& value, const std::vector<std::string>& allowed, const char* help);
  void names(const std::string& name, std::vector<std::string>& value, const char* help);
  /// A list whose length must be from `fewest` to `most`.
  void reals(const std::string& name, std::vector<double>& value, std::size_t fewest, std::size_t most,
             const char* unit, const char* help);

  /// Exactly Dim numbers.
  template <int Dim>
  void point(const std::string& name, Point<Dim>& value, const char* unit, const char* help) {
    std::vector<double> list(value.data(), value.data() + Dim);
    reals(name, list, Dim, Dim, unit, help);
    for (int d = 0; d < Dim; ++d) value[d] = list[static_cast<std::size_t>(d)];
  }

  /// Whether the user gave this option.
  bool given(const std::string& name) const;
  /// Stops with one line unless the user gave this option.
  void require(const std::string& name, const char* meaning) const;

 private:
  std::optional<std::string> ask(const std::string& name, const std::string& current, const std::string& help);
  [[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& allowed) const;
  double number(const std::string& name, const std::string& word, const Range& range) const;

  Options& options_;
  PetscOptionItems* items_;
  std::string prefix_;
};

/// Every option the program knows, as it is declared: for the resolved options file and for spelling help.
class Options {
 public:
  explicit Options(MPI_Comm comm);

  /// Opens a block of options that share a prefix (may be empty). Collective.
  void block(const std::string& prefix, const std::string& title, const std::function<void(OptionBlock&)>& declare);

  /// Replaces the recorded value of an option that the program has worked out itself.
  void record(const std::string& name, const std::string& value) { values_[name] = value; }
  void record(const std::string& name, double value);

  /// Takes a name that the user chose as the prefix of options: it must be no other part's. Errors: InputError.
  void claim_prefix(const std::string& name, const std::string& option);

  /// Stops if the user gave an option that nobody read; PETSc's own options pass. Call once all parts are set up.
  void reject_unread() const;

  /// An options file that repeats the run: ours with the values used, then PETSc's as the user gave them.
  std::string resolved() const;

  /// Every option in PETSc's database with its value.
  static std::map<std::string, std::string> database();

  MPI_Comm comm() const { return comm_; }
  /// True if the user asked for -help: required options are then not required.
  bool help() const { return help_; }

 private:
  friend class OptionBlock;
  std::string nearest(const std::string& name) const;

  MPI_Comm comm_;
  bool help_ = false;
  std::map<std::string, std::string> values_;
  std::set<std::string> claimed_;  ///< prefixes chosen by the user
};

/// Shortest text that reads back as the same number.
std::string to_text(double value);
/// Coordinates as they are written in options: 1,2.5
template <int Dim>
std::string list_text(const Point<Dim>& point) {
  std::string text;
  for (int d = 0; d < Dim; ++d) text += (d ? "," : "") + to_text(point[d]);
  return text;
}
std::string join(const std::vector<std::string>& words, const std::string& separator);
std::vector<std::string> split(const std::string& list, char separator);

}  // namespace washfsi
