// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/cloth/marker_force.hpp"

namespace washfsi {

/// The elasticity of the groups of one elastic model, in the energy form of `sheet.hpp`.
template <int Dim>
class Elasticity : public MarkerForce<Dim> {
 public:
  /// The cloths must outlive it.
  explicit Elasticity(const Cloths<Dim>& cloths, ElasticModel model = ElasticModel::energy);

  ForceKind kind() const override { return {.dependence = Dependence::potential, .is_elastic = true}; }
  std::string origin() const override;
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
  void add_energy(const Points<Dim>& positions, std::span<double> of_groups) const override;
  void add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction, Points<Dim>& rates) const override;
  void visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                       const AddMarkerBlock<Dim>& add) const override;
  void add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const override;
  void add_bound(std::span<StiffnessBound> bounds) const override;

 protected:
  const Cloths<Dim>& cloths() const { return cloths_; }
  const std::vector<LatticePart>& parts() const { return parts_; }

 private:
  const Cloths<Dim>& cloths_;
  ElasticModel model_;
  std::vector<LatticePart> parts_;  ///< parts of the groups with this model
};

/// The thesis's strong form of elasticity (`love.hpp`), which has no energy: measured energy and approximate Jacobian
/// are those of the energy form.
template <int Dim>
class StrongElasticity : public Elasticity<Dim> {
 public:
  explicit StrongElasticity(const Cloths<Dim>& cloths) : Elasticity<Dim>(cloths, ElasticModel::love) {}

  ForceKind kind() const override { return {.dependence = Dependence::places, .is_elastic = true}; }
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
};

extern template class Elasticity<2>;
extern template class Elasticity<3>;
extern template class StrongElasticity<2>;
extern template class StrongElasticity<3>;

}  // namespace washfsi
