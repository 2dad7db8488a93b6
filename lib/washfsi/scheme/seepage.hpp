// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// Water that goes through permeable cloth. A marker with the normal n and the undeformed area A, which gives the water
/// the force f, moves relative to it by
///   V - J u = B f,     B = permeance/A n n^T
/// which is Darcy's law with the jump of pressure  n.f/A. The water is that of both sides: its volume is kept. The
/// power f.B f goes into heat within the cloth, never the other way. The normals are those of a step's start.
template <int Dim>
class Seepage {
 public:
  /// The cloths must outlive it.
  explicit Seepage(const Cloths<Dim>& cloths);

  /// Whether any cloth is permeable.
  bool present() const { return present_; }
  /// Before each step, from these places of this rank's markers. Collective.
  void begin_step(const Points<Dim>& positions);
  /// B f of this rank's markers, which give these forces to the water [m/s].
  Points<Dim> velocities(const Points<Dim>& forces) const;
  /// sum f.B f over all markers of all ranks [W; per unit depth in the plane]. Collective.
  double power(const Points<Dim>& forces) const;
  /// Adds factor times B to a mobility. Collective.
  void add_to(Mat mobility, double factor) const;

 private:
  const Cloths<Dim>& cloths_;
  bool present_ = false;
  std::vector<double> rates_;  ///< permeance over area of each of this rank's markers [m/(s N)]
  Points<Dim> normals_;
};

extern template class Seepage<2>;
extern template class Seepage<3>;

}  // namespace washfsi
