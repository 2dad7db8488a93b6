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
IntersectionMeasure<Dim>::IntersectionMeasure(const System<Dim>& system, BodyDepths<Dim>& depths)
    : system_(system), of_cloths_(system.model.cloths, periods(system.model.grid)), in_bodies_(depths) {}

template <int Dim>
bool IntersectionMeasure<Dim>::counts() const {
  return system_.model.cloths.marker_count() > 0 &&
         (is_forbidden() || system_.model.cloth_treatment.verify_interval > 0);
}

template <int Dim>
void IntersectionMeasure<Dim>::declare(QuantityList& quantities) {
  if (!counts()) return;
  quantities.add({"intersections", "-", "edges of cloths that go through a cloth, as counted last",
                  [this] { return of_cloths_.total(); }, Accumulation::largest, "/intersections", true});
  if (system_.model.body_list.empty()) return;
  quantities.add({"body_intersections", "-", "faces of cloths that reach into a body, as counted last",
                  [this] { return in_bodies_.total(); }, Accumulation::largest, "/body_intersections", true});
}

template <int Dim>
void IntersectionMeasure<Dim>::count() {
  of_cloths_.count(system_.state.positions);
  in_bodies_.look(system_.state.positions, system_.state.clock.time);
}

template <int Dim>
std::string IntersectionMeasure<Dim>::forbidden() const {
  if (!is_forbidden()) return "";
  return of_cloths_.total() > 0 ? of_cloths_.describe() : in_bodies_.example();
}

template <int Dim>
void IntersectionMeasure<Dim>::verify_start() {
  if (!counts()) return;
  count();
  const std::string found = forbidden();
  if (!found.empty())
    throw InputError("-contact barrier: at the start " + found + "; place the cloths apart, and outside of bodies");
}

template <int Dim>
void IntersectionMeasure<Dim>::verify(double dt) {
  if (!counts()) return;
  const double interval = system_.model.cloth_treatment.verify_interval, time = system_.state.clock.time;
  if (interval > 0 && std::floor(time / interval + 1e-6) <= std::floor((time - dt) / interval + 1e-6)) return;
  count();
  const std::string found = forbidden();
  if (!found.empty())
    throw DivergedError("contact: " + found +
                        ", which the barrier must not let happen; shorter -time_step or -time_cfl" +
                        (of_cloths_.total() > 0 ? "" : ", larger -contact_body_distance"));
}

template class IntersectionMeasure<2>;
template class IntersectionMeasure<3>;

}  // namespace washfsi
