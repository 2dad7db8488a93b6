// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/channel_start.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "washfsi/support/errors.hpp"

namespace washfsi {

const ChoiceNames<ChannelProfile>& names_of(ChannelProfile) {
  static const ChoiceNames<ChannelProfile> names{{"turbulent", ChannelProfile::turbulent},
                                                 {"laminar", ChannelProfile::laminar}};
  return names;
}

ChannelStartOptions ChannelStartOptions::from_options(Options& options) {
  ChannelStartOptions start;
  options.block("", "Channel at the start", [&](OptionBlock& block) {
    block.choice("fluid_initial_profile", start.profile, "mean velocity of -fluid_initial channel");
    block.real("fluid_initial_disturbance", start.disturbance, "-", {0.0, 1.0, false, "a number from 0 to 1"},
               "rms of the random vortices of -fluid_initial channel over its mean velocity, about; 0: none");
    block.integer("fluid_initial_seed", start.seed, non_negative_integer,
                  "of the random vortices of -fluid_initial channel; the same on any number of ranks");
  });
  return start;
}

namespace {

using Vector3 = Eigen::Vector3d;

/// One wave of the disturbance's vector potential.
struct Wave {
  Vector3 number;     ///< wave numbers along the periodic axes [1/m]
  Vector3 potential;  ///< amplitude over the mean speed and the half height
  double across;      ///< number of half waves from wall to wall
  double phase, phase_across;
};

template <int Dim>
int wall_axis(const Grid<Dim>& grid, const Point<Dim>& mean) {
  int axis = -1, walls = 0;
  for (int d = 0; d < Dim; ++d)
    if (!grid.periodic(d)) axis = d, ++walls;
  if (walls != 1) throw InputError("-fluid_initial channel: all axes but one must be periodic");
  if (mean.isZero(0) || mean[axis] != 0)
    throw InputError("-fluid_initial_velocity " + list_text<Dim>(mean) +
                     ": must be along the walls of -fluid_initial " + "channel, and not 0");
  return axis;
}

/// Numbers in [0, 1), the same with any library.
class Random {
 public:
  explicit Random(PetscInt seed) : bits_(static_cast<std::uint64_t>(seed)) {}
  double operator()() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 bits_;
};

template <int Dim>
std::vector<Wave> random_waves(const Grid<Dim>& grid, int wall, const ChannelStartOptions& options) {
  constexpr int count = 40, longest = 4;  // waves in the box
  const double half = 0.5 * (grid.upper() - grid.lower())[wall];
  Random random(options.seed);
  std::vector<Wave> waves;
  for (int n = 0; n < count; ++n) {
    Wave wave{Vector3::Zero(), Vector3::UnitZ(), std::floor(3 * random()) + 1, 0, 0};
    for (int d = 0; d < Dim; ++d)
      if (d != wall)
        wave.number[d] = std::floor((2 * longest + 1) * random() - longest) * 2 * std::numbers::pi /
                         (grid.upper() - grid.lower())[d];
    if (Dim == 3)
      for (int d = 0; d < 3; ++d) wave.potential[d] = 2 * random() - 1;
    wave.phase = 2 * std::numbers::pi * random();
    wave.phase_across = 2 * std::numbers::pi * random();
    const double steepness = std::hypot(wave.number.norm() * half, 0.5 * std::numbers::pi * wave.across);
    // sin cos has the mean square 1/4, (1 - e^2)^2 one of 0.41
    wave.potential *= options.disturbance / (wave.potential.norm() * steepness * std::sqrt(0.25 * 0.41 * count));
    waves.push_back(wave);
  }
  return waves;
}

// The curl of a wave's potential times half height: slope x direction.
Vector3 velocity_of(const Wave& wave, int wall, double e, const Vector3& place, double half) {
  const double hill = (1 - e * e) * (1 - e * e), hill_slope = -4 * e * (1 - e * e);
  const double rate = 0.5 * std::numbers::pi * wave.across, across = rate * (e + 1) + wave.phase_across;
  const double along = wave.number.dot(place) + wave.phase;
  Vector3 slope = -half * hill * std::sin(across) * std::sin(along) * wave.number;
  slope[wall] = (hill_slope * std::sin(across) + hill * rate * std::cos(across)) * std::cos(along);
  return slope.cross(wave.potential);
}

double profile_at(ChannelProfile profile, double e) {
  const double inside = std::max(0.0, 1 - std::abs(e));
  return profile == ChannelProfile::laminar ? 1.5 * inside * (1 + std::abs(e)) : 8.0 / 7 * std::pow(inside, 1.0 / 7);
}

}  // namespace

template <int Dim>
VelocityAt<Dim> channel_start(const Grid<Dim>& grid, const Point<Dim>& mean, const ChannelStartOptions& options) {
  const int wall = wall_axis<Dim>(grid, mean);
  const double half = 0.5 * (grid.upper() - grid.lower())[wall];
  return [wall, half, mean, lower = grid.lower(), profile = options.profile,
          waves = random_waves<Dim>(grid, wall, options)](const Point<Dim>& place, int c) {
    Vector3 from_lower = Vector3::Zero(), velocity = Vector3::Zero();
    for (int d = 0; d < Dim; ++d) from_lower[d] = place[d] - lower[d];
    const double e = from_lower[wall] / half - 1;
    if (std::abs(e) >= 1) return 0.0;
    from_lower[wall] = 0;
    for (const Wave& wave : waves) velocity += velocity_of(wave, wall, e, from_lower, half);
    return mean[c] * profile_at(profile, e) + mean.norm() * velocity[c];
  };
}

template VelocityAt<2> channel_start<2>(const Grid<2>&, const Point<2>&, const ChannelStartOptions&);
template VelocityAt<3> channel_start<3>(const Grid<3>&, const Point<3>&, const ChannelStartOptions&);

}  // namespace washfsi
