// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "washfsi/output/history.hpp"

namespace washfsi {

/// What becomes of a number over a run.
enum class Accumulation {
  none,            ///< nothing: it is as it was measured last
  largest,         ///< the largest of all is in the summary
  largest_so_far,  ///< the largest of all is in the summary and, as far as it has come, in the history
};

/// One number that is measured.
struct Quantity {
  std::string name;               ///< of its column in history.csv; empty: it has none
  std::string unit;               ///< SI, "-" for none
  std::string meaning;            ///< for the documents
  std::function<double()> value;  ///< as measured last
  Accumulation accumulation = Accumulation::none;
  std::string summary = {};  ///< where it stands in summary.json, as a JSON pointer; empty: nowhere
  bool is_count = false;     ///< a whole number
};

/// All numbers that are measured, each said once: the history, the summary, the checkpoint and the documents are made
/// from this list.
class QuantityList {
 public:
  void add(Quantity quantity);
  /// Numbers that go on from step to step and that a checkpoint must keep. They must outlive the list.
  void keep(const std::string& name, std::span<double> numbers);

  /// Takes the present values, and them into the largest ones.
  void accumulate();
  /// The values taken last, which a checkpoint keeps for a run that has no step left to take.
  const std::vector<double>& taken() const { return taken_; }
  void set_taken(const std::vector<double>& values) { taken_ = values; }

  /// The history's columns, and their values now.
  std::vector<Column> columns() const;
  std::vector<double> row() const;

  /// What stands in the summary.
  struct SummaryEntry {
    std::string pointer;
    double value;
    bool is_count;
  };
  std::vector<SummaryEntry> summary() const;
  /// What the summary has at a pointer; 0 if it has nothing there.
  double summary_value(const std::string& pointer) const;

  /// What a checkpoint keeps: names and places of numbers.
  struct Kept {
    std::string name;
    std::span<double> numbers;
  };
  const std::vector<Kept>& kept() const { return kept_; }

  /// A table of the history's columns in Markdown.
  std::string document() const;

 private:
  double shown(std::size_t n) const;

  std::vector<Quantity> quantities_;
  std::vector<double> taken_;
  std::deque<double> largest_;  ///< of each quantity; does not move as it grows
  std::vector<Kept> kept_;
};

}  // namespace washfsi
