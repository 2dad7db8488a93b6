// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "washfsi/cloth/facets.hpp"
#include "washfsi/contact/facing.hpp"
#include "washfsi/contact/gap.hpp"
#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

/// A point of a face, one of its Gauss points, for which the barrier between two surfaces is summed up, and the faces
/// that may come near to it.
template <int Dim>
struct SurfaceSample {
  using Face = typename Facets<Dim>::Face;
  struct Opposite {
    Face face;         ///< indices of its markers among those that the rank knows
    Point<Dim> shift;  ///< shift of its periodic image [m]
    double start;      ///< distance when it was found [m]
  };

  Face face;
  std::array<double, Dim> shares;  ///< shares of its markers: the sample's coordinates in the face
  double weight;                   ///< half of the undeformed area that the sample stands for [m2; m in the plane]
  std::vector<Opposite> opposites;

  Point<Dim> place(const Points<Dim>& all) const {
    Point<Dim> sum = Point<Dim>::Zero();
    for (std::size_t i = 0; i < Dim; ++i) sum += shares[i] * all[face[i]];
    return sum;
  }
};

/// A part that a sample faces, and how often its barrier counts there.
template <int Dim>
struct CountedFacing {
  Facing<Dim> facing;
  int times;
};

/// The distance of a sample from a face [m].
template <int Dim>
double distance_between(const SurfaceSample<Dim>& sample, const typename SurfaceSample<Dim>::Opposite& opposite,
                        const Points<Dim>& all) {
  PairPoints<Dim> places{sample.place(all)};
  for (std::size_t i = 0; i < Dim; ++i) places[i + 1] = all[opposite.face[i]] + opposite.shift;
  return gap_of<Dim>(PairKind::point_facet, places).distance;
}

/// The contact distance between the cloths of two markers [m].
using ContactDistance = std::function<double(std::size_t marker, std::size_t other)>;

/// The parts of other surfaces that a sample faces nearer than the contact distance. The sum over faces of the barrier
/// would count a place over an edge twice, and over a corner of a lattice six times. So that each place of a surface
/// has one barrier, that of each edge is subtracted once less than the number of faces that share it, and that of each
/// corner corrected (inclusion and exclusion: Li, Ferguson et al., arXiv:2307.15908). The sum is smooth; over a flat
/// surface it is the barrier of the distance from it.
template <int Dim>
std::vector<CountedFacing<Dim>> faced_by(const SurfaceSample<Dim>& sample, const Points<Dim>& all,
                                         const ContactDistance& distance);

/// All samples that may come as near as the contact distance, at most `most`, to a face without a common marker, while
/// each marker moves from its place by its reach at most. Only samples are returned of which a marker, of the sample or
/// of a face that it may face, is the rank's, which must know the markers near to all of these.
template <int Dim>
std::vector<SurfaceSample<Dim>> find_samples(const NearMarkers<Dim>& known, const Facets<Dim>& facets,
                                             const Points<Dim>& all, const std::vector<double>& reaches,
                                             const ContactDistance& distance, double most,
                                             const PeriodicSpace<Dim>& space);

extern template std::vector<CountedFacing<2>> faced_by<2>(const SurfaceSample<2>&, const Points<2>&,
                                                          const ContactDistance&);
extern template std::vector<CountedFacing<3>> faced_by<3>(const SurfaceSample<3>&, const Points<3>&,
                                                          const ContactDistance&);
extern template std::vector<SurfaceSample<2>> find_samples<2>(const NearMarkers<2>&, const Facets<2>&, const Points<2>&,
                                                              const std::vector<double>&, const ContactDistance&,
                                                              double, const PeriodicSpace<2>&);
extern template std::vector<SurfaceSample<3>> find_samples<3>(const NearMarkers<3>&, const Facets<3>&, const Points<3>&,
                                                              const std::vector<double>&, const ContactDistance&,
                                                              double, const PeriodicSpace<3>&);

}  // namespace washfsi
