// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/body_contact_law.hpp"

#include <algorithm>

#include "washfsi/contact/barrier_function.hpp"

namespace washfsi {

namespace {

// The barrier, continued below a share of its distance as a parabola with the same second derivative.
BarrierValue softened_barrier(double s, double soft) {
  if (s >= soft) return barrier(s);
  const BarrierValue from = barrier(soft);
  const double beyond = s - soft;
  return {from.value + from.first * beyond + 0.5 * from.second * beyond * beyond, from.first + from.second * beyond,
          from.second};
}

}  // namespace

BodyPush body_push(const BodyContactOptions& options, double distance, double begins, double soft) {
  const double p = options.pressure, d = begins;
  if (options.law == BodyContactLaw::barrier) {
    const BarrierValue b = softened_barrier(distance / d, soft);
    return {p * d * b.value, -p * b.first, p / d * b.second};
  }
  const double s = std::max(0.0, 1 - distance / d);
  return {p * d / 3 * s * s * s, p * s * s, 2 * p / d * s};
}

}  // namespace washfsi
