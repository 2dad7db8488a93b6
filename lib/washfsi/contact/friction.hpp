// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/cloth/sheet.hpp"

namespace washfsi {

/// A friction pair: two surfaces that touch in a step, with place and normal force of its start.
template <int Dim>
struct FrictionPair {
  Point<Dim> normal;   ///< n, from the second to the first
  double limit;        ///< mu_C F_n [N; per unit depth in 2D]
  double stops = 0;    ///< slide below which the whole limit would more than stop them, in an explicit step [m]
  double damping = 0;  ///< damping of the normal motion [N s/m]
};

/// The damping 2 zeta sqrt(K_n m) of two surfaces along their normal [N s/m]: the share zeta of the critical damping of
/// a mass m [kg] on a spring, whose stiffness K_n is that of the contact at the start of the step [N/m].
double contact_damping(double share, double stiffness, double mass);

/// The action of a pair when the first surface has moved some way over the second.
template <int Dim>
struct FrictionForce {
  double energy = 0;              ///< energy of the potential [J]
  double work = 0;                ///< energy dissipated in the step: pull by its share times way [J]
  Point<Dim> pull;                ///< force on the second surface; minus this on the first [N]
  StiffnessBlock<Dim> stiffness;  ///< stiffness for Newton's method [N/m]
};

/// Coulomb friction in a step, lagged (Li et al., ACM Trans. Graph. 39 (2020) 49): normal n and normal force F_n are
/// those of the start of the step. With the slide xi = (I - n n^T) way, the way being that of the first surface over
/// the second, a pair pulls with
///   mu_C F_n eta(|xi|/xi_0) xi/|xi|,      eta(y) = (2 - y) y for y < 1, else 1,      xi_0 = dt times `creep_speed`
/// the gradient of a convex energy. Below that speed surfaces stick except for a creep.
/// Newton's method with the Hessian oscillates across the kink at rest, and with pull over slide in place of it
/// converges slowly where pairs are about to slide. So the direction xi^ of the pull is a separate unknown, with
///   Xi xi^ = xi,      Xi = |xi|/eta      (Chan, Golub and Mulet, SIAM J. Sci. Comput. 20 (1999) 1964)
/// With xi eliminated, the stiffness
///   mu_C F_n/Xi (I - n n^T - Xi'/2 (xi^ xi^T + xi xi^^T)/|xi|),      |xi^| <= 1
/// is positive: pull over slide at first, when xi^ = 0, and the Hessian in the end.
/// Friction is that of the step as a whole. Where forces at its end make up the share w_0 of its mean force, and those
/// at its start, when nothing has slid yet, the rest, the pull is mu_C F_n/w_0 in place of mu_C F_n.
/// The motion along the normal is damped: a barrier would make surfaces bounce, and cloth does not.
/// `contact_damping` gives the coefficient. In an explicit step of length dt the way is that of the velocities at its
/// start, and xi_0 is at least `stops`, so that the pull does not reverse the slide.
template <int Dim>
class Friction {
 public:
  /// The sliding speed xi_0/dt at which friction reaches its limit mu_C F_n [m/s].
  static constexpr double creep_speed = 1e-3;

  /// Begins a step of length dt; dt = 0: nothing slides. `share` is w_0, that of the pulls in the step's mean force.
  void begin(std::vector<FrictionPair<Dim>> pairs, double dt, double share = 1);
  /// Linearises for Newton's method at these ways of all pairs [m].
  void linearise(const Points<Dim>& ways);
  /// The action of each pair after these ways of all.
  std::vector<FrictionForce<Dim>> forces(const Points<Dim>& ways) const;
  double dt() const { return dt_; }

 private:
  FrictionForce<Dim> force(const FrictionPair<Dim>& pair, const Point<Dim>& direction, const Point<Dim>& way) const;
  void add_damping(const FrictionPair<Dim>& pair, const Point<Dim>& way, FrictionForce<Dim>& force) const;

  std::vector<FrictionPair<Dim>> pairs_;
  Points<Dim> directions_, slides_;  ///< xi^ and xi of each pair, where it was linearised last
  double dt_ = 0, share_ = 1;
};

extern template class Friction<2>;
extern template class Friction<3>;

}  // namespace washfsi
