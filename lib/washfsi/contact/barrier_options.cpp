// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/barrier_options.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/cloth/facets.hpp"
#include "washfsi/contact/body_contact.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/format_text.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

namespace {

double share_of(double spacing, double share) {
  return std::isfinite(spacing) ? share * spacing : 1;
}

}  // namespace

// The least spacing of markers along the lattices is decisive: nearer markers of a cloth would repel each other.
template <int Dim>
double barrier_distance(const BarrierOptions& options, const Cloths<Dim>& cloths) {
  constexpr double usual = 0.16, most = 0.5;
  const double spacing = least_spacing(cloths);
  if (options.distance == 0) return share_of(spacing, usual);
  if (options.distance > most * spacing)
    throw InputError("-contact_distance " + to_text(options.distance) + ": must be at most half of the least spacing " +
                     format_text("%.6g", spacing) + " m of markers with -contact barrier");
  return options.distance;
}

template <int Dim>
MakeForce<Dim> barrier_of_bodies(const BarrierOptions& options, bool in_water) {
  return [options, in_water](const Surroundings<Dim>& around) {
    constexpr double usual = 0.4;
    double distance = options.body_distance;
    if (distance == 0)
      distance =
          std::max(share_of(least_spacing(around.cloths), usual), in_water ? around.grid.spacing().minCoeff() : 0.0);
    return BodyContact<Dim>::maker(
        {options.stiffness, distance, BodyContactLaw::barrier, options.body_friction, options.damping})(around);
  };
}

template double barrier_distance<2>(const BarrierOptions&, const Cloths<2>&);
template double barrier_distance<3>(const BarrierOptions&, const Cloths<3>&);
template MakeForce<2> barrier_of_bodies<2>(const BarrierOptions&, bool);
template MakeForce<3> barrier_of_bodies<3>(const BarrierOptions&, bool);

}  // namespace washfsi
