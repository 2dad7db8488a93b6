// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/motion/motion.hpp"

#include <cmath>
#include <numbers>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

/// The displacement of a motion of unit speed, and its rates.
struct Progress {
  double value, rate, acceleration;
};

Progress progress(double frequency, double time) {
  if (frequency == 0) return {time, 1, 0};
  const double omega = 2 * std::numbers::pi * frequency, phase = omega * time;
  return {(1 - std::cos(phase)) / omega, std::sin(phase), omega * std::cos(phase)};
}

}  // namespace

template <int Dim>
typename RigidMotion<Dim>::State RigidMotion<Dim>::state(double time) const {
  if (table) {
    const auto [value, rate, acceleration] = table->at(time);
    return {center + value.template head<Dim>(),
            rate.template head<Dim>(),
            acceleration.template head<Dim>(),
            value[Dim],
            rate[Dim],
            acceleration[Dim]};
  }
  if (programme) {
    const auto [angle, rate, acceleration] = programme->at(time);
    return {center, Point<Dim>::Zero(), Point<Dim>::Zero(), angle, rate, acceleration};
  }
  const auto [value, rate, acceleration] = progress(frequency, time);
  return {center + value * translation, rate * translation,   acceleration * translation,
          angular_speed * value,        angular_speed * rate, angular_speed * acceleration};
}

template <int Dim>
bool RigidMotion<Dim>::at_rest() const {
  if (table) return table->largest_rate().isZero(0);
  if (programme) return programme->largest_rate() == 0;
  return angular_speed == 0 && translation.isZero(0);
}

template <int Dim>
double RigidMotion<Dim>::period() const {
  if (programme) return programme->period();
  return frequency > 0 && !at_rest() ? 1 / frequency : 0;
}

template <int Dim>
SpeedProgramme::Span RigidMotion<Dim>::shortest_span() const {
  if (at_rest()) return {};
  if (programme) return programme->shortest_span();
  if (frequency == 0) return {};
  return {"frequency " + to_text(frequency), 1 / frequency};
}

template <int Dim>
Point<Dim> RigidMotion<Dim>::State::velocity_at(const Point<Dim>& place) const {
  const Point<Dim> arm = place - center;
  Point<Dim> result = velocity;
  result.template head<2>() += angular_velocity * Point<2>(-arm[1], arm[0]);
  return result;
}

template <int Dim>
Point<Dim> RigidMotion<Dim>::State::acceleration_at(const Point<Dim>& place) const {
  const Point<2> arm = (place - center).template head<2>();
  Point<Dim> result = acceleration;
  result.template head<2>() +=
      angular_acceleration * Point<2>(-arm[1], arm[0]) - angular_velocity * angular_velocity * arm;
  return result;
}

template <int Dim>
double RigidMotion<Dim>::largest_speed(double arm) const {
  if (programme) return programme->largest_rate() * arm;
  if (!table) return translation.norm() + std::abs(angular_speed) * arm;
  const auto rate = table->largest_rate();
  return rate.template head<Dim>().norm() + rate[Dim] * arm;
}

template <int Dim>
typename RigidMotion<Dim>::Pose RigidMotion<Dim>::pose(double time) const {
  const State now = state(time);
  return Pose::at(now.center, now.angle);
}

namespace {

// The options of a motion; `motion` contains those that are used as they are.
template <int Dim>
struct MotionOptions {
  std::string prefix;  ///< -NAME_
  RigidMotion<Dim> motion;
  double rpm = 0;
  Strokes strokes;
  std::string motion_file, speed_file;
  AngleUnit angle_unit = AngleUnit::rad;

  void read_speeds(OptionBlock& block);
  void read_programme(OptionBlock& block);
  void check() const;
  RigidMotion<Dim> make(MPI_Comm comm) const;

