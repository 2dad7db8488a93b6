// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/case.hpp"

#include <optional>

#include "washfsi/support/long_task.hpp"

namespace washfsi {

template <int Dim>
CaseOptions<Dim> CaseOptions<Dim>::from_options(Options& options, const Refinement& refinement) {
  CaseOptions<Dim> read;
  read.coupling = CouplingOptions::from_options(options);
  read.model = ModelOptions<Dim>::from_options(options, read.coupling.mass_carrier, refinement);
  read.initial_flow = InitialFlowOptions<Dim>::from_options(options);
  const auto placement = [&](const std::string& group) { return PlacementOptions<Dim>::from_options(options, group); };
  std::vector<std::string> groups;
  for (const ClothGroup<Dim>& group : read.model.cloths) {
    groups.push_back(group.name);
    read.placements.push_back(placement(group.name));
  }
  options.leave_out_dropped("cloths", groups, placement);
  const GridShape<Dim>& shape = read.model.grid.shape;
  read.measure = MeasureOptions::from_options<Dim>(options, shape.lower, shape.upper);
  return read;
}

template <int Dim>
std::unique_ptr<System<Dim>> start_system(MPI_Comm comm, const CaseOptions<Dim>& options,
                                          std::vector<Body<Dim>> bodies) {
  std::optional<LongTask> task(std::in_place, comm, "setting up the grid and its solvers");
  const auto place = [&](const Model<Dim>& model) {
    task.emplace(comm, "placing the cloths");
    return place_cloths<Dim>(model.cloths, options.placements, model.body_list, periods_of<Dim>(model.grid));
  };
  auto system = std::make_unique<System<Dim>>(comm, options.model, std::move(bodies), place);
  start_flow(options.initial_flow, system->model);
  return system;
}

template struct CaseOptions<2>;
template struct CaseOptions<3>;
template std::unique_ptr<System<2>> start_system<2>(MPI_Comm, const CaseOptions<2>&, std::vector<Body<2>>);
template std::unique_ptr<System<3>> start_system<3>(MPI_Comm, const CaseOptions<3>&, std::vector<Body<3>>);

}  // namespace washfsi
