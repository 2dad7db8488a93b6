// SPDX-License-Identifier: BSD-3-Clause
//
// Direct forcing by markers on the bodies' surfaces: forces F that act through the delta hold the water at the markers
// at the bodies' velocity U, and are solved for together with the pressure,
//   J u = U,   div u = 0,   u = P [u* + dt S F / rho],
// P the projection. S and J are adjoint, so that J P S is symmetric: conjugate residuals, PETSc prefix walls_,
// preconditioned by the inverse overlap of the deltas, since the slip is to be least; conjugate gradients would go far
// along what the water hardly answers. What is held is the mean slip over the reach of a delta; what
// changes from patch to patch no force of theirs can move, and it goes to no purpose. Uhlmann, J. Comput. Phys. 209
// (2005) 448; Taira and Colonius, J. Comput. Phys. 225 (2007) 2118. A step begins with the forces of the step before,
// which turn with their body.
#pragma once

#include <optional>

#include "washfsi/body/mask.hpp"
#include "washfsi/body/wall_loads.hpp"
#include "washfsi/coupling/transfer.hpp"
#include "washfsi/fluid/wall_forces.hpp"
#include "washfsi/forcing/body_markers.hpp"
#include "washfsi/forcing/body_wall_law.hpp"
#include "washfsi/forcing/closed_walls.hpp"
#include "washfsi/forcing/known_pushes.hpp"
#include "washfsi/forcing/overlap_inverse.hpp"

namespace washfsi {

template <int Dim>
class SurfaceForcing : public WallForces {
 public:
  /// Collective. `density` [kg/m3] is the water's.
  SurfaceForcing(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
                 const BodyTreatment& treatment, double density);

  /// Places the markers as the bodies are at `time`. Collective.
  void update(double time);

  /// From the next trial on lets the water slide along the surfaces where a law has its friction, which acts instead.
  /// The law is that of these markers and stays alive.
  void let_slide(const BodyWallLaw<Dim>& law);

  /// On faces: from 1 beside edges and thin parts to 0 beyond the reach of their forces; null if there are none, or
  /// nothing asks for it. Valid until they move.
  Vec nearness() const { return nearness_; }
  /// The same where central advection is to give way; else null.
  Vec limits_advection() const { return limits_advection_ ? static_cast<Vec>(nearness_) : nullptr; }
  void begin_trial(const TimeStep& step, Vec density) override;
  void add_held(Vec force) override;
  void push(Vec velocity, double relaxation) override;
  bool push_unheld(Vec velocity, double relaxation) override;
  bool hold(const Project& project, Vec velocity) override;
  void accept() override;

  /// What the water does to the markers of each body, about its centre: -F, but for what sides of the box that the
  /// bodies stand on took of it; and its friction by the law. Collective.
  Loads<Dim> loads() const;
  /// What these sides of the box took of the markers' forces where no body stands on them; torques about the middle of
  /// the box. Collective.
  Loads<Dim> loads_on_sides(const std::vector<SideName>& sides) const;
  /// J u at this rank's markers, wherever the bodies were then; `time` is that of the velocity. Collective.
  Points<Dim> water_at_markers(Vec velocity, double time) const;
  /// Power that the bodies gave over the last step of dt and the water did not get, because it had other velocities at
  /// the markers, `before` and `after` it, than they: F (U(t + dt/2) - J (u^n + u^(n+1))/2) [W; W/m in the plane].
  /// Collective.
  double lost_power(const Points<Dim>& before, const Points<Dim>& after, double dt) const;
  /// The slip of the water at each body's markers, root mean square [m/s]; without that with which a law lets it slide.
  /// The solver holds means over the reach of a delta, which are less. Collective.
  std::vector<double> slip_of_bodies(const Points<Dim>& water) const;

  /// What a restart needs: the forces of this rank's patches, in the bodies' frames, and which patches these are; and
  /// what the last pushes did.
  Points<Dim>& kept() { return kept_; }
  const Points<Dim>& kept() const { return kept_; }
  KnownPushes<Dim>& known_pushes() { return known_pushes_; }
  const KnownPushes<Dim>& known_pushes() const { return known_pushes_; }
  PatchRange own() const { return markers_.own(); }
  std::size_t markers_of(std::size_t body) const { return markers_.of_body(body).markers.size(); }
  const BodyMarkers<Dim>& markers() const { return markers_; }
  std::size_t patch_count() const { return markers_.patches(); }