 private:
  using Given = std::vector<std::pair<std::string, bool>>;
  void refuse(const std::string& option, const Given& others) const;
  void refuse_beside_files() const;
  void check_strokes() const;
  bool is_programme() const { return strokes.ramp > 0 || strokes.stroke > 0; }
};

template <int Dim>
void MotionOptions<Dim>::read_speeds(OptionBlock& block) {
  block.template point<Dim>("center", motion.center, "m", "place of the body's centre, about which it turns");
  block.real("angular_speed", motion.angular_speed, "rad/s", any_number, "speed of rotation, or its largest value");
  block.real("rpm", rpm, "1/min", any_number,
             "the same in revolutions per minute, instead of angular_speed; 0: angular_speed counts");
  block.template point<Dim>("velocity", motion.translation, "m/s", "velocity of the centre, or its largest value");
  block.real("frequency", motion.frequency, "Hz", non_negative, "of an oscillating motion; 0: steady");
}

template <int Dim>
void MotionOptions<Dim>::read_programme(OptionBlock& block) {
  block.real("ramp", strokes.ramp, "s", non_negative,
             "time in which the speed of rotation is reached from rest, along half a cosine; 0: at once");
  block.real("stroke", strokes.stroke, "s", non_negative,
             "duration of turning one way, ramps included, before it turns the other way; 0: one way for ever");
  block.real("pause", strokes.pause, "s", non_negative, "rest after each stroke; 0: none");
  block.file("speed_file", speed_file,
             "table of the speed of rotation instead: time in s, speed in rpm; linear between rows");
  PetscInt cycles = speed_file.empty() ? 0 : 1;
  block.integer("cycles", cycles, non_negative_integer,
                "number of pairs of strokes, or of passes of speed_file (unless given, 1); 0: for ever");
  strokes.cycles = cycles;
  block.file("motion_file", motion_file,
             "table of the motion instead: time, x, y[, z], angle; the place is added to center");
  block.choice("angle_unit", angle_unit, "of the angles in motion_file");
}

template <int Dim>
void MotionOptions<Dim>::refuse(const std::string& option, const Given& others) const {
  for (const auto& [other, given] : others)
    if (given) throw InputError(prefix + option + ": cannot be combined with " + prefix + other + "; set that to 0");
}

template <int Dim>
void MotionOptions<Dim>::refuse_beside_files() const {
  Given others{{"angular_speed", motion.angular_speed != 0},
               {"rpm", rpm != 0},
               {"velocity", !motion.translation.isZero(0)},
               {"frequency", motion.frequency != 0},
               {"ramp", strokes.ramp != 0},
               {"stroke", strokes.stroke != 0},
               {"pause", strokes.pause != 0}};
  if (!speed_file.empty()) refuse("speed_file " + speed_file, others);
  others.emplace_back("speed_file", !speed_file.empty());
  others.emplace_back("cycles", strokes.cycles != 0);
  if (!motion_file.empty()) refuse("motion_file " + motion_file, others);
}

template <int Dim>
void MotionOptions<Dim>::check_strokes() const {
  const auto& [speed, ramp, stroke, pause, cycles] = strokes;
  if (is_programme())
    refuse(ramp > 0 ? "ramp " + to_text(ramp) : "stroke " + to_text(stroke),
           {{"velocity", !motion.translation.isZero(0)}, {"frequency", motion.frequency != 0}});
  if (stroke > 0 && stroke < 2 * ramp)
    throw InputError(prefix + "stroke " + to_text(stroke) + ": must be at least twice " + prefix + "ramp " +
                     to_text(ramp));
  if (stroke == 0 && pause > 0) throw InputError(prefix + "pause " + to_text(pause) + ": needs " + prefix + "stroke");
  if (stroke == 0 && cycles > 0 && speed_file.empty())
    throw InputError(prefix + "cycles " + std::to_string(cycles) + ": needs " + prefix + "stroke or " + prefix +
                     "speed_file");
}

template <int Dim>
void MotionOptions<Dim>::check() const {
  if (rpm != 0) refuse("rpm " + to_text(rpm), {{"angular_speed", motion.angular_speed != 0}});
  refuse_beside_files();
  check_strokes();
  if (angle_unit != AngleUnit::rad && motion_file.empty())
    throw InputError(prefix + "angle_unit " + name_of(angle_unit) + ": needs " + prefix + "motion_file");
}

template <int Dim>
RigidMotion<Dim> MotionOptions<Dim>::make(MPI_Comm comm) const {
  RigidMotion<Dim> made = motion;
  if (rpm != 0) made.angular_speed = rpm * std::numbers::pi / 30;
  if (!motion_file.empty())
    made.table = std::make_shared<const MotionTable<Dim>>(
        MotionTable<Dim>::read(comm, motion_file, prefix + "motion_file", angle_unit));
  if (!speed_file.empty())
    made.programme = std::make_shared<const SpeedProgramme>(
        SpeedProgramme::read(comm, speed_file, prefix + "speed_file", strokes.cycles));
  if (is_programme()) {
    Strokes of_speed = strokes;
    of_speed.speed = made.angular_speed;
    made.programme = std::make_shared<const SpeedProgramme>(of_speed);
  }
  return made;
}

}  // namespace

template <int Dim>
RigidMotion<Dim> RigidMotion<Dim>::from_options(Options& options, const std::string& name) {
  MotionOptions<Dim> read{"-" + name + "_", {}, 0, {}, {}, {}, {}};
  options.block(
      name + "_", "Motion of body " + name,
      [&](OptionBlock& block) {
        read.read_speeds(block);
        read.read_programme(block);
      },
      "bodies_");
  read.check();
  RigidMotion<Dim> motion = read.make(options.comm());
  if (motion.at_rest())
    options.mark_idle("body " + name + " does not move", {name + "_frequency", name + "_ramp", name + "_stroke",
                                                          name + "_pause", name + "_cycles", name + "_rpm"});
  return motion;
}

template struct RigidMotion<2>;
template struct RigidMotion<3>;

}  // namespace washfsi
