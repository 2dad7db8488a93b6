// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/measure/quantity.hpp"

namespace washfsi {

/// Figures of each cycle of a machine, and their means and spread over the cycles from the second on: in the first the
/// load is thrown from where it was laid.
///
/// A row of the history counts for the cycle in which the middle of its interval lies, so that sums over rows give the
/// figures again.
class Cycles {
 public:
  static constexpr long first_in_means = 2;
  static constexpr long wanted = first_in_means + 1;  ///< for means that have a spread

  static constexpr double whole_run = 1e100;  ///< a period that makes it one cycle [s]

  /// `period` [s]: of a cycle; 0: there are none. The list must be whole and outlive it; it keeps under this name what
  /// a checkpoint needs.
  Cycles(QuantityList& quantities, double period, const std::string& name);
  Cycles(const Cycles&) = delete;
  Cycles& operator=(const Cycles&) = delete;

  bool are_there() const { return period_ > 0; }
  double period() const { return period_; }  ///< [s]
  /// Number of the last cycle that was completed.
  long completed() const { return static_cast<long>(told_); }

  /// Begins at a time [s] with the values taken last, unless a checkpoint has told of the same cycles.
  void begin(double time);
  /// Lets the means begin anew, with the next whole cycle: what is simulated has changed.
  void forget_means();
  /// Adds the values taken last, at the end of an interval [s].
  void observe(double time, double interval);

  /// A cycle that has been completed.
  struct Row {
    long number = 1;             ///< counted from one at t = 0
    double start = 0, end = 0;   ///< [s]
    std::vector<double> values;  ///< of each figure
  };
  /// Those completed since they were asked for last.
  std::vector<Row> take_completed();

  /// What a row has: the figures of the quantities, and what the balance of energy leaves open.
  const std::vector<CycleFigure>& figures() const { return figures_; }

  /// The figures of the cycle under way.
  std::vector<double> so_far() const;
  /// What their quantities were when it began.
  const std::vector<double>& at_start() const { return before_; }

  /// A table of the figures in Markdown.
  std::string document() const;

  /// Over the cycles from the second on.
  struct Mean {
    double mean = 0, deviation = 0;  ///< standard deviation of a cycle; 0 of one
  };
  long counted() const { return static_cast<long>(counted_); }  ///< cycles in the means
  Mean mean(std::size_t figure) const;

 private:
  double start_of(double number) const { return number * period_; }
  void take_values();
  void enter(double number, bool is_whole);
  void add(double interval);
  void complete(double end, double next_time);
  double of_cycle(std::size_t figure) const;
  void count(const std::vector<double>& values);

  double period_;
  const QuantityList& quantities_;
  std::vector<CycleFigure> figures_;
  std::vector<Row> completed_;

  // What a checkpoint keeps, in vectors that stay where they are: of the cycle under way, and of all so far.
  double kept_period_ = 0, kept_figures_ = 0;  ///< which the numbers below are of [s], [-]
  double number_ = 0;                          ///< of cycles before this one
  double is_whole_ = 0;                        ///< whether it was seen from its start
  double elapsed_ = 0;                         ///< [s]
  double told_ = 0, counted_ = 0;
  std::vector<double> sums_, before_, last_;  ///< of each figure: integral or peak; value at the start; value now
  std::vector<double> means_, squares_;       ///< over the cycles counted: mean, sum of squares of deviations
};

}  // namespace washfsi
