// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/checkpoint.hpp"

#include <algorithm>
#include <filesystem>

#include "washfsi/output/field_slab.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

void write_vector(Hdf5File& file, const std::string& name, const Slab& slab, Vec vector) {
  const double* values = nullptr;
  PetscInt size = 0;
  WASH_PETSC(VecGetLocalSize(vector, &size));
  WASH_PETSC(VecGetArrayRead(vector, &values));
  const std::vector<double> copy(values, values + size);
  WASH_PETSC(VecRestoreArrayRead(vector, &values));
  file.write(name, slab, copy);
}

void read_vector(Hdf5File& file, const std::string& name, const Slab& slab, Vec vector) {
  const std::vector<double> copy = file.read(name, slab);
  double* values = nullptr;
  WASH_PETSC(VecGetArray(vector, &values));
  std::copy(copy.begin(), copy.end(), values);
  WASH_PETSC(VecRestoreArray(vector, &values));
}

template <int Dim>
Slab slab_of_markers(const Cloths<Dim>& cloths, int components) {
  return marker_slab(cloths.marker_count(), cloths.begin(), cloths.end(), components);
}

// The integrals over time of the quantities of each marker.
template <int Dim>
Slab slab_of_integrals(const Cloths<Dim>& cloths) {
  return slab_of_markers(cloths, static_cast<int>(marker_quantities<Dim>().size()));
}

template <int Dim>
Points<Dim> read_points(Hdf5File& file, const std::string& name, const Cloths<Dim>& cloths) {
  const std::vector<double> flat = file.read(name, slab_of_markers(cloths, Dim));
  Points<Dim> points(cloths.owned());
  for (std::size_t m = 0; m < points.size(); ++m) points[m] = Point<Dim>(&flat[m * Dim]);
  return points;
}

// The values that open sides hold, one plane each.
template <int Dim>
std::string dataset_of(const OutflowLayer<Dim>& layer) {
  return std::string("/outflow/") + "xyz"[layer.axis()] + (layer.end() == End::lower ? "_lower" : "_upper");
}

template <int Dim>
void write_outflow(Hdf5File& file, const System<Dim>& system) {
  for (const auto& layer : system.model.boundary.outflows())
    file.write(dataset_of(layer), box_slab<Dim>(layer.all_cells(), layer.owned_cells(), Dim), layer.values());
}

template <int Dim>
void read_outflow(Hdf5File& file, System<Dim>& system) {
  for (auto& layer : system.model.boundary.outflows())
    layer.set_values(file.read(dataset_of(layer), box_slab<Dim>(layer.all_cells(), layer.all_cells(), Dim)));
}

// What a checkpoint must share with the run that goes on from it: the box, and every cloth's markers and spacings.
template <int Dim>
std::vector<double> identity(const System<Dim>& system) {
  std::vector<double> numbers;
  for (int d = 0; d < Dim; ++d) numbers.push_back(system.model.grid.lower()[d]);
  for (int d = 0; d < Dim; ++d) numbers.push_back(system.model.grid.upper()[d]);
  for (const Piece& piece : system.model.cloths.pieces()) {
    const Sheet& sheet = system.model.cloths.groups()[piece.group].sheet;
    numbers.insert(numbers.end(),
                   {static_cast<double>(piece.count), static_cast<double>(sheet.width), sheet.ds, sheet.dr});
  }
  return numbers;
}

// What some coupling schemes need of the step before.
template <class SomeState>
auto motion_before(SomeState& state) {
  return std::array{std::pair{std::string("velocity_before"), &state.velocities_before},
                    std::pair{std::string("mean_velocity"), &state.mean_velocities},
                    std::pair{std::string("force_before"), &state.forces_before}};
}

// A short array that all ranks hold; rank 0 writes it.
Slab shared_slab(MPI_Comm comm, std::size_t size, bool writing) {
  const bool silent = writing && rank_of(comm) != 0;
  return {{size}, {0}, {silent ? hsize_t{0} : size}};
}

}  // namespace

