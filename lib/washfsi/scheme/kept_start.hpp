// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/scheme/system.hpp"

namespace washfsi {

/// All that a step starts from, so that it can be taken again: what a checkpoint has of the system, in memory.
template <int Dim>
class KeptStart {
 public:
  /// Keeps where the system stands. Collective.
  explicit KeptStart(const System<Dim>& system);
  /// Puts it back there, after any number of steps. Collective.
  void restore(System<Dim>& system) const;

 private:
  void restore_fluid(Model<Dim>& model) const;

  std::vector<petsc::Vector> fields_;  ///< of the fluid
  double last_step_, step_before_last_;
  SolverCounts counts_;
  std::vector<double> driving_;
  std::vector<std::vector<double>> outflows_;
  bool knows_cover_;
  Points<Dim> wall_forces_, wall_pushes_;
  std::size_t push_count_ = 0;
  State<Dim> state_;
  // of the step before
  petsc::Vector force_;
  Points<Dim> pushed_at_, given_;
  double cloth_iterations_;
};

extern template class KeptStart<2>;
extern template class KeptStart<3>;

}  // namespace washfsi
