// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "washfsi/support/option_register.hpp"
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

/// The options of one part of the program: each call declares one (for -help), reads it from PETSc's database
/// and checks it. Errors: InputError naming option, value and what is allowed. Collective.
class OptionBlock {
 public:
  /// `items` are PETSc's of an open block, or null while options are left out. The register must outlive it.
  OptionBlock(OptionRegister& all, PetscOptionItems* items, std::string title, std::string prefix, std::string fallback)
      : register_(all),
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
  std::optional<std::string> ask_petsc(const std::string& name, const std::string& current,
                                       const Description& description) const;
  double number(const std::string& name, const std::string& word, const Range& range) const;
  std::string as_given(const std::string& name) const;

  OptionRegister& register_;
  PetscOptionItems* items_;
  std::string title_, prefix_, fallback_;
};

}  // namespace washfsi
