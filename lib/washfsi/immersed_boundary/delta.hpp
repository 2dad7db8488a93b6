// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "washfsi/support/options.hpp"

namespace washfsi {

/// Shapes of the regularised delta: the thesis's cosine of any half width; that of Roma, Peskin and Berger of half
/// width 3/2 (J. Comput. Phys. 153 (1999) 509); the same smoothed by Yang, Zhang, Li and He, of half width 2 (J.
/// Comput. Phys. 228 (2009) 7821); Peskin's of half width 2 (Acta Numerica 11 (2002) 479, 6.27); that of Bao, Kaye and
/// Peskin of half width 3 (J. Comput. Phys. 316 (2016) 139), three times continuously differentiable.
enum class DeltaKernel { cosine, roma, yang, peskin, bao };
const ChoiceNames<DeltaKernel>& names_of(DeltaKernel);

/// Shape and half widths of the regularised delta in cells.
struct DeltaOptions {
  DeltaKernel kernel = DeltaKernel::cosine;
  double spread_width = 2, interpolate_width = 2;

  static DeltaOptions from_options(Options& options);
};

/// h phi(x; eps) with x and eps in cells: (1 + cos(pi x / eps)) / (2 eps) for |x| < eps, else 0 (3.4-5). For 2 eps a
/// whole number its sum over unit steps is 1 wherever they start.
inline double cosine_delta(double distance, double width) {
  if (std::abs(distance) >= width) return 0;
  return (1 + std::cos(std::numbers::pi * distance / width)) / (2 * width);
}

/// h phi(x) of Roma, Peskin and Berger, x in cells, for |x| < 3/2: the sum is 1, the first moment vanishes and the sum
/// of squares is 1/2 wherever the points start.
inline double roma_delta(double distance) {
  const double r = std::abs(distance);
  if (r >= 1.5) return 0;
  if (r <= 0.5) return (1 + std::sqrt(1 - 3 * r * r)) / 3;
  return (5 - 3 * r - std::sqrt(std::max(0.0, 1 - 3 * (1 - r) * (1 - r)))) / 6;
}

/// h phi(x) of Yang, Zhang, Li and He, x in cells, for |x| < 2: the mean of `roma_delta` over a cell, so that what a
/// moving marker gives to a face changes without kinks. The sum is 1, the first moment vanishes and the second moment
/// is constant.
inline double yang_delta(double distance) {
  const double r = std::abs(distance), root3 = std::numbers::sqrt3, pi = std::numbers::pi;
  if (r >= 2) return 0;
  if (r <= 1)
    return 17.0 / 48 + root3 * pi / 108 + r / 4 - r * r / 4 + (1 - 2 * r) / 16 * std::sqrt(1 + 12 * r * (1 - r)) -
           root3 / 12 * std::asin(root3 / 2 * (2 * r - 1));
  return 55.0 / 48 - root3 * pi / 108 - 13 * r / 12 + r * r / 4 +
         (2 * r - 3) / 48 * std::sqrt(std::max(0.0, -23 + 12 * r * (3 - r))) +
         root3 / 36 * std::asin(root3 / 2 * (2 * r - 3));
}

/// h phi(x) of Peskin, x in cells, for |x| < 2: sums over even and odd points are equal, the first moment vanishes and
/// the sum of squares is 3/8 wherever the points start.
inline double peskin_delta(double distance) {
  const double r = std::abs(distance);
  if (r >= 2) return 0;
  if (r <= 1) return (3 - 2 * r + std::sqrt(1 + 4 * r * (1 - r))) / 8;
  return (5 - 2 * r - std::sqrt(std::max(0.0, -7 + 4 * r * (3 - r)))) / 8;
}

/// h phi(x) of Bao, Kaye and Peskin, x in cells, for |x| < 3: equal sums over even and odd points, first and third
/// moment zero, the second moment K = 59/60 - sqrt(29)/20 and the sum of squares constant. `r` is the place between
/// grid points; all branches follow from the outermost.
inline double bao_delta(double distance) {
  if (std::abs(distance) >= 3) return 0;
  const double below = std::floor(distance), r = distance - below, r2 = r * r, r3 = r2 * r;
  const double K = 59.0 / 60 - std::sqrt(29.0) / 20;
  const double b = 9.0 / 4 - 1.5 * (K + r2) + (22.0 / 3 - 7 * K) * r - 7.0 / 3 * r3;
  const double c =
      ((161.0 / 36 - 59.0 / 6 * K + 5 * K * K) / 2 * r2 + (-109.0 / 24 + 5 * K) / 3 * r2 * r2 + 5.0 / 18 * r3 * r3) / 4;
  const double outermost = (-b + std::sqrt(b * b - 112 * c)) / 56;
  switch (static_cast<int>(below)) {
    case -3:
      return outermost;
    case -2:
      return -3 * outermost - 1.0 / 16 + (K + r2) / 8 + (3 * K - 1) * r / 12 + r3 / 12;
    case -1:
      return 2 * outermost + 0.25 + (4 - 3 * K) * r / 6 - r3 / 6;
    case 0:
      return 2 * outermost + 5.0 / 8 - (K + r2) / 4;
    case 1:
      return -3 * outermost + 0.25 - (4 - 3 * K) * r / 6 + r3 / 6;
    default:
      return outermost - 1.0 / 16 + (K + r2) / 8 - (3 * K - 1) * r / 12 - r3 / 12;
  }
}

inline double regularised_delta(DeltaKernel kernel, double distance, double width) {
  return kernel == DeltaKernel::cosine   ? cosine_delta(distance, width)
         : kernel == DeltaKernel::roma   ? roma_delta(distance)
         : kernel == DeltaKernel::yang   ? yang_delta(distance)
         : kernel == DeltaKernel::peskin ? peskin_delta(distance)
                                         : bao_delta(distance);
}

/// The grid points that one marker reaches along one axis, at most `Most` of them, with their weights.
template <int Most>
struct AxisStencilOf {
  static constexpr int most = Most;
  PetscInt first = 0;
  int count = 0;
  std::array<double, most> weight{};
};
using AxisStencil = AxisStencilOf<8>;        ///< for kernels of half width up to 4 cells
using NarrowAxisStencil = AxisStencilOf<4>;  ///< for kernels of half width up to 2 cells

/// Calls use(count) with the usual count of points as a compile-time constant, so that loops over them are unrolled.
template <class Use>
void with_count(int count, const Use& use) {
  if (count == 4)
    use(std::integral_constant<int, 4>{});
  else
    use(count);
}

/// The delta along one axis; computes once what does not depend on the marker.
class AxisDelta {
 public:
  AxisDelta(DeltaKernel kernel, double width)
      : kernel_(kernel), width_(width), turn_(std::numbers::pi / width), cos_(std::cos(turn_)), sin_(std::sin(turn_)) {}

