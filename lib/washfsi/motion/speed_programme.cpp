// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/motion/speed_programme.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "washfsi/motion/time_table.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

SpeedProgramme::State SpeedProgramme::Piece::at(double since_start) const {
  const double t = since_start - start, change = to - from;
  if (!smooth) {
    const double slope = change / duration;
    return {angle + t * (from + 0.5 * slope * t), from + slope * t, slope};
  }
  const double k = std::numbers::pi / duration, phase = k * t;
  return {angle + from * t + 0.5 * change * (t - std::sin(phase) / k), from + 0.5 * change * (1 - std::cos(phase)),
          0.5 * change * k * std::sin(phase)};
}

void SpeedProgramme::append(double duration, double from, double to, bool smooth) {
  if (duration <= 0) return;
  pieces_.push_back({length_, duration, from, to, turned_at_end(), smooth});
  length_ += duration;
}

double SpeedProgramme::turned_at_end() const {
  if (pieces_.empty()) return 0;
  const Piece& last = pieces_.back();
  return last.angle + 0.5 * (last.from + last.to) * last.duration;  // the mean speed of either shape
}

void SpeedProgramme::append_stroke(const Strokes& strokes, double speed) {
  append(strokes.ramp, 0, speed, true);
  append(strokes.stroke - 2 * strokes.ramp, speed, speed, false);
  append(strokes.ramp, speed, 0, true);
  append(strokes.pause, 0, 0, false);
}

SpeedProgramme::SpeedProgramme(const Strokes& strokes) : cycles_(strokes.cycles) {
  if (strokes.stroke > 0) {
    append_stroke(strokes, strokes.speed);
    append_stroke(strokes, -strokes.speed);
    repeats_ = strokes.speed != 0;
  } else {
    append(strokes.ramp, 0, strokes.speed, true);
    after_ = strokes.speed;
    cycles_ = 1;
  }
  if (strokes.ramp > 0)
    span_ = {"ramp " + to_text(strokes.ramp), strokes.ramp};
  else if (strokes.stroke > 0)
    span_ = {"stroke " + to_text(strokes.stroke), strokes.stroke};
}

SpeedProgramme::SpeedProgramme(const std::vector<double>& times, const std::vector<double>& speeds, long cycles)
    : start_(times.front()), before_(speeds.front()), after_(speeds.back()), cycles_(cycles), repeats_(cycles != 1) {
  for (std::size_t k = 0; k + 1 < times.size(); ++k) append(times[k + 1] - times[k], speeds[k], speeds[k + 1], false);
  at_zero_ = since_start(-start_).angle;
  span_ = {"speed_file", length_};
}

SpeedProgramme SpeedProgramme::read(MPI_Comm comm, const std::string& path, const std::string& option, long cycles) {
  std::vector<double> times, speeds;
  for (const auto& row : read_time_table(comm, path, option, "time,speed")) {
    times.push_back(row[0]);
    speeds.push_back(row[1] * std::numbers::pi / 30);
  }
  if (cycles != 1 && speeds.front() != speeds.back())
    throw InputError(option + " " + path + ": must end with the speed that it begins with, since it is repeated");
  return {times, speeds, cycles};
}

SpeedProgramme::State SpeedProgramme::at(double time) const {
  const State now = since_start(time - start_);
  return {now.angle - at_zero_, now.rate, now.acceleration};
}

// Time and angle count from the programme's start.
SpeedProgramme::State SpeedProgramme::since_start(double time) const {
  if (time < 0) return {before_ * time, before_, 0};
  const double cycle = length_ > 0 ? std::floor(time / length_) : 1;
  if (cycles_ > 0 && cycle >= static_cast<double>(cycles_)) {
    const auto count = static_cast<double>(cycles_);
    return {count * turned_at_end() + after_ * (time - count * length_), after_, 0};
  }
  const double within = std::clamp(time - cycle * length_, 0.0, length_);
  const auto next = std::upper_bound(pieces_.begin() + 1, pieces_.end(), within,
                                     [](double moment, const Piece& piece) { return moment < piece.start; });
  const State state = std::prev(next)->at(within);
  return {cycle * turned_at_end() + state.angle, state.rate, state.acceleration};
}

double SpeedProgramme::largest_rate() const {
  double largest = std::max(std::abs(before_), std::abs(after_));
  for (const Piece& piece : pieces_) largest = std::max({largest, std::abs(piece.from), std::abs(piece.to)});
  return largest;
}

}  // namespace washfsi
