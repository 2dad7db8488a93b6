// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/trust/finding.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "washfsi/support/format_text.hpp"

namespace washfsi {

std::string name_of(Verdict verdict) {
  return verdict == Verdict::ok ? "ok" : verdict == Verdict::warn ? "warn" : "fail";
}

namespace {

Finding judge(const std::string& name, double value, const Limits& limits, const std::string& text,
              const std::string& advice, bool warns, bool fails) {
  const Verdict verdict = fails ? Verdict::fail : warns ? Verdict::warn : Verdict::ok;
  return {name, text, verdict, value, fails ? *limits.fail : limits.warn, advice, Display::in_doubt};
}

}  // namespace

// Comparisons are written such that NaN is not ok.
Finding at_most(const std::string& name, double value, const Limits& limits, const std::string& text,
                const std::string& advice) {
  return judge(name, value, limits, text, advice, !(value <= limits.warn), limits.fail && !(value <= *limits.fail));
}

Finding at_least(const std::string& name, double value, const Limits& limits, const std::string& text,
                 const std::string& advice) {
  return judge(name, value, limits, text, advice, !(value >= limits.warn), limits.fail && !(value >= *limits.fail));
}

std::string line_of(const Finding& finding) {
  const std::string start = format_text("  %-4s  %-22s ", name_of(finding.verdict).c_str(), finding.name.c_str());
  if (finding.verdict == Verdict::ok) return start + finding.text;
  const std::string limit = std::isnan(finding.limit) ? "" : format_text(" (limit %.3g)", finding.limit);
  return start + finding.text + limit + ": " + finding.advice;
}

Findings doubtful(const Findings& findings) {
  Findings found;
  std::ranges::copy_if(findings, std::back_inserter(found),
                       [](const Finding& finding) { return finding.verdict != Verdict::ok; });
  return found;
}

}  // namespace washfsi
