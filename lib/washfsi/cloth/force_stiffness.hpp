// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/cloth/marker_force.hpp"
#include "washfsi/cloth/stiffness_rows.hpp"

namespace washfsi {

/// The stiffness K of the forces that depend on places alone: minus the Jacobian of their sum. All members are
/// collective.
template <int Dim>
class ForceStiffness {
 public:
  using ForceList = std::vector<std::unique_ptr<MarkerForce<Dim>>>;

  /// Both stay alive; forces may be added to the list later.
  ForceStiffness(const Cloths<Dim>& cloths, const ForceList& forces) : cloths_(cloths), forces_(forces) {}

  /// K d.
  Points<Dim> product(const Points<Dim>& positions, const Points<Dim>& direction) const;
  /// Creates a matrix with a row for each coordinate of each marker and the nonzero pattern of K; call it again when
  /// `pattern` has changed.
  void lay_out(petsc::Matrix& matrix);
  std::vector<long> pattern() const;
  /// Whether any rank has left out blocks of K that are not in the pattern; and renews the pattern with these.
  bool outgrow_pattern() const;
  void renew_pattern();
  /// Sets a matrix, laid out for this pattern, to factor times K.
  void set(const Points<Dim>& positions, GeometricStiffness geometric, double factor, Mat matrix) const;

 private:
  const Cloths<Dim>& cloths_;
  const ForceList& forces_;
  StiffnessRows<Dim> rows_;  ///< rows of the pattern that was laid out last
};

extern template class ForceStiffness<2>;
extern template class ForceStiffness<3>;

}  // namespace washfsi
