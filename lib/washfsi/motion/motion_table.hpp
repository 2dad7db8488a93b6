// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <mpi.h>

#include "washfsi/support/options.hpp"

namespace washfsi {

/// The unit of the angles in a table.
enum class AngleUnit { rad, deg };
const ChoiceNames<AngleUnit>& names_of(AngleUnit);

/// A motion given at some times: displacement of the centre [m] and angle [rad], joined by the cubic spline whose
/// rates are zero at both ends. Velocity is continuous throughout, acceleration within the table; before and after the
/// table the motion rests. Between rows a spline may swing a little beyond their values.
template <int Dim>
class MotionTable {
 public:
  using Row = Eigen::Matrix<double, Dim + 1, 1>;  ///< displacement, then angle
  struct State {
    Row value, rate, acceleration;
  };

  /// Times must increase; as many rows as times, at least two.
  MotionTable(std::vector<double> times, std::vector<Row> rows);

  /// Reads columns time, x, y[, z], angle by `read_time_table`, with its errors: InputError. Collective.
  static MotionTable read(MPI_Comm comm, const std::string& path, const std::string& option,
                          AngleUnit unit = AngleUnit::rad);

  State at(double time) const;
  /// The time of the last row [s].
  double end() const { return times_.back(); }
  /// Whether the centre never moves.
  bool only_turns() const { return largest_rate().template head<Dim>().isZero(0); }
  /// Largest size of each rate at any time [m/s, rad/s].
  Row largest_rate() const;

 private:
  std::vector<double> times_;
  std::vector<Row> rows_, slopes_;

  /// value = rows[k] + slopes[k] t + second t^2 + third t^3 within an interval.
  struct Cubic {
    Row second, third;
  };
  Cubic cubic(std::size_t interval) const;
};

extern template class MotionTable<2>;
extern template class MotionTable<3>;

}  // namespace washfsi
