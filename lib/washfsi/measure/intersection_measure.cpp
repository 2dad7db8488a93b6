// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/intersection_measure.hpp"

#include <cmath>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

template <int Dim>
Point<Dim> periods(const Grid<Dim>& grid) {
  Point<Dim> lengths = grid.upper() - grid.lower();
  for (int d = 0; d < Dim; ++d)
    if (!grid.periodic(d)) lengths[d] = 0;
  return lengths;
}

}  // namespace

template <int Dim>
IntersectionMeasure<Dim>::IntersectionMeasure(const System<Dim>& system)
    : system_(system), count_(system.model.cloths, periods(system.model.grid)) {}

template <int Dim>
bool IntersectionMeasure<Dim>::counts() const {
  return system_.model.cloths.marker_count() > 0 && (is_forbidden() || system_.model.verify_interval > 0);
}

template <int Dim>
void IntersectionMeasure<Dim>::declare(QuantityList& quantities) {
  if (!counts()) return;
  quantities.add({"intersections", "-", "edges of cloths that go through a cloth, as counted last",
                  [this] { return count_.total(); }, Accumulation::largest, "/intersections", true});
}

template <int Dim>
void IntersectionMeasure<Dim>::verify_start() {
  if (!counts()) return;
  count_.count(system_.state.positions);
  if (is_forbidden() && count_.total() > 0)
    throw InputError("-contact barrier: at the start " + count_.describe() + "; place the cloths apart");
}

template <int Dim>
void IntersectionMeasure<Dim>::verify(double dt) {
  if (!counts()) return;
  const double interval = system_.model.verify_interval, time = system_.state.clock.time;
  if (interval > 0 && std::floor(time / interval + 1e-6) <= std::floor((time - dt) / interval + 1e-6)) return;
  count_.count(system_.state.positions);
  if (is_forbidden() && count_.total() > 0)
    throw DivergedError("contact: " + count_.describe() + ", which the barrier must not let happen");
}

template class IntersectionMeasure<2>;
template class IntersectionMeasure<3>;

}  // namespace washfsi