 private:
  static PetscErrorCode multiply(Mat matrix, Vec x, Vec y);
  static PetscErrorCode precondition(PC pc, Vec x, Vec y);
  static PetscErrorCode judge(KSP solver, PetscInt iteration, PetscReal norm, KSPConvergedReason* reason, void* self);
  Point<Dim> held(const Point<Dim>& value, std::size_t patch) const;
  /// Calls visit(patch, marker) for all markers that act, both counted from this rank's first.
  template <class Visit>
  void for_each_acting(Visit&& visit) const;
  Points<Dim> kept_by_sides(const std::optional<SideName>& open = {}) const;
  void create_solver();
  std::size_t begin() const { return own().begin; }
  std::size_t owned() const { return own().size(); }
  Points<Dim> turned(const Points<Dim>& values, bool into_space) const;
  Points<Dim> shared_out(const Points<Dim>& of_patches) const;
  Points<Dim> means(const Points<Dim>& of_markers) const;
  Points<Dim> felt_means(const Points<Dim>& of_markers) const;
  Points<Dim> slips(Vec velocity) const;
  Points<Dim> response(const Points<Dim>& forces) const;
  /// Those that move the patches by so much, about.
  Points<Dim> approximate_forces(const Points<Dim>& velocities) const;
  Points<Dim> without(const std::vector<bool>& bodies, Points<Dim> values) const;
  void accelerate(const Points<Dim>& forces, Vec velocity) const;
  void add_forces(const Points<Dim>& more, Vec velocity);
  Points<Dim> push_against(const Points<Dim>& slips, double relaxation) const;
  void learn_from_last_push(const Points<Dim>& slips_after);
  /// Of each body whether what deltas see of the slips of its patches is at most so much, rms [m/s].
  std::vector<bool> are_held(const Points<Dim>& slips, double most) const;
  double tolerance(Vec velocity) const;

  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  const std::vector<Body<Dim>>& bodies_;
  double slip_tolerance_, density_;
  Transfer<Dim> transfer_;
  BodyMarkers<Dim> markers_;
  ClosedWalls<Dim> closed_;
  OverlapInverse<Dim> overlap_;
  KnownPushes<Dim> known_pushes_;
  /// The last, before its answer is known.
  struct Pushed {
    Points<Dim> forces, slips;
  };
  std::optional<Pushed> pushed_;
  std::vector<typename BodyMarkers<Dim>::State> states_;  ///< of the markers of this rank's patches
  std::vector<double> shares_;                            ///< of each marker in its patch; 0 of patches that do not act
  Points<Dim> forces_;                                    ///< F of each patch [N; per unit depth in the plane]
  Points<Dim> kept_;                                      ///< F of the step before, in the bodies' frames
  Points<Dim> slide_normals_, normals_;                   ///< of this rank's patches: in their bodies' frames; in space
  const BodyWallLaw<Dim>* law_ = nullptr;                 ///< by which the water slides
  double time_ = 0;                                       ///< of `update`
  bool limits_advection_;                                 ///< beside edges and thin parts
  petsc::Vector nearness_;                                ///< of faces; null where `nearness` is
  petsc::Matrix matrix_;
  petsc::Solver solver_;
  petsc::Vector right_, solution_;
  TimeStep step_;                     ///< under way
  Vec fluid_density_ = nullptr;       ///< of it
  const Project* project_ = nullptr;  ///< while the solver runs, and how much slip it may leave [m/s]
  double slip_left_ = 0;
  /// J u of what was asked for last, where the markers are.
  struct Seen {
    petsc::Version velocity;
    double time;
    Points<Dim> water;
  };
  mutable std::optional<Seen> seen_;
};

template <int Dim>
template <class Visit>
void SurfaceForcing<Dim>::for_each_acting(Visit&& visit) const {
  const std::size_t first = markers_.start(begin());
  for (std::size_t p = begin(); p < own().end; ++p)
    for (std::size_t m = markers_.start(p) - first; m < markers_.start(p + 1) - first; ++m)
      if (states_[m].acts) visit(p - begin(), m);
}

extern template class SurfaceForcing<2>;
extern template class SurfaceForcing<3>;

}  // namespace washfsi
