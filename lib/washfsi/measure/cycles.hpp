// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/measure/quantity.hpp"

namespace washfsi {

/// Figures of each cycle of a machine, and their means and spread over the cycles from the second on: the first depends
/// on the initial placement of the load.
///
/// A row of the history counts for the cycle in which the middle of its interval lies, so that sums over rows give the
/// figures again.
class Cycles {
 public:
  static constexpr long first_in_means = 2;
  static constexpr long wanted = first_in_means + 1;  ///< for means that have a spread

  static constexpr double whole_run = 1e100;  ///< a period that makes it one cycle [s]

  /// `period` is that of a cycle [s]; 0: no cycles. The list must be complete and outlive it; under `name` it keeps the
  /// numbers for checkpoints.
  Cycles(QuantityList& quantities, double period, const std::string& name);
  Cycles(const Cycles&) = delete;
  Cycles& operator=(const Cycles&) = delete;

  bool are_there() const { return period_ > 0; }
  double period() const { return period_; }  ///< [s]
  /// Number of the last cycle that was completed.
  long completed() const { return static_cast<long>(told_); }

  /// Begins at a time [s] with the values taken last, unless a checkpoint has restored the same cycles.
  void begin(double time);
  /// Restarts the means with the next whole cycle, since the case has changed.
  void forget_means();
  /// Adds the values taken last, at the end of an interval [s].
  void observe(double time, double interval);

  /// A cycle that has been completed.
  struct Row {
    long number = 1;             ///< counted from one at t = 0
    double start = 0, end = 0;   ///< start and end [s]
    std::vector<double> values;  ///< value of each figure
  };
  /// The cycles completed since the last call.
  std::vector<Row> take_completed();

  /// The figures in a row: those of the quantities, and the residual of the balance of energy.
  const std::vector<CycleFigure>& figures() const { return figures_; }

  /// The figures of the current cycle.
  std::vector<double> so_far() const;
  /// The values of their quantities at its start.
  const std::vector<double>& at_start() const { return before_; }

  /// A table of the figures in Markdown.
  std::string document() const;

  /// Mean and spread over the cycles from the second on.
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

  // The state for checkpoints, in vectors that are never reallocated: of the current cycle, and of all so far.
  double kept_period_ = 0, kept_figures_ = 0;  ///< period and number of figures of the numbers below [s], [-]
  double number_ = 0;                          ///< number of cycles before this one
  double is_whole_ = 0;                        ///< whether it was observed from its start
  double elapsed_ = 0;                         ///< observed time of the cycle [s]
  double told_ = 0, counted_ = 0;
  std::vector<double> sums_, before_, last_;  ///< for each figure: integral or peak; value at the start; value now
  std::vector<double> means_, squares_;       ///< over the cycles counted: mean, sum of squares of deviations
};

}  // namespace washfsi
