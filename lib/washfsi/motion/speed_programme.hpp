// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <mpi.h>

namespace washfsi {

/// Strokes of turning: from rest to a speed along half a cosine, at that speed, back to rest, and after a pause the
/// same the other way. Neither speed nor acceleration jumps if there is a ramp.
struct Strokes {
  double speed = 0;   ///< speed of the first stroke, counter-clockwise positive; the second's is its negative [rad/s]
  double ramp = 0;    ///< time from rest to the speed, and back [s]; 0: at once
  double stroke = 0;  ///< time of turning one way, both ramps included [s], 2 ramp at least; 0: one way for ever
  double pause = 0;   ///< time of rest after each stroke [s]
  long cycles = 0;    ///< pairs of strokes, then rest; 0: for ever
};

/// Turning by a programme of speeds from t = 0, or by a table of them: a function of time alone. Speed is made of
/// pieces that rise or fall along half a cosine, or along a line; angle and acceleration are its exact integral and
/// derivative.
class SpeedProgramme {
 public:
  /// Angle since t = 0 and its rates [rad, rad/s, rad/s2].
  struct State {
    double angle, rate, acceleration;
  };

  /// A programme of strokes; it rests before t = 0.
  explicit SpeedProgramme(const Strokes& strokes);
  /// A table of speeds [rad/s] at increasing times [s], at least two; linear in between, constant before the first and
  /// after the last. The table is repeated `cycles` times; 0: for ever.
  SpeedProgramme(const std::vector<double>& times, const std::vector<double>& speeds, long cycles);

  /// Reads columns time [s], speed [rpm] by `read_time_table`, with its errors. InputError, too, if a table that is
  /// repeated ends with another speed than it begins with. Collective.
  static SpeedProgramme read(MPI_Comm comm, const std::string& path, const std::string& option, long cycles);

  State at(double time) const;
  /// Largest size of the rate at any time [rad/s].
  double largest_rate() const;
  /// Period [s]; 0 if it does not repeat.
  double period() const { return repeats_ ? length_ : 0; }

  /// A time that steps have to resolve [s], and the option that gives it.
  struct Span {
    std::string option;
    double duration = std::numeric_limits<double>::infinity();
  };
  /// The ramp, or else the stroke, or a table's length.
  const Span& shortest_span() const { return span_; }

 private:
  /// A change from one speed to another.
  struct Piece {
    double start, duration, from, to;  ///< start and duration in the programme [s]; speeds [rad/s]
    double angle;                      ///< turned since the start of the programme [rad]
    bool smooth;                       ///< whether it follows half a cosine

    State at(double since_start) const;
  };
  void append(double duration, double from, double to, bool smooth);
  void append_stroke(const Strokes& strokes, double speed);
  double turned_at_end() const;
  State since_start(double time) const;

  std::vector<Piece> pieces_;
  double start_ = 0, length_ = 0;  ///< start and length of the programme [s]
  double before_ = 0, after_ = 0;  ///< speeds before the start and after the end [rad/s]
  double at_zero_ = 0;             ///< angle turned from the start to t = 0 [rad]
  long cycles_ = 1;                ///< number of repetitions; 0: for ever
  bool repeats_ = false;
  Span span_;
};

}  // namespace washfsi
