// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>

namespace washfsi {

/// Options of parts that a later option has switched off: they are neither declared, read nor checked.
class LeftOutOptions {
 public:
  /// Runs `declare`, which calls `add` for each option of such a part. What it finds wrong with them does not count.
  void leave_out(const std::string& reason, const std::function<void()>& declare);
  /// Whether `leave_out` is under way.
  bool is_leaving_out() const { return !reason_.empty(); }
  /// Adds an option, while `leave_out` is under way.
  void add(const std::string& name) { reasons_.emplace(name, reason_); }

  /// All of them, each with the reason.
  const std::map<std::string, std::string>& reasons() const { return reasons_; }

 private:
  std::map<std::string, std::string> reasons_;
  std::string reason_;  ///< the reason, during `leave_out`
};

}  // namespace washfsi
