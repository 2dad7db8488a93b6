// SPDX-License-Identifier: BSD-3-Clause
//
// The boundary layers along cloth, which the kernels smooth out. Without a model a sheet drags along itself the water
// that its kernels reach, some two cells of it on each side. With the wall model a marker of the area A, with the unit
// normal n, slides along itself through the water that its kernels interpolate, with the velocity s:
//   V - J u = s,    m_w ds/dt + G (s + T ds/dt) = P F_f/A,    P = 1 - n n^T,    n.s = 0
// F_f is the force that it gives to the water, m_w the mass of the water that the fabric holds [kg/m2], and the
// friction G, on both sides together, is
//   G = 1/E P + sum over edges k b b^T
// E is the ease of the two layers between the sheet and the water at the distance y (`KernelMoments::sheet_reach`).
// |s| is the speed of the cloth relative to the water at the distance y, the same on both sides, and nu = mu/rho:
//   layers that y lies within    E = |s|/(2 rho u_tau^2)  with |s| = u_tau u+(y u_tau/nu)  by Reichardt's law; for
//                                small y+ this is y/(2 mu), the exact correction of a profile that is bent at the sheet
//   layers thinner than y        E = |s|/(2 . 0.664 rho |s|^2/sqrt(Re)), Re = |s| L/nu: Blasius' mean friction of a
//                                plate of the length L; the lesser E holds
// T is the time of diffusion over y where the layer is laminar:
//   T = pi/4 y^2/nu exp(-(y+/5)^2)
// The flow round the edge of a sheet across a stream separates, which takes a force along the sheet at the edge. With
// the mean pressure p on the cloth, |sum n.F_f|/sum A, and the direction b out of the cloth,
//   k = 5 p^2/(p + rho |s|^2)/(|s| + 0.01 sqrt(p/rho))
// holds the edge by at most five times the pressure where p is of the order of rho |s|^2, and lets it slide where the
// stream goes along the sheet. Forces of single markers, where a stiff lattice rings, would make the edges ring.
// s is implicit in a step (backward Euler), while E and k are taken from the mean of s^n and s^(n-1), so that they do
// not jump where s alternates, and from the force of the last step:
//   s^(n+1) = B F_f + r,    A B = (G (1 + T/dt) + m_w/dt)^-1 P,    r = A B (T G + m_w)/dt s^n
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/immersed_boundary/kernel_moments.hpp"

namespace washfsi {

/// E and T of the layers beside one marker.
struct ClothLayer {
  double ease = 0;    ///< E [m/(s Pa)]
  double memory = 0;  ///< T [s]
  double y_plus = 0;  ///< y u_tau/nu
};
/// The layers for y [m], |s| [m/s] and L [m].
ClothLayer cloth_layer(const PureLiquid& liquid, double distance, double speed, double length);
/// k [Pa s/m] for |s| [m/s] and p [Pa].
double edge_friction(double density, double speed, double pressure);

template <int Dim>
class ClothWallModel {
 public:
  /// The model must outlive it.
  explicit ClothWallModel(const Model<Dim>& model);

  /// Finds the layers for a step of length dt [s] from this state. Collective.
  void begin_step(const State<Dim>& state, double dt);
  /// B of each of this rank's markers [m/(s N)].
  const std::vector<Block<Dim>>& eases() const { return eases_; }
  /// s^(n+1) of this rank's markers, which give these forces to the water [m/s].
  Points<Dim> slips(const Points<Dim>& forces) const;

 private:
  std::vector<double> mean_pressures(const Points<Dim>& normals, const Points<Dim>& forces) const;
  double length_of(std::size_t marker) const;

  const Model<Dim>& model_;
  KernelMoments kernel_;
  std::vector<Block<Dim>> eases_;
  Points<Dim> rests_;  ///< r [m/s]
};

extern template class ClothWallModel<2>;
extern template class ClothWallModel<3>;

}  // namespace washfsi
