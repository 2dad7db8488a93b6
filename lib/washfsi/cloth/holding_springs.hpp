// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/cloth/marker_force.hpp"

namespace washfsi {

/// Springs that hold some markers (-NAME_hold) where they start.
template <int Dim>
class HoldingSprings : public MarkerForce<Dim> {
 public:
  /// `positions` are those of this rank's markers at the start. The cloths must outlive it.
  HoldingSprings(const Cloths<Dim>& cloths, const Points<Dim>& positions);

  ForceKind kind() const override { return {.dependence = Dependence::potential, .is_elastic = true}; }
  std::string origin() const override { return "-NAME_hold"; }
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
  void add_energy(const Points<Dim>& positions, std::span<double> of_groups) const override;
  void add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction, Points<Dim>& rates) const override;
  void visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                       const AddMarkerBlock<Dim>& add) const override;
  void add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const override;
  void add_bound(std::span<StiffnessBound> bounds) const override;

 private:
  struct Spring {
    std::size_t marker;  ///< index in this rank's arrays
    double stiffness;    ///< [N/m; per unit depth in the plane]
    Point<Dim> anchor;   ///< [m]
  };
  const Cloths<Dim>& cloths_;
  std::vector<Spring> springs_;
};

extern template class HoldingSprings<2>;
extern template class HoldingSprings<3>;

}  // namespace washfsi
