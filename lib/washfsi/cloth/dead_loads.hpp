// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/cloth/marker_force.hpp"

namespace washfsi {

/// Forces independent of the markers' motion: the weight of the excess mass, loads per area (-NAME_load) and at the
/// edges before the first and after the last row (-NAME_end_force_...).
template <int Dim>
class DeadLoads : public MarkerForce<Dim> {
 public:
  /// `gravity` in [m/s2].
  DeadLoads(const Cloths<Dim>& cloths, const Point<Dim>& gravity);

  ForceKind kind() const override { return {.dependence = Dependence::none}; }
  std::string origin() const override { return "-gravity, -NAME_load"; }
  void add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const override;

 private:
  Points<Dim> loads_;
};

extern template class DeadLoads<2>;
extern template class DeadLoads<3>;

}  // namespace washfsi
