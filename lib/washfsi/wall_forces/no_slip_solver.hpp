// SPDX-License-Identifier: BSD-3-Clause
//
// No slip as equations for the forces F of patches of markers, which are solved for together with the pressure:
//   J P [u + (dt/rho) S F] = U_solid
// with U_solid the velocity of the bodies at the markers, P the projection, S spreading and J interpolation, its
// adjoint. J P S is symmetric, and the slip is minimised by generalised conjugate residuals (PETSc prefix walls_),
// preconditioned by the inverse overlap of the kernels. Conjugate gradients would find huge forces in nearly null
// directions, to which the water hardly responds.
// Uhlmann, J. Comput. Phys. 209 (2005) 448; Taira and Colonius, J. Comput. Phys. 225 (2007) 2118.
#pragma once

#include <exception>

#include "washfsi/fluid/projection.hpp"
#include "washfsi/support/vector_range.hpp"
#include "washfsi/wall_forces/closed_walls.hpp"
#include "washfsi/wall_forces/overlap_inverse.hpp"
#include "washfsi/wall_forces/wall_markers.hpp"

namespace washfsi {

template <int Dim>
class NoSlipSolver {
 public:
  /// The markers stay alive. Collective.
  NoSlipSolver(const WallMarkers<Dim>& markers, const BodyTreatment& treatment);

  /// Call it after the markers have been placed. Collective.
  void place();
  /// Begins a step with this density on faces [kg/m3], which stays alive. Collective.
  void begin(const TimeStep& step, Vec density);

  /// The mean slip U_solid - J u over each patch, without the part that no force can change. Collective.
  Points<Dim> slips(Vec velocity) const;
  /// Estimates the forces that change the slips by these values; neglects the pressure. Collective.
  Points<Dim> approximate_forces(const Points<Dim>& slips) const;
  /// u += (dt/rho) S F. Collective.
  void accelerate(const Points<Dim>& forces, Vec velocity) const;

  /// The slip that may remain [m/s]: a share of the largest speed of water and walls. Collective.
  double tolerance(Vec velocity) const;
  /// Whether the rms of each body's filtered slips is at most `tolerance` [m/s]. Slips are filtered over the reach of a
  /// kernel, since no force can change what alternates from patch to patch. Collective.
  std::vector<bool> are_within(const Points<Dim>& slips, double tolerance) const;
  /// Returns forces that reduce the slip to the tolerance. Collective. Errors: DivergedError.
  Points<Dim> solve(const Points<Dim>& slips, double tolerance, Projection& projection);

 private:
  /// A solution of the equations.
  struct Solving {
    Projection* projection = nullptr;
    double slip_left = 0;        ///< rms slip at which the solver stops [m/s]
    std::exception_ptr failure;  ///< what has diverged within the solver; PETSc cannot pass it on
  };
  const Grid<Dim>& grid() const { return markers_.grid(); }
  static PetscErrorCode multiply(Mat matrix, Vec x, Vec y);
  static PetscErrorCode precondition(PC pc, Vec x, Vec y);
  template <class Product>
  PetscErrorCode put_product(Vec x, Vec y, const Product& product);
  static PetscErrorCode judge(KSP solver, PetscInt iteration, PetscReal norm, KSPConvergedReason* reason, void* self);
  void create_solver();
  Points<Dim> response(const Points<Dim>& forces) const;
  Points<Dim> interpolated(Vec increment) const;
  void find_local_densities();
  Points<Dim> without_unreachable(const Points<Dim>& of_markers) const;

  const WallMarkers<Dim>& markers_;
  double slip_tolerance_;
  ClosedWalls<Dim> closed_;
  OverlapInverse<Dim> overlap_;
  petsc::Matrix matrix_;
  petsc::Solver solver_;
  petsc::Vector right_, solution_;
  TimeStep step_;                   ///< current step
  Vec density_ = nullptr;           ///< density on faces in the current step [kg/m3]
  petsc::Version density_version_;  ///< version of the density that was seen last
  VectorRange densities_;           ///< its range [kg/m3]
  Points<Dim> local_densities_;     ///< that of each patch, for forces along each axis [kg/m3]
  Solving solving_;                 ///< the present or last `solve`
};

extern template class NoSlipSolver<2>;
extern template class NoSlipSolver<3>;

}  // namespace washfsi
