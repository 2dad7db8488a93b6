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

/// How a number is accumulated over a run.
enum class Accumulation {
  none,            ///< not at all: it is as measured last
  largest,         ///< the summary has the largest value
  largest_so_far,  ///< the summary has the largest value, and the history the largest so far
};

/// How a number is reduced over a cycle of the machine.
enum class OverCycle {
  mean,      ///< mean over time
  rms,       ///< root mean square over time
  peak,      ///< largest absolute value
  integral,  ///< integral over time
  change,    ///< change from the cycle's start to its end
};

/// A figure of a cycle, a column of cycles.csv.
struct CycleFigure {
  std::string name, unit;
  OverCycle over;
  std::string meaning;
  int balance = 0;           ///< sign in the balance of energy: 1 for input, -1 for stored or lost energy
  bool is_headline = false;  ///< whether the terminal shows it
};

/// A measured number.
struct Quantity {
  std::string name;               ///< name of its column in history.csv; empty: none
  std::string unit;               ///< SI, "-" for none
  std::string meaning;            ///< description for the documents
  std::function<double()> value;  ///< gives the value measured last
  Accumulation accumulation = Accumulation::none;
  std::string summary = {};  ///< its place in summary.json, as a JSON pointer; empty: none
  bool is_count = false;     ///< whether it is a whole number
};

/// All measured numbers, each declared once: the history, the summary, the checkpoint and the documents are made from
/// this list.
class QuantityList {
 public:
  /// Adds a quantity, and its figures for a cycle.
  void add(Quantity quantity, std::vector<CycleFigure> of_cycle = {});
  using IfOther = StateEntry::IfOther;
  /// Adds numbers carried from step to step, which a checkpoint must store. They must outlive the list.
  void keep(const std::string& name, std::span<double> numbers, IfOther if_other = IfOther::refuse);

  /// Takes the present values, and updates the largest ones.
  void accumulate();
  /// Registers the numbers of `keep`, and the values taken last, for a restart without further steps.
  void register_state(StateList& state);

  /// All figures of a cycle, each with the present value of its quantity.
  std::vector<CycleFigure> cycle_figures() const;
  std::vector<double> cycle_values() const;

  /// The history's columns, and their values now.
  std::vector<Column> columns() const;
  std::vector<double> row() const;

  /// An entry of the summary.
  struct SummaryEntry {
    std::string pointer;
    double value;
    bool is_count;
  };
  std::vector<SummaryEntry> summary() const;
  /// The summary's value at a pointer; 0 if there is none.
  double summary_value(const std::string& pointer) const;

  /// A table of the history's columns in Markdown.
  std::string document() const;

 private:
  double shown(std::size_t n) const;

  std::vector<Quantity> quantities_;
  std::vector<std::vector<CycleFigure>> of_cycle_;  ///< figures of each quantity
  std::vector<double> taken_;
  std::deque<double> largest_;  ///< largest value of each quantity; does not move as it grows
  std::vector<StateEntry> kept_;
};

}  // namespace washfsi