template <int Dim>
void write_checkpoint(const std::string& folder, const System<Dim>& system, Measures<Dim>& measures,
                      const RunState& state) {
  const petsc::LogPart part("output");
  const std::string path = folder + "/checkpoint.h5", temporary = path + ".part";
  const MPI_Comm comm = system.model.grid.comm();
  Hdf5File file(comm, temporary, Hdf5File::Mode::create);
  file.set_attribute("/", "step", static_cast<double>(system.state.clock.step));
  file.set_attribute("/", "time", system.state.clock.time);
  file.set_attribute("/", "time_step", state.dt);
  file.set_attribute("/", "cloth_bound", state.cloth_bound);
  file.set_attribute("/", "steps_at_rest", state.steps_at_rest);
  file.set_attribute("/", "last_step", system.model.fluid.last_step());
  const SolverCounts& counts = system.model.fluid.counts();
  file.set_attribute("/", "momentum_iterations", counts.momentum);
  file.set_attribute("/", "pressure_iterations", counts.pressure);
  file.set_attribute("/", "cloth_iterations", system.step.cloth_iterations);
  for (const auto& [name, vector] : system.model.fluid.face_state())
    write_vector(file, "/fluid/" + name, field_slab(system.model.grid, Dim), vector);
  for (const auto& [name, vector] : system.model.fluid.cell_state())
    write_vector(file, "/fluid/" + name, field_slab(system.model.grid, 1), vector);
  write_outflow(file, system);
  if (system.model.cloths.marker_count() > 0) {
    file.write("/cloth/position", slab_of_markers(system.model.cloths, Dim), flattened<Dim>(system.state.positions));
    file.write("/cloth/velocity", slab_of_markers(system.model.cloths, Dim), flattened<Dim>(system.state.velocities));
    for (const auto& [name, values] : motion_before(system.state))
      file.write("/cloth/" + name, slab_of_markers(system.model.cloths, Dim), flattened<Dim>(*values));
    file.write("/cloth/time_integrals", slab_of_integrals(system.model.cloths), measures.cloth().time_integrals());
  }
  const std::vector<double> numbers = identity(system);
  file.write("/identity", shared_slab(comm, numbers.size(), true), numbers);
  for (const auto& [name, kept] : measures.quantities().kept())
    file.write("/totals/" + name, shared_slab(comm, kept.size(), true), std::vector<double>(kept.begin(), kept.end()));
  file.close();
  bool renamed = true;
  if (rank_of(comm) == 0) {
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    renamed = !error;
  }
  if (any_rank(comm, !renamed)) throw FileError(path + ": cannot be written");
}

template <int Dim>
RunState read_checkpoint(const std::string& path, System<Dim>& system, Measures<Dim>& measures) {
  const MPI_Comm comm = system.model.grid.comm();
  try {
    Hdf5File file(comm, path, Hdf5File::Mode::read);
    const std::vector<double> numbers = identity(system);
    if (file.read("/identity", shared_slab(comm, numbers.size(), false)) != numbers)
      throw InputError(path + ": the box or the cloths' markers are others");
    for (const auto& [name, vector] : system.model.fluid.face_state())
      read_vector(file, "/fluid/" + name, field_slab(system.model.grid, Dim), vector);
    for (const auto& [name, vector] : system.model.fluid.cell_state())
      read_vector(file, "/fluid/" + name, field_slab(system.model.grid, 1), vector);
    read_outflow(file, system);
    if (system.model.cloths.marker_count() > 0) {
      system.state.positions = read_points(file, "/cloth/position", system.model.cloths);
      system.state.velocities = read_points(file, "/cloth/velocity", system.model.cloths);
      for (const auto& [name, values] : motion_before(system.state))
        *values = read_points(file, "/cloth/" + name, system.model.cloths);
      measures.cloth().time_integrals() = file.read("/cloth/time_integrals", slab_of_integrals(system.model.cloths));
    }
    for (const auto& [name, kept] : measures.quantities().kept())
      std::ranges::copy(file.read("/totals/" + name, shared_slab(comm, kept.size(), false)), kept.begin());
    system.model.locate_cloth(system.state.positions);
    system.state.clock = {file.attribute("/", "time"), static_cast<long>(file.attribute("/", "step"))};
    system.model.boundary.set_outflow_time(system.state.clock.time);
    system.model.mask.update(system.state.clock.time);
    system.model.fluid.set_last_step(file.attribute("/", "last_step"));
    system.step.cloth_iterations = file.attribute("/", "cloth_iterations");
    system.model.fluid.set_counts({.momentum = file.attribute("/", "momentum_iterations"),
                                   .pressure = file.attribute("/", "pressure_iterations")});
    return {file.attribute("/", "time_step"), file.attribute("/", "cloth_bound"),
            static_cast<int>(file.attribute("/", "steps_at_rest"))};
  } catch (const InputError& error) {
    throw InputError(std::string("-restart ") + error.what() +
                     "; it must be a checkpoint of this grid and these cloths");
  }
}

template void write_checkpoint<2>(const std::string&, const System<2>&, Measures<2>&, const RunState&);
template void write_checkpoint<3>(const std::string&, const System<3>&, Measures<3>&, const RunState&);
template RunState read_checkpoint<2>(const std::string&, System<2>&, Measures<2>&);
template RunState read_checkpoint<3>(const std::string&, System<3>&, Measures<3>&);

}  // namespace washfsi
