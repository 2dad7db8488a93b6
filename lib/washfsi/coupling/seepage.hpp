// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/coupling/cloth_wall_model.hpp"
#include "washfsi/coupling/films.hpp"
#include "washfsi/coupling/step_mobility.hpp"

namespace washfsi {

/// Water that flows through permeable cloth. A marker with the undeformed area A, which gives the water the force F_f,
/// moves relative to it by
///   V - J u = B F_f,     B = permeance/A
/// Across the cloth this is Darcy's law with the pressure jump n.F_f/A. Along it the same slip is allowed. No slip acts
/// on the mean of both sides, so water that arrives obliquely would otherwise leave with the opposite velocity along
/// the cloth. Water that leaves one side enters the other: its volume is conserved. The power F_f.B F_f is dissipated
/// within the cloth. If requested, B includes the films between cloths, and the layers along cloth with a wall model,
/// whose slip of the last step goes on in part.
template <int Dim>
class Seepage {
 public:
  /// The model must outlive it. Collective.
  explicit Seepage(const Model<Dim>& model);

  /// Whether any cloth is permeable, films drain, or cloth has a wall model.
  bool present() const { return present_; }
  /// Call it before each step of length dt [s], with the state and the forces that this rank's markers give to the
  /// water at its start. Collective.
  void begin_step(const State<Dim>& state, const Points<Dim>& forces, double dt);
  /// Ends the step: keeps the slips along cloth. Call it with the forces of the step.
  void finish_step(const Points<Dim>& forces, State<Dim>& state) const;
  /// B F_f, and the slip that goes on, for this rank's markers, which give these forces F_f to the water [m/s].
  /// Collective.
  Points<Dim> velocities(const Points<Dim>& forces) const;
  /// The power of these forces at these velocities, over all markers of all ranks [W; per unit depth in 2D].
  /// Collective.
  double power(const Points<Dim>& forces) const;
  /// Adds factor times B to a mobility. Collective.
  void add_to(StepMobility<Dim>& mobility, double factor) const;

 private:
  std::vector<Block<Dim>> own_blocks(double factor) const;

  const Cloths<Dim>& cloths_;
  std::optional<Films<Dim>> films_;
  std::optional<ClothWallModel<Dim>> layers_;
  bool present_ = false;
  std::vector<double> rates_;  ///< permeance over area A of each of this rank's markers [m/(s N)]
};

extern template class Seepage<2>;
extern template class Seepage<3>;

}  // namespace washfsi
