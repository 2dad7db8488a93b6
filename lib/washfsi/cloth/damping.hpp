// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/cloth/marker_force.hpp"

namespace washfsi {

/// Kelvin-Voigt damping of the edges (-NAME_damping).
template <int Dim>
class Damping : public MarkerForce<Dim> {
 public:
  /// The cloths must outlive it.
  explicit Damping(const Cloths<Dim>& cloths);

  ForceKind kind() const override { return {.dependence = Dependence::velocities}; }
  std::string origin() const override { return "-NAME_damping"; }
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;
  void add_bound(std::span<StiffnessBound> bounds) const override;

 private:
  const Cloths<Dim>& cloths_;
  bool any_;
};

extern template class Damping<2>;
extern template class Damping<3>;

}  // namespace washfsi
