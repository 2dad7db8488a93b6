// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "washfsi/measure/quantity.hpp"

namespace washfsi {

/// Running sums over one cycle of a machine, from which its figures follow.
class CycleSums {
 public:
  /// `of_quantities` are the figures of the quantities. If one of them counts as input of energy, the residual of the
  /// balance of energy follows them as the last figure.
  explicit CycleSums(std::vector<CycleFigure> of_quantities);

  /// The figures of a cycle: those of the quantities, and the residual of the balance of energy.
  const std::vector<CycleFigure>& figures() const { return figures_; }

  /// Takes the present values of the quantities, one for each of their figures.
  void take(const std::vector<double>& values);
  /// Begins a cycle with the values taken last.
  void begin();
  /// Adds the values taken last, at the end of an interval [s].
  void add(double interval);

  double elapsed() const { return elapsed_; }  ///< observed time of the cycle [s]
  /// The figures of the cycle so far.
  std::vector<double> so_far() const;
  /// The values of their quantities at its start.
  const std::vector<double>& at_start() const { return before_; }

  /// The number that a restart needs, to read and to set: the observed time of the cycle [s].
  double& kept_elapsed() { return elapsed_; }
  /// Numbers of each figure that a restart needs, to read and to set, with the ends of their names.
  std::array<std::pair<const char*, std::span<double>>, 3> kept();

 private:
  double of_cycle(std::size_t figure) const;

  std::vector<CycleFigure> figures_;
  double elapsed_ = 0;
  std::vector<double> sums_, before_, last_;  ///< for each figure: integral or peak; value at the start; value now
};

}  // namespace washfsi
