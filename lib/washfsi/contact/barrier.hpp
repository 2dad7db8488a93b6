// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/barrier_contacts.hpp"
#include "washfsi/contact/block_places.hpp"
#include "washfsi/contact/contact_potential.hpp"

namespace washfsi {

/// Keeps cloths, and the parts of one, from passing through each other (Li et al., ACM Trans. Graph. 39 (2020) 49). Two
/// surfaces repel each other where they are nearer than the contact distance d^: a sample, a Gauss point of a face, at
/// the distance d from another surface, has the energy
///   Psi = kappa A_s d^ b(d/d^),     A_s half of the undeformed area for which the sample stands
/// and exerts the forces -kappa A_s b' share n on its markers and on those of what it faces
/// (contact/surface_samples.hpp). So two flat sheets at the distance d press each other with -kappa b'(d/d^), wherever
/// they lie. Corners and creases may come nearer than samples see. So pairs of facets without a common marker, a marker
/// and a triangle or two edges, in 2D a marker and a segment, guard what is between them within half of the contact
/// distance:
///   Psi = kappa A_s d^/2 eta b(2 d/d^),     A_s the undeformed area of the pair, eta the factor of parallel edges
/// The stiffness is the part  kappa A_s/d^ b'' (share n)(share n)^T  of the Jacobian, which is never negative. Near the
/// solution of a step, where the elastic stiffness is complete too, the second derivative of the distance is added
/// (contact/distance_curvature.hpp). No accepted motion lets facets touch, whatever the step: `step_limit`. Parts that
/// start nearer than d^ have their own distance (contact/pair_distances.hpp). Each rank has the samples and pairs with
/// a marker of its own, and knows the markers that are near to these.
template <int Dim>
class Barrier : public ContactPotential<Dim> {
 public:
  /// Errors: InputError as `barrier_distance`.
  Barrier(const BarrierOptions& options, const Surroundings<Dim>& surroundings);
  /// Returns what creates the force; it creates none without cloth.
  static MakeForce<Dim> maker(const BarrierOptions& options);

  std::string origin() const override { return "-contact barrier"; }
  void begin_step(const StepStart<Dim>& start) override;
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
  void add_energy(const Points<Dim>& positions, std::span<double> of_groups) const override;
  void add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction, Points<Dim>& rates) const override;
  void linearise(const Points<Dim>& positions) override;
  void visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                       const AddMarkerBlock<Dim>& add) const override;
  long pattern() const override { return places_of_blocks_.pattern(); }
  bool outgrows_pattern() const override { return places_of_blocks_.leaves_out(); }
  void renew_pattern() override;
  void add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const override;
  void add_bound(std::span<StiffnessBound> bounds) const override;
  double step_limit(const Points<Dim>& from, const Points<Dim>& motion) override;
  void shorten(const Points<Dim>& from, Points<Dim>& motion) override;

  void add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const override;
  TightestContact tightest() const override;

 private:
  BarrierOptions options_;
  const Cloths<Dim>& cloths_;
  double spacing_;
  BarrierContacts<Dim> contacts_;
  mutable BlockPlaces<Dim> places_of_blocks_;
};

extern template class Barrier<2>;
extern template class Barrier<3>;

}  // namespace washfsi
