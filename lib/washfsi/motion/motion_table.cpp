// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/motion/motion_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "washfsi/motion/time_table.hpp"

namespace washfsi {

const ChoiceNames<AngleUnit>& names_of(AngleUnit) {
  static const ChoiceNames<AngleUnit> names{{"rad", AngleUnit::rad}, {"deg", AngleUnit::deg}};
  return names;
}

namespace {

// Slopes of the spline with continuous second derivative, zero at both ends: a tridiagonal system by elimination.
template <class Row>
std::vector<Row> clamped_slopes(const std::vector<double>& times, const std::vector<Row>& rows) {
  const std::size_t last = rows.size() - 1;
  std::vector<Row> slopes(rows.size(), Row::Zero());
  std::vector<double> upper(rows.size(), 0.0);
  for (std::size_t k = 1; k < last; ++k) {
    const double before = 1 / (times[k] - times[k - 1]), after = 1 / (times[k + 1] - times[k]);
    const Row right = 3 * (before * before * (rows[k] - rows[k - 1]) + after * after * (rows[k + 1] - rows[k]));
    const double pivot = 2 * (before + after) - before * upper[k - 1];
    upper[k] = after / pivot;
    slopes[k] = (right - before * slopes[k - 1]) / pivot;
  }
  for (std::size_t k = last; k-- > 1;) slopes[k] -= upper[k] * slopes[k + 1];
  return slopes;
}

}  // namespace

template <int Dim>
MotionTable<Dim>::MotionTable(std::vector<double> times, std::vector<Row> rows)
    : times_(std::move(times)), rows_(std::move(rows)), slopes_(clamped_slopes(times_, rows_)) {}

template <int Dim>
MotionTable<Dim> MotionTable<Dim>::read(MPI_Comm comm, const std::string& path, const std::string& option,
                                        AngleUnit unit) {
  const double unit_of_angle = unit == AngleUnit::deg ? std::numbers::pi / 180 : 1;
  std::vector<double> times;
  std::vector<Row> rows;
  for (const auto& numbers : read_time_table(comm, path, option, Dim == 2 ? "time,x,y,angle" : "time,x,y,z,angle")) {
    times.push_back(numbers[0]);
    rows.emplace_back(&numbers[1]);
    rows.back()[Dim] *= unit_of_angle;
  }
  return {std::move(times), std::move(rows)};
}

template <int Dim>
typename MotionTable<Dim>::Cubic MotionTable<Dim>::cubic(std::size_t k) const {
  const double length = times_[k + 1] - times_[k];
  const Row mean = (rows_[k + 1] - rows_[k]) / length;
  return {(3 * mean - 2 * slopes_[k] - slopes_[k + 1]) / length,
          (slopes_[k] + slopes_[k + 1] - 2 * mean) / (length * length)};
}

template <int Dim>
typename MotionTable<Dim>::State MotionTable<Dim>::at(double time) const {
  if (time <= times_.front()) return {rows_.front(), Row::Zero(), Row::Zero()};
  if (time >= times_.back()) return {rows_.back(), Row::Zero(), Row::Zero()};
  const auto next = std::upper_bound(times_.begin(), times_.end(), time);
  const auto k = static_cast<std::size_t>(next - times_.begin()) - 1;
  const double t = time - times_[k];
  const auto [second, third] = cubic(k);
  return {rows_[k] + t * (slopes_[k] + t * (second + t * third)), slopes_[k] + t * (2 * second + 3 * t * third),
          2 * second + 6 * t * third};
}

// The rate is a parabola in each interval: largest at a row or at its vertex.
template <int Dim>
typename MotionTable<Dim>::Row MotionTable<Dim>::largest_rate() const {
  Row largest = Row::Zero();
  for (std::size_t k = 0; k + 1 < rows_.size(); ++k) {
    largest = largest.cwiseMax(slopes_[k].cwiseAbs());
    const auto [second, third] = cubic(k);
    for (int c = 0; c <= Dim; ++c) {
      const double t = -second[c] / (3 * third[c]);  // not finite, hence outside, for a straight line
      if (t > 0 && t < times_[k + 1] - times_[k])
        largest[c] = std::max(largest[c], std::abs(slopes_[k][c] + second[c] * t));
    }
  }
  return largest;
}

template class MotionTable<2>;
template class MotionTable<3>;

}  // namespace washfsi
