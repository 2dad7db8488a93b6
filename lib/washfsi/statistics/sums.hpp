// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "washfsi/grid/boundary.hpp"

namespace washfsi {

/// Velocity and pressure of a moment: local vectors of face_dm and a global one of cell_dm.
struct FlowMoment {
  Vec velocity = nullptr;  ///< its ghosts filled [m/s]
  Vec pressure = nullptr;  ///< [Pa]
};

/// The box without its homogeneous axes: the remaining cells are the bins over which means are taken.
template <int Dim>
class Bins {
 public:
  /// Errors: InputError if an axis is none, or not periodic, or none is periodic.
  Bins(const Grid<Dim>& grid, const std::vector<std::string>& homogeneous);

  bool is_homogeneous(int axis) const { return homogeneous_[static_cast<std::size_t>(axis)]; }
  /// The remaining axes, x first.
  const std::vector<int>& axes() const { return axes_; }
  std::size_t count() const { return count_; }
  double cells_per_bin() const { return cells_per_bin_; }
  /// The bin of a cell, x fastest.
  std::size_t of(const Index<Dim>& cell) const;

 private:
  const Grid<Dim>& grid_;
  std::array<bool, Dim> homogeneous_{};
  std::vector<int> axes_;
  std::size_t count_ = 1;
  double cells_per_bin_ = 1;
};

/// Names of the quantities summed in each bin, in their order: u, v [, w], then p, then the products uu, vv, ... pp.
template <int Dim>
std::vector<std::string> moment_names();

/// Means over each bin of the quantities of `moment_names`, at the cells' centres, to which velocity is interpolated;
/// bin by bin. The same on all ranks. Collective.
template <int Dim>
std::vector<double> bin_means(const Grid<Dim>& grid, const Bins<Dim>& bins, const FlowMoment& flow);

extern template class Bins<2>;
extern template class Bins<3>;

}  // namespace washfsi
