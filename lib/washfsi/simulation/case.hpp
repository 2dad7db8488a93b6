// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/coupling_scheme.hpp"
#include "washfsi/measure/measures.hpp"
#include "washfsi/placement/placement.hpp"
#include "washfsi/simulation/initial_flow.hpp"

namespace washfsi {

/// The options of a case: model, initial state, coupling and measures.
template <int Dim>
struct CaseOptions {
  ModelOptions<Dim> model;
  std::vector<PlacementOptions<Dim>> placements;  ///< placement of each group of cloths
  InitialFlowOptions<Dim> initial_flow;
  CouplingOptions coupling;
  MeasureOptions measure;

  static CaseOptions from_options(Options& options, const Refinement& refinement = {});
};

/// Creates the system of a case at t = 0. Collective. Errors: InputError.
template <int Dim>
std::unique_ptr<System<Dim>> start_system(MPI_Comm comm, const CaseOptions<Dim>& options,
                                          std::vector<Body<Dim>> bodies);

}  // namespace washfsi
