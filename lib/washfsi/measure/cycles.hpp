// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/measure/cycle_sums.hpp"
#include "washfsi/measure/mean_and_spread.hpp"
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
  const std::vector<CycleFigure>& figures() const { return current_.figures(); }

  /// The figures of the current cycle.
  std::vector<double> so_far() const { return current_.so_far(); }
  /// The values of their quantities at its start.
  const std::vector<double>& at_start() const { return current_.at_start(); }

  /// A table of the figures in Markdown.
  std::string document() const;

  long counted() const { return means_.count(); }  ///< cycles in the means
  using Mean = MeanAndSpread::Mean;
  /// Mean and spread of a figure over the cycles from the second on.
  Mean mean(std::size_t figure) const { return means_.of(figure); }

 private:
  double start_of(double number) const { return number * period_; }
  void enter(double number, bool is_whole);
  void complete(double end, double next_time);

  double period_;
  const QuantityList& quantities_;
  CycleSums current_;    ///< sums over the current cycle
  MeanAndSpread means_;  ///< means and spread of the figures over the cycles counted
  std::vector<Row> completed_;

  // Numbers for checkpoints, which hold those of `current_` and `means_` too.
  double kept_period_ = 0, kept_figures_ = 0;  ///< period and number of figures of the numbers kept [s], [-]
  double number_ = 0;                          ///< number of cycles before the current one
  double is_whole_ = 0;                        ///< whether that was observed from its start
  double told_ = 0;                            ///< number of the last cycle that was completed
};

}  // namespace washfsi
