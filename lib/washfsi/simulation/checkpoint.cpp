// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/checkpoint.hpp"

#include <algorithm>
#include <filesystem>

#include "washfsi/output/field_slab.hpp"
#include "washfsi/scheme/coupling_operations.hpp"
#include "washfsi/simulation/shared_arrays.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

constexpr double format = 9;  ///< of the file; another number for any other content

// The numbers that a state has besides its fields, in the order in which they are kept; as attributes for readers.
constexpr std::array number_names{"step",
                                  "time",
                                  "time_step",
                                  "cloth_bound",
                                  "steps_at_rest",
                                  "last_step",
                                  "step_before_last",
                                  "momentum_iterations",
                                  "pressure_iterations",
                                  "cloth_iterations"};

void write_vector(Hdf5File& file, const std::string& name, const Slab& slab, Vec vector) {
  const double* values = nullptr;
  PetscInt size = 0;
  WASH_PETSC(VecGetLocalSize(vector, &size));
  WASH_PETSC(VecGetArrayRead(vector, &values));
  const std::vector<double> copy(values, values + size);
  WASH_PETSC(VecRestoreArrayRead(vector, &values));
  file.write_sealed(name, slab, copy);
}

void read_vector(Hdf5File& file, const std::string& name, const Slab& slab, Vec vector) {
  const std::vector<double> copy = file.read_sealed(name, slab);
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
Points<Dim> read_points(Hdf5File& file, const std::string& name, const Slab& slab) {
  const std::vector<double> flat = file.read_sealed(name, slab);
  Points<Dim> points(flat.size() / Dim);
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
    file.write_sealed(dataset_of(layer), box_slab<Dim>(layer.all_cells(), layer.owned_cells(), Dim), layer.values());
}

template <int Dim>
void read_outflow(Hdf5File& file, System<Dim>& system) {
  for (auto& layer : system.model.boundary.outflows())
    layer.set_values(file.read_sealed(dataset_of(layer), box_slab<Dim>(layer.all_cells(), layer.all_cells(), Dim),
                                      Hdf5File::Readers::whole));
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

constexpr const char *wall_forces = "/walls/force", *wall_pushes = "/walls/pushes";

// So many points for each.
template <int Dim>
Slab slab_of_patches(const SurfaceForcing<Dim>& walls, std::size_t each = 1) {
  const auto number = [each](std::size_t n) { return static_cast<PetscInt>(n * each); };
  return marker_slab(number(walls.patch_count()), number(walls.own().begin), number(walls.own().end), Dim);
}

template <int Dim>
void write_wall_forces(Hdf5File& file, const System<Dim>& system) {
  const SurfaceForcing<Dim>* walls = system.model.walls.get();
  file.set_attribute("/", "wall_patches", walls ? static_cast<double>(walls->patch_count()) : 0.0);
  if (!walls) return;
  file.write_sealed(wall_forces, slab_of_patches(*walls), flattened<Dim>(walls->kept()));
  const KnownPushes<Dim>& pushes = walls->known_pushes();
  file.set_attribute("/", "wall_pushes", static_cast<double>(pushes.size()));
  if (pushes.size() > 0)
    file.write_sealed(wall_pushes, slab_of_patches(*walls, 2 * pushes.size()), flattened<Dim>(pushes.kept()));
}

// Other bodies, or another way of holding them, begin without forces.
template <int Dim>
void read_wall_forces(Hdf5File& file, SurfaceForcing<Dim>& walls) {
  if (file.attribute("/", "wall_patches") != static_cast<double>(walls.patch_count())) return;
  walls.kept() = read_points<Dim>(file, wall_forces, slab_of_patches(walls));
  const auto pushes = static_cast<std::size_t>(file.attribute("/", "wall_pushes"));
  if (pushes > 0)
    walls.known_pushes().take(read_points<Dim>(file, wall_pushes, slab_of_patches(walls, 2 * pushes)), pushes);
}

// What the law of the walls' friction has filtered of the flow so far.
template <int Dim>
void write_wall_model(Hdf5File& file, const System<Dim>& system) {
  const Model<Dim>& model = system.model;
  file.set_attribute("/", "wall_model", model.liquid.walls() ? 1.0 : 0.0);
  if (!model.liquid.walls()) return;
  for (const auto& [name, vector] : model.liquid.walls()->face_state())
    write_vector(file, "/fluid/" + name, field_slab(model.grid, Dim), vector);
}

// After a run without it begins with the flow as it is.
template <int Dim>
void read_wall_model(Hdf5File& file, System<Dim>& system) {
  WallModel<Dim>* walls = system.model.liquid.walls();
  if (!walls || file.attribute("/", "wall_model") == 0) return;
  for (const auto& [name, vector] : walls->face_state())
    read_vector(file, "/fluid/" + name, field_slab(system.model.grid, Dim), vector);
  walls->go_on();
}

constexpr const char* wall_law_means = "/walls/means";

// The points where bodies have a law of friction, each with its means.
template <int Dim>
Slab slab_of_points(const BodyWallLaw<Dim>& law) {
  constexpr auto each = static_cast<PetscInt>(BodyWallLaw<Dim>::kept_of_each);
  const auto number = [](std::size_t n) { return static_cast<PetscInt>(n) * each; };
  return marker_slab(number(law.point_count()), number(law.begin()), number(law.end()), Dim);
}

template <int Dim>
void write_wall_law(Hdf5File& file, const System<Dim>& system) {
  const BodyWallLaw<Dim>* law = system.model.wall_law.get();
  file.set_attribute("/", "wall_points", law ? static_cast<double>(law->point_count()) : 0.0);
  if (law && law->point_count() > 0)
    file.write_sealed(wall_law_means, slab_of_points(*law), flattened<Dim>(law->kept()));
}

// Other bodies begin with the flow as it is.
template <int Dim>
void read_wall_law(Hdf5File& file, System<Dim>& system) {
  BodyWallLaw<Dim>* law = system.model.wall_law.get();
  if (!law || law->point_count() == 0) return;
  if (file.attribute("/", "wall_points") != static_cast<double>(law->point_count())) return;
  law->kept() = read_points<Dim>(file, wall_law_means, slab_of_points(*law));
  law->go_on();
}

constexpr const char* driving_guess = "/driving";

// The mean pressure gradient from which the next step's is found.
template <int Dim>
void write_driving(Hdf5File& file, const System<Dim>& system) {
  const auto kept = system.model.fluid.driving().kept();
  if (!system.model.fluid.driving().is_there()) return;
  write_shared(file, system.model.grid.comm(), driving_guess, {kept.begin(), kept.end()});
}

// What is driven otherwise than before finds it by itself.
template <int Dim>
void read_driving(Hdf5File& file, System<Dim>& system) {
  Driving<Dim>& driving = system.model.fluid.driving();
  if (!driving.is_there() || !file.has(driving_guess)) return;
  const std::vector<double> kept = read_shared(file, driving_guess);
  for (int d = 0; d < Dim; ++d)
    if (driving.keeps_bulk(d)) driving.kept()[static_cast<std::size_t>(d)] = kept[static_cast<std::size_t>(d)];
}

// What some coupling schemes need of the step before.
template <class SomeState>
auto motion_before(SomeState& state) {
  return std::array{std::pair{std::string("velocity_before"), &state.velocities_before},
                    std::pair{std::string("mean_velocity"), &state.mean_velocities},
                    std::pair{std::string("force_before"), &state.forces_before}};
}

// In the order of their names.
template <int Dim>
std::vector<double> numbers_of(const System<Dim>& system, const RunState& state) {
  const FractionalStep<Dim>& fluid = system.model.fluid;
  return {static_cast<double>(system.state.clock.step),
          system.state.clock.time,
          state.dt,
          state.cloth_bound,
          static_cast<double>(state.steps_at_rest),
          fluid.last_step(),
          fluid.step_before_last(),
          fluid.counts().momentum,
          fluid.counts().pressure,
          system.step.cloth_iterations};
}

}  // namespace

template <int Dim>
void write_checkpoint(const std::string& folder, const System<Dim>& system, Measures<Dim>& measures,
                      const RunState& state) {
  const petsc::LogPart part("output");
  const std::string path = folder + "/checkpoint.h5", temporary = path + ".part";
  const MPI_Comm comm = system.model.grid.comm();
  Hdf5File file(comm, temporary, Hdf5File::Mode::create);
  file.set_attribute("/", "format", format);
  const std::vector<double> numbers = numbers_of(system, state);
  for (std::size_t n = 0; n < numbers.size(); ++n) file.set_attribute("/", number_names[n], numbers[n]);
  write_shared(file, comm, "/numbers", numbers);
  for (const auto& [name, vector] : system.model.fluid.face_state())
    write_vector(file, "/fluid/" + name, field_slab(system.model.grid, Dim), vector);
  for (const auto& [name, vector] : system.model.fluid.cell_state())
    write_vector(file, "/fluid/" + name, field_slab(system.model.grid, 1), vector);
  write_wall_model(file, system);
  write_outflow(file, system);
  if (system.model.cloths.marker_count() > 0) {
    file.write_sealed("/cloth/position", slab_of_markers(system.model.cloths, Dim),
                      flattened<Dim>(system.state.positions));
    file.write_sealed("/cloth/velocity", slab_of_markers(system.model.cloths, Dim),
                      flattened<Dim>(system.state.velocities));
    for (const auto& [name, values] : motion_before(system.state))
      file.write_sealed("/cloth/" + name, slab_of_markers(system.model.cloths, Dim), flattened<Dim>(*values));
    file.write_sealed("/cloth/time_integrals", slab_of_integrals(system.model.cloths),
                      measures.cloth().time_integrals());
  }
  write_wall_forces(file, system);
  write_wall_law(file, system);
  write_driving(file, system);
  write_contact_distances(file, system.model.forces);
  write_shared(file, comm, "/options", {state.options.begin(), state.options.end()});
  write_shared(file, comm, "/identity", identity(system));
  write_shared(file, comm, "/measured", measures.quantities().taken());
  for (const auto& [name, kept, others] : measures.quantities().kept())
    write_shared(file, comm, "/totals/" + name, {kept.begin(), kept.end()});
  file.close();
  const bool committed = rank_of(comm) != 0 || commit_file(temporary, path, folder + "/checkpoint_before.h5");
  if (any_rank(comm, !committed)) throw FileError(path + ": cannot be written");
}

namespace {

// What goes on from step to step in the measures.
template <int Dim>
void read_totals(Hdf5File& file, Measures<Dim>& measures) {
  QuantityList& quantities = measures.quantities();
  const std::size_t taken = quantities.taken().size();
  if (file.shape("/measured").at(0) == taken)  // no other measures than before
    quantities.set_taken(read_shared(file, "/measured"));
  for (const auto& [name, kept, others] : quantities.kept()) {
    const std::string path = "/totals/" + name;
    if (others == QuantityList::IfOthers::begin_anew && (!file.has(path) || file.shape(path).at(0) != kept.size()))
      continue;
    std::ranges::copy(read_shared(file, path), kept.begin());
  }
}

}  // namespace

template <int Dim>
RunState read_checkpoint(const std::string& path, System<Dim>& system, Measures<Dim>& measures) {
  const MPI_Comm comm = system.model.grid.comm();
  try {
    Hdf5File file(comm, path, Hdf5File::Mode::read);
    if (file.attribute("/", "format") != format)
      throw InputError(path + ": its format is " + to_text(file.attribute("/", "format")) + ", this program reads " +
                       to_text(format));
    if (read_shared(file, "/identity") != identity(system))
      throw InputError(path + ": the box or the cloths' markers are others");
    for (const auto& [name, vector] : system.model.fluid.face_state())
      read_vector(file, "/fluid/" + name, field_slab(system.model.grid, Dim), vector);
    for (const auto& [name, vector] : system.model.fluid.cell_state())
      read_vector(file, "/fluid/" + name, field_slab(system.model.grid, 1), vector);
    read_wall_model(file, system);
    read_outflow(file, system);
    if (system.model.cloths.marker_count() > 0) {
      const Slab slab = slab_of_markers(system.model.cloths, Dim);
      system.state.positions = read_points<Dim>(file, "/cloth/position", slab);
      system.state.velocities = read_points<Dim>(file, "/cloth/velocity", slab);
      for (const auto& [name, values] : motion_before(system.state))
        *values = read_points<Dim>(file, "/cloth/" + name, slab);
      measures.cloth().time_integrals() =
          file.read_sealed("/cloth/time_integrals", slab_of_integrals(system.model.cloths));
    }
    read_totals(file, measures);
    read_contact_distances(file, system.model.forces);
    system.model.locate_cloth(system.state.positions);
    const std::vector<double> read = read_shared(file, "/numbers");
    system.state.clock = {read[1], static_cast<long>(read[0])};
    system.model.boundary.set_outflow_time(system.state.clock.time);
    system.model.mask.update(system.state.clock.time);
    hold_walls(system.model, system.state.clock.time);
    read_driving(file, system);
    if (system.model.walls) read_wall_forces(file, *system.model.walls);
    read_wall_law(file, system);
    system.model.fluid.set_last_steps(read[5], read[6]);
    system.model.fluid.set_counts({.momentum = read[7], .pressure = read[8]});
    system.step.cloth_iterations = read[9];
    const std::vector<double> letters = read_shared(file, "/options");
    return {read[2], read[3], static_cast<int>(read[4]), std::string(letters.begin(), letters.end())};
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
