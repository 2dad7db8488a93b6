// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "washfsi/output/history.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

/// What becomes of a number over a run.
enum class Accumulation {
  none,            ///< nothing: it is as it was measured last
  largest,         ///< the largest of all is in the summary
  largest_so_far,  ///< the largest of all is in the summary and, as far as it has come, in the history
};

/// What is made of a number over a cycle of the machine.
enum class OverCycle {
  mean,      ///< over time
  rms,       ///< over time
  peak,      ///< largest size
  integral,  ///< over time
  change,    ///< from the cycle's start to its end
};

/// A figure of a cycle, a column of cycles.csv.
struct CycleFigure {
  std::string name, unit;
  OverCycle over;
  std::string meaning;
  int balance = 0;           ///< how it enters the balance of energy: 1 if it is put in, -1 if it is kept or lost
  bool is_headline = false;  ///< whether the terminal tells it
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
  /// Adds a quantity, and what it gives for a cycle.
  void add(Quantity quantity, std::vector<CycleFigure> of_cycle = {});
  using IfOther = StateEntry::IfOther;
  /// Numbers that go on from step to step and that a checkpoint must keep. They must outlive the list.
  void keep(const std::string& name, std::span<double> numbers, IfOther if_other = IfOther::refuse);

  /// Takes the present values, and them into the largest ones.
  void accumulate();
  /// Registers what is kept, and the values taken last, for a run that has no step left to take.
  void register_state(StateList& state);

  /// All figures of a cycle, each with the present value of its quantity.
  std::vector<CycleFigure> cycle_figures() const;
  std::vector<double> cycle_values() const;

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

  /// A table of the history's columns in Markdown.
  std::string document() const;

 private:
  double shown(std::size_t n) const;

  std::vector<Quantity> quantities_;
  std::vector<std::vector<CycleFigure>> of_cycle_;  ///< of each quantity
  std::vector<double> taken_;
  std::deque<double> largest_;  ///< of each quantity; does not move as it grows
  std::vector<StateEntry> kept_;
};

}  // namespace washfsi