  double width() const { return width_; }

  /// `coordinate` is the marker's, in cells from the first grid point of the axis.
  AxisStencil stencil(double coordinate) const {
    AxisStencil stencil;
    stencil.first = static_cast<PetscInt>(std::floor(coordinate - width_)) + 1;
    const auto last = static_cast<PetscInt>(std::ceil(coordinate + width_)) - 1;
    stencil.count = std::min(static_cast<int>(last - stencil.first) + 1, AxisStencil::most);
    const double first = static_cast<double>(stencil.first) - coordinate;
    if (kernel_ == DeltaKernel::cosine)
      set_cosines(turn_ * first, stencil);
    else
      for (int i = 0; i < stencil.count; ++i) stencil.weight[i] = regularised_delta(kernel_, first + i, width_);
    return stencil;
  }

 private:
  // cos and sin of the first angle, turned by the same angle from point to point
  void set_cosines(double angle, AxisStencil& stencil) const {
    const double scale = 0.5 / width_;
    double real = std::cos(angle), imaginary = std::sin(angle);
    for (int i = 0; i < stencil.count; ++i) {
      stencil.weight[i] = scale + scale * real;
      const double turned = real * cos_ - imaginary * sin_;
      imaginary = real * sin_ + imaginary * cos_;
      real = turned;
    }
  }

  DeltaKernel kernel_;
  double width_, turn_, cos_, sin_;
};

}  // namespace washfsi
