// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "washfsi/contact/pair_search.hpp"

namespace washfsi {

/// Two facets that rub in a step: where they touch, and how hard they are pressed, is taken at its start.
template <int Dim>
struct Rub {
  FacetPair<Dim> pair;
  Gap<Dim> gap;
  double limit;  ///< friction coefficient times normal force [N; per unit depth in the plane]
};

/// What a pair does that has slid by some way.
template <int Dim>
struct RubForce {
  const Rub<Dim>* rub;
  double energy = 0, work = 0;    ///< of the potential, and that it takes out of the cloths in the step [J]
  Point<Dim> pull;                ///< -share times this is the force on a marker [N]
  StiffnessBlock<Dim> stiffness;  ///< of Newton's method [N/m]
};

/// Coulomb friction between cloths in a step, lagged (Li et al., ACM Trans. Graph. 39 (2020) 49): with the normal n,
/// the shares and the normal force of the step's start, and the slide u = (1 - n n^T) sum share (X - X^n), a pair pulls
/// with
///   limit f(|u|) u/|u|,      f(y) = 2 y/e - y^2/e^2 for y < e, else 1,      e = dt times `creep_speed`
/// the gradient of a convex energy. Below that speed it sticks but for a creep.
/// Newton's method with its Hessian jumps to and fro across the kink at rest, and with the pull over the slide in place
/// of it creeps up where pairs are about to slide. So the direction q of the pull is an unknown of its own, with
/// g q = u, g = |u|/f(|u|)  (Chan, Golub and Mulet, SIAM J. Sci. Comput. 20 (1999) 1964): with u eliminated for it
///   limit/g (1 - n n^T - g'/2 (q u^T + u q^T)/|u|),      |q| <= 1
/// is positive, pull over slide at first, when q = 0, and the Hessian in the end.
template <int Dim>
class Friction {
 public:
  /// Of the slide at which friction is whole [m/s].
  static constexpr double creep_speed = 1e-3;

  /// A step of length dt from these places of all markers begins; dt = 0: nothing slides.
  void begin(std::vector<Rub<Dim>> rubs, const Points<Dim>& all, double dt);
  /// Newton's method goes on from these places of all markers.
  void linearise(const Points<Dim>& all);
  /// What all pairs do at these places of all markers.
  std::vector<RubForce<Dim>> forces(const Points<Dim>& all) const;
  double dt() const { return dt_; }

 private:
  Point<Dim> slide(const Rub<Dim>& rub, const Points<Dim>& all) const;
  RubForce<Dim> force(const Rub<Dim>& rub, const Point<Dim>& direction, const Points<Dim>& all) const;

  std::vector<Rub<Dim>> rubs_;
  Points<Dim> directions_, slides_;  ///< q and u of each, where it was linearised last
  Points<Dim> starts_;
  double dt_ = 0;
};

extern template class Friction<2>;
extern template class Friction<3>;

}  // namespace washfsi
