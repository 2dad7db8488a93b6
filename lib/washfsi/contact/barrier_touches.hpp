// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/pair_distances.hpp"
#include "washfsi/contact/pair_search.hpp"

namespace washfsi {

/// Two parts of cloths within their contact distance, and the action of the barrier there.
template <int Dim>
struct Touch {
  Facing<Dim> facing;
  double energy;     ///< [J; per unit depth in the plane]
  double stiffness;  ///< positive part of the stiffness [N/m]
  double taken_off;  ///< negative part of the stiffness [N/m]
  double push;       ///< normal force [N]; negative where the barrier of an edge or a corner is subtracted
  double pressing;   ///< share of the sample's normal force for friction and measures [N]
  double area;       ///< undeformed area that a sample stands for [m2; m in the plane]
  bool is_guard;     ///< whether it is of a pair of facets
  std::array<Point<Dim>, 2 * Dim> forces;  ///< forces on its markers [N]

  StiffnessBlock<Dim> block() const { return stiffness * facing.normal * facing.normal.transpose(); }
};

/// Finds what touches: samples of surfaces, and pairs of facets, the guards, where samples see nothing. Their laws are
/// in contact/barrier.hpp.
template <int Dim>
class BarrierTouches {
 public:
  using Pairs = std::vector<FacetPair<Dim>>;
  using Samples = std::vector<SurfaceSample<Dim>>;

  /// The contact distance of pairs of facets over that of surfaces.
  static constexpr double of_guards = 0.5;

  /// `stiffness` is kappa [Pa]; the contact distances and the cloths must outlive it. Collective.
  BarrierTouches(double stiffness, PairDistances& distances, const Cloths<Dim>& cloths, const PeriodicSpace<Dim>& space)
      : comm_(cloths.comm()), stiffness_(stiffness), distances_(distances), search_(cloths, space) {}

  /// Searches for what may touch while each of this rank's markers moves from its place by its reach at most.
  /// Collective.
  void find_near(const Points<Dim>& positions, const std::vector<double>& reaches, Before before);
  /// Returns what touches at these places of all known markers. No communication.
  std::vector<Touch<Dim>> at(const Points<Dim>& all) const;

  /// Updates the contact distances of what started in contact. Collective.
  void follow_distances(const Points<Dim>& all);
  const PairDistances& distances() const { return distances_; }
  /// The distance at which this contact begins [m].
  double begins(const Touch<Dim>& touch) const;
  /// The least reach of markers [m].
  double least_reach() const { return distances_.usual() / 8; }

  const Pairs& pairs() const { return pairs_; }
  const Samples& samples() const { return samples_; }
  const PairSearch<Dim>& search() const { return search_; }

 private:
  void add_surface_touches(const SurfaceSample<Dim>& sample, const Points<Dim>& all,
                           std::vector<Touch<Dim>>& touches) const;
  void add_guard_touch(const FacetPair<Dim>& pair, const Points<Dim>& all, std::vector<Touch<Dim>>& touches) const;
  Touch<Dim> touch(const Facing<Dim>& facing, double weight, double distance) const;
  double distance_of(std::size_t marker, std::size_t other) const {
    return distances_.of(search_.known().piece_of(marker), search_.known().piece_of(other));
  }
  PairDistances::Nearest nearest(const Points<Dim>& all) const;

  MPI_Comm comm_;
  double stiffness_;
  PairDistances& distances_;
  PairSearch<Dim> search_;
  Pairs pairs_;  ///< pairs that may touch as long as no marker leaves its reach
  Samples samples_;
};

extern template class BarrierTouches<2>;
extern template class BarrierTouches<3>;

}  // namespace washfsi
