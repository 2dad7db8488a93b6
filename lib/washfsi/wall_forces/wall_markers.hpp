// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/grid/boundary.hpp"
#include "washfsi/immersed_boundary/transfer.hpp"
#include "washfsi/marker_layout/body_markers.hpp"
#include "washfsi/support/clock.hpp"
#include "washfsi/wall_forces/patch_sliding.hpp"

namespace washfsi {

/// The markers on the walls of all bodies at one time, and the transfer between them, their patches and the grid: S
/// spreads forces of patches to faces, its adjoint J interpolates velocities to patches. All values are of this rank.
template <int Dim>
class WallMarkers {
 public:
  using State = typename BodyMarkers<Dim>::State;

  /// `finds_edges`: whether `nearness` is needed. Collective.
  WallMarkers(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
              const BodyTreatment& treatment, bool finds_edges);

  /// Places the markers as the bodies are at `time`. Collective.
  void place(double time);
  /// How the water slides along the patches.
  PatchSliding<Dim>& sliding() { return sliding_; }
  const PatchSliding<Dim>& sliding() const { return sliding_; }

  const Grid<Dim>& grid() const { return grid_; }
  const BodyMarkers<Dim>& layout() const { return layout_; }
  const Boundary<Dim>& boundary() const { return boundary_; }
  const Transfer<Dim>& transfer() const { return transfer_; }
  const std::vector<State>& states() const { return states_; }  ///< states of the markers
  double time() const { return time_; }                         ///< time of the last `place` [s]
  std::size_t body_of(std::size_t patch) const { return layout_.body_of(layout_.own().begin + patch); }
  bool acts(std::size_t patch) const { return shares_[patch] > 0; }

  /// Turns vectors of patches from the frames of their bodies into space, or back.
  Points<Dim> turned(const Points<Dim>& values, bool into_space) const;
  /// Distributes forces of patches over their acting markers.
  Points<Dim> marker_forces(const Points<Dim>& of_patches) const;
  /// Means over the acting markers of each patch: the adjoint of `marker_forces`.
  Points<Dim> means(const Points<Dim>& of_markers) const;
  /// force += S F. Collective.
  void spread(const Points<Dim>& of_patches, Vec force) const { transfer_.spread(marker_forces(of_patches), force); }
  /// J u at the markers as they were placed last; `time` is that of the velocity. Collective.
  Points<Dim> water_velocities(Vec velocity, double time) const;

  /// Calls visit(patch, marker) for all acting markers, both counted from this rank's first.
  template <class Visit>
  void for_each_acting(Visit&& visit) const;

  /// Nearness on faces: from 1 beside edges and thin parts to 0 beyond the reach of their forces; null if there are
  /// none or it is not needed. Valid until the next `place`.
  Vec nearness() const { return nearness_; }

 private:
  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  const std::vector<Body<Dim>>& bodies_;
  Transfer<Dim> transfer_;
  BodyMarkers<Dim> layout_;
  std::vector<State> states_;
  /// For each patch: 1/(number of its markers), the share that each acting marker takes; 0 if none acts.
  std::vector<double> shares_;
  PatchSliding<Dim> sliding_;
  petsc::Vector nearness_;
  double time_ = 0;
  /// The last result of `water_velocities` at the present places of the markers.
  struct Interpolated {
    petsc::Version velocity;
    double time;
    Points<Dim> values;
  };
  mutable std::optional<Interpolated> interpolated_;
};

/// The layout of markers on walls, with a narrow kernel that is smooth for bodies moving over the grid.
template <int Dim>
MarkerLayout<Dim> wall_marker_layout(const Grid<Dim>& grid, const BodyTreatment& treatment);

template <int Dim>
template <class Visit>
void WallMarkers<Dim>::for_each_acting(Visit&& visit) const {
  const std::size_t begin = layout_.own().begin, first = layout_.start(begin);
  for (std::size_t p = begin; p < layout_.own().end; ++p)
    for (std::size_t m = layout_.start(p) - first; m < layout_.start(p + 1) - first; ++m)
      if (states_[m].acts) visit(p - begin, m);
}

extern template class WallMarkers<2>;
extern template class WallMarkers<3>;

}  // namespace washfsi
