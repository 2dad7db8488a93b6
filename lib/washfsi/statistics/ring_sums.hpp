// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "washfsi/grid/viscous_stress.hpp"
#include "washfsi/statistics/ring_bins.hpp"

namespace washfsi {

/// A moment of a liquid among bodies.
struct LiquidMoment {
  Vec velocity = nullptr;     ///< velocity: local, of face_dm, its ghosts filled [m/s]
  Vec fluid_share = nullptr;  ///< fluid share of faces, global; null without bodies
  double density = 1;         ///< density of the pure liquid [kg/m3]
  double pure_viscosity = 0;  ///< viscosity without models [Pa s]
  Viscosity viscosity = {};   ///< viscosity with models
};

/// The number of sums in each ring. Each cell counts by its share of liquid. With R' the offset of its centre from the
/// middle of the ring along R, here in widths of the ring, and e the rate of strain, they are the sums of
///   1, R', R'^2,   u_R, u_theta, u_z,   R' u_R, R' u_theta, R' u_z,   |u|^2,   2 nu e:e,   2 nu_t e:e
inline constexpr std::size_t ring_sum_count = 12;

/// The sums of one moment, ring by ring. The same on all ranks. Collective.
std::vector<double> ring_sums(const Grid<3>& grid, const RingBins& bins, const LiquidMoment& flow);

/// The means over the liquid in a ring, from its sums.
struct RingMeans {
  double liquid = 0;             ///< the first sum
  Point<3> velocity;             ///< mean <u> along R, theta and z [m/s]
  double turbulence_energy = 0;  ///< k_t, half of the variance of the velocity about its mean, linear in R [m2/s2]
  double dissipation = 0;        ///< mean of 2 nu e:e, nu that of the pure liquid [m2/s3]
  double model_dissipation = 0;  ///< mean of 2 nu_t e:e, nu_t that of models [m2/s3]

  /// All means are not a number where there was no liquid.
  static RingMeans of(std::span<const double, ring_sum_count> sums);
};

}  // namespace washfsi
