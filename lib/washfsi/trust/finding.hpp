// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace washfsi {

/// How far a number of a run can be believed: `warn` where results are off by more than engineers accept, `fail` where
/// they mean nothing.
enum class Verdict { ok, warn, fail };
std::string name_of(Verdict verdict);

/// When the terminal of a run tells of what was looked at: where it is not ok, or as what it may be known by.
enum class Telling { in_doubt, always };

/// One thing that was looked at.
struct Finding {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::string name;  ///< what was looked at
  std::string text;  ///< what was found, with units
  Verdict verdict = Verdict::ok;
  double value = none, limit = none;  ///< of a number that was judged; `none` if it is none
  std::string advice;                 ///< what to do, where it is not ok
  Telling telling = Telling::in_doubt;
};

using Findings = std::vector<Finding>;

/// Limits beyond which a number is to be warned of, or fails.
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

/// Those that are not ok.
Findings doubtful(const Findings& findings);

}  // namespace washfsi
