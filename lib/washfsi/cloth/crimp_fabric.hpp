// SPDX-License-Identifier: BSD-3-Clause
//
// Cloth that stiffens as its yarns straighten (compare Kawabata, Niwa and Kawai, J. Textile Inst. 64 (1973) 47, on
// plain weaves): along warp and weft a bilinear law with a smooth knee, ours. Below the knee the crimp of the yarns is
// pulled out, with the modulus K_0; beyond it the yarns themselves are stretched, with K_1 >= K_0:
//   dN/dE = K_0 + (K_1 - K_0) (1 + E~/sqrt(1 + E~^2))/2,   E~ = (E - E_c)/E_w,   N(0) = 0
// All else is as in the linear model with K_0, including the lower modulus of a bare edge, so that the energy is convex
// in the strains.
#pragma once

#include <cmath>

#include "washfsi/cloth/linear_fabric.hpp"
#include "washfsi/cloth/warp_weft.hpp"

namespace washfsi {

/// The contribution of the yarns to the modulus of an edge, rise (1 + E~/sqrt(1 + E~^2))/2 with `rise` = K_1 - K_0 and
/// E~ = (E - strain)/width; and to its resultant and energy, the first and second integrals from E = 0.
class CrimpKnee {
 public:
  CrimpKnee() = default;
  CrimpKnee(double rise, double strain, double width)
      : rise_(rise), strain_(strain), width_(width), at_rest_(-strain / width), root_at_rest_(root_of(at_rest_)) {}

  EdgeResponse operator()(double strain) const {
    const double x = (strain - strain_) / width_, root = root_of(x);
    const double moved = x - at_rest_, slope = (x + at_rest_) / (root + root_at_rest_);  // (root - root_at_rest)/moved
    const double twice = moved * (moved + x * slope - root_at_rest_) + std::asinh(x) - std::asinh(at_rest_);
    return {0.25 * rise_ * width_ * width_ * twice, 0.5 * rise_ * strain * (1 + slope), 0.5 * rise_ * (1 + x / root)};
  }

 private:
  static double root_of(double x) { return std::sqrt(1 + x * x); }

  double rise_ = 0, strain_ = 0, width_ = 1;
  double at_rest_ = 0, root_at_rest_ = 1;  ///< E~_0 and sqrt(1 + E~_0^2), without strain
};

/// The knee of the curves along warp and weft.
struct Crimp {
  WarpWeft yarn_modulus{};  ///< K_1, not below K_0 [N/m]
  WarpWeft strain{};        ///< E_c, strain at the knee
  double width = 0.01;      ///< E_w
};

/// The law of a fabric with crimp.
class CrimpFabric {
 public:
  static constexpr const char* name = "crimp";

  /// `crimped` is the law while the crimp lasts, with K_0 as modulus of extension; `crimp` describes the knee.
  CrimpFabric(const LinearFabric& crimped, const Crimp& crimp);
  static CrimpFabric from_options(OptionBlock& block, std::size_t directions);

  EdgeResponse warp(double strain, double bare) const { return sum(crimped_.warp(strain, bare), warp_(strain)); }
  EdgeResponse weft(double strain, double bare) const { return sum(crimped_.weft(strain, bare), weft_(strain)); }
  MeanQuad quad(const QuadVector& strains) const { return crimped_.quad(strains); }
  double warp_modulus(double strain) const { return crimped_.warp_modulus(strain) + warp_(strain).tangent; }
  double weft_modulus(double strain) const { return crimped_.weft_modulus(strain) + weft_(strain).tangent; }
  const BendingModuli& bending() const { return crimped_.bending(); }
  LargestModuli largest_moduli() const;

 private:
  static EdgeResponse sum(const EdgeResponse& a, const EdgeResponse& b) {
    return {a.energy + b.energy, a.resultant + b.resultant, a.tangent + b.tangent};
  }

  LinearFabric crimped_;
  WarpWeft yarn_modulus_;
  CrimpKnee warp_, weft_;
};

}  // namespace washfsi
