// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/barrier_function.hpp"
#include "washfsi/contact/barrier_options.hpp"
#include "washfsi/contact/pair_friction.hpp"
#include "washfsi/contact/pair_search.hpp"

namespace washfsi {

/// Keeps cloths, and the parts of one, from passing through each other (Li et al., ACM Trans. Graph. 39 (2020) 49). A
/// pair of facets without a common marker, a marker and a triangle or two edges, in the plane a marker and a segment,
/// at the distance d has the energy
///   E = kappa w d^ m b(d/d^),     w the undeformed area that the pair stands for, m the mollifier of parallel edges
/// and pushes its markers by  -kappa w (m b' share n + d^ b dm/dX). The stiffness is the part  kappa w/d^ m b''
/// (share n)(share n)^T  of its Jacobian, which is never negative. No accepted motion lets facets touch, whatever the
/// step: `free_part`. Each rank has the pairs with a marker of its own, and knows the markers that are near to these.
template <int Dim>
class Barrier : public ContactForce<Dim> {
 public:
  /// Errors: InputError as `barrier_distance`.
  Barrier(const BarrierOptions& options, const Surroundings<Dim>& surroundings);
  /// Makes nothing without cloth.
  static MakeForce<Dim> maker(const BarrierOptions& options);

  Dependence dependence() const override { return Dependence::potential; }
  std::string origin() const override { return "-contact barrier"; }
  bool rubs() const override { return options_.friction > 0; }
  void begin_step(const StepStart<Dim>& start) override;
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
  void add_energy(const Points<Dim>& positions, std::span<double> of_groups) const override;
  void add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction, Points<Dim>& rates) const override;
  void linearise(const Points<Dim>& positions) override;
  void visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                       const AddMarkerBlock<Dim>& add) const override;
  long pattern() const override { return pattern_; }
  void add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const override;
  void add_bound(std::span<StiffnessBound> bounds) const override;
  bool limits_motion() const override { return true; }
  double free_part(const Points<Dim>& from, const Points<Dim>& motion) override;
  void hold_back(const Points<Dim>& from, Points<Dim>& motion) override;

  void add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const override;

  double distance() const { return distance_; }

 private:
  /// A pair nearer than d^, and what it does.
  struct Touch {
    const FacetPair<Dim>* pair;
    Gap<Dim> gap;
    double energy;             ///< [J; per unit depth in the plane]
    double stiffness;          ///< kappa w/d^ m b'' [N/m]
    double push;               ///< -kappa w m b', the normal force [N]
    PairPoints<Dim> forces{};  ///< on its markers [N]

    StiffnessBlock<Dim> block() const { return stiffness * gap.normal * gap.normal.transpose(); }
  };
  using Pairs = std::vector<FacetPair<Dim>>;
  void look_round(const Points<Dim>& positions, Before before = Before::forget);
  void lay_out();
  bool covers(const Points<Dim>& positions) const;
  double farthest_from_places(const Points<Dim>& positions) const;
  void cover(const Points<Dim>& from, const Points<Dim>& motion);
  Points<Dim> known(const Points<Dim>& own) const { return search_.known().values(own); }
  double least_reach() const { return distance_ / 8; }
  const std::vector<Touch>& touches(const Points<Dim>& positions) const;
  std::vector<Touch> touches_at(const Points<Dim>& all) const;
  Touch touch(const FacetPair<Dim>& pair, const Gap<Dim>& gap, const PairPoints<Dim>& places) const;
  template <class Visit>
  void visit_own(const FacetPair<Dim>& pair, const Visit& visit) const;
  void add_blocks(const FacetPair<Dim>& pair, const Gap<Dim>& gap, const StiffnessBlock<Dim>& block,
                  std::vector<StiffnessBlock<Dim>>& blocks) const;
  std::vector<typename PairFriction<Dim>::Pair> rubbing_pairs(const Points<Dim>& all) const;
  void begin_explicit_friction(const Points<Dim>& all, const StepStart<Dim>& start);

  BarrierOptions options_;
  Surroundings<Dim> around_;
  double distance_, spacing_;
  PairSearch<Dim> search_;

  Pairs pairs_;  ///< that may touch, as long as no marker leaves its reach
  bool has_looked_ = false;
  Points<Dim> places_;           ///< of this rank's markers when it looked round [m]
  std::vector<double> reaches_;  ///< of them from there [m]
  /// The columns of the stiffness in the rows of this rank's markers, and where each row's begin.
  std::vector<std::size_t> columns_, rows_;
  long pattern_ = 0;

  mutable Points<Dim> seen_;  ///< places of this rank's markers for which the touches are known
  mutable std::vector<Touch> touches_;
  mutable PairFriction<Dim> friction_;
};

extern template class Barrier<2>;
extern template class Barrier<3>;

}  // namespace washfsi
