// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace washfsi {

/// How far a number of a run can be trusted: `warn` where errors are larger than engineers accept, `fail` where results
/// are meaningless.
enum class Verdict { ok, warn, fail };
std::string name_of(Verdict verdict);

/// When the terminal of a run shows a finding: only if it is not ok, or always.
enum class Display { in_doubt, always };

/// The result of one check.
struct Finding {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::string name;  ///< name of the check
  std::string text;  ///< its result in words, with units
  Verdict verdict = Verdict::ok;
  double value = none, limit = none;  ///< number that was checked and its limit; `none` if there is none
  std::string advice;                 ///< advice to the user, where it is not ok
  Display display = Display::in_doubt;
};

using Findings = std::vector<Finding>;

/// Limits beyond which a number gets a warning, or fails.
struct Limits {
  double warn;
  std::optional<double> fail = std::nullopt;
};

/// A finding on a number that should be small.
Finding at_most(const std::string& name, double value, const Limits& limits, const std::string& text,
                const std::string& advice);
/// A finding on a number that should be large; it fails below `fail`.
Finding at_least(const std::string& name, double value, const Limits& limits, const std::string& text,
                 const std::string& advice);

/// One line for people: the verdict, and with it limit and advice where it is not ok.
std::string line_of(const Finding& finding);

/// The findings that are not ok.
Findings doubtful(const Findings& findings);

}  // namespace washfsi
