// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/checkpoint.hpp"

#include <algorithm>
#include <filesystem>

#include "washfsi/coupling/system_state.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/hdf5_file.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

constexpr double format = 10;  ///< number of the file's format; changes with its content

using Spread = StateEntry::Spread;

bool is_in_files(const StateEntry& entry) {
  return entry.use != StateEntry::Use::retake;
}

// Without cloths there are no values of markers.
bool is_empty(const StateEntry& entry) {
  return std::ranges::find(entry.slab.shape, hsize_t{0}) != entry.slab.shape.end();
}

// A single number is an attribute too, for readers.
void write_entry(Hdf5File& file, MPI_Comm comm, const StateEntry& entry) {
  const StateEntry::Values values = entry.get();
  if (entry.spread != Spread::shared) return file.write_sealed(entry.name, entry.slab, values);
  if (values.empty()) return;
  const hsize_t size = values.size();
  file.write_sealed(entry.name, {{size}, {0}, {rank_of(comm) == 0 ? size : hsize_t{0}}}, values);
  if (size != 1) return;
  std::string name = entry.name.substr(1);
  std::ranges::replace(name, '/', '_');
  file.set_attribute("/", name, values[0]);
}

bool fits(Hdf5File& file, const StateEntry& entry) {
  return file.has(entry.name) && (entry.slab.shape.empty() || file.shape(entry.name) == entry.slab.shape);
}

void read_entry(Hdf5File& file, const StateEntry& entry) {
  if (entry.if_other == StateEntry::IfOther::begin_anew && !fits(file, entry)) return;
  if (entry.spread == Spread::parts) return entry.set(file.read_sealed(entry.name, entry.slab));
  const std::vector<hsize_t> shape = file.shape(entry.name);
  entry.set(
      file.read_sealed(entry.name, {shape, std::vector<hsize_t>(shape.size(), 0), shape}, Hdf5File::Readers::whole));
}

// The numbers that a checkpoint must share with the run that continues it: the box, and every cloth's markers and
// spacings.
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

void register_run(RunState& run, StateList& list) {
  list.add_number("/time_step", run.dt);
  list.add_number("/cloth_bound", run.cloth_bound);
  list.add_number("/steps_at_rest", run.steps_at_rest);
  list.add({.name = "/options",
            .slab = {},
            .get = [&run] { return StateEntry::Values(run.options.begin(), run.options.end()); },
            .set = [&run](const StateEntry::Values& letters) { run.options.assign(letters.begin(), letters.end()); },
            .spread = Spread::shared});
}

// Checks the file first, so that a wrong one is refused before anything is read from it.
template <int Dim>
StateEntry identity_entry(const System<Dim>& system, const std::string& path) {
  return {.name = "/identity",
          .slab = {},
          .get = [&system] { return identity(system); },
          .set =
              [&system, path](const StateEntry::Values& values) {
                if (values != identity(system)) throw InputError(path + ": the box or the cloths' markers are others");
              },
          .spread = Spread::shared};
}

template <int Dim>
StateList state_of_run(const std::string& path, System<Dim>& system, Measures<Dim>& measures, RunState& run) {
  StateList list;
  list.add(identity_entry(system, path));
  register_state(system, list);
  measures.register_state(list);
  register_run(run, list);
  return list;
}

}  // namespace

template <int Dim>
void write_checkpoint(const std::string& folder, System<Dim>& system, Measures<Dim>& measures, RunState& run) {
  const petsc::LogPart part("output");
  const std::string path = folder + "/checkpoint.h5", temporary = path + ".part";
  const MPI_Comm comm = system.model.grid.comm();
  Hdf5File file(comm, temporary, Hdf5File::Mode::create);
  file.set_attribute("/", "format", format);
  const StateList list = state_of_run(path, system, measures, run);
  for (const StateEntry& entry : list.entries())
    if (is_in_files(entry) && !is_empty(entry)) write_entry(file, comm, entry);
  file.close();
  const bool committed = rank_of(comm) != 0 || commit_file(temporary, path, folder + "/checkpoint_before.h5");
  if (any_rank(comm, !committed)) throw FileError(path + ": cannot be written");
}

template <int Dim>
RunState read_checkpoint(const std::string& path, System<Dim>& system, Measures<Dim>& measures) {
  RunState run;
  try {
    Hdf5File file(system.model.grid.comm(), path, Hdf5File::Mode::read);
    if (file.attribute("/", "format") != format)
      throw InputError(path + ": its format is " + to_text(file.attribute("/", "format")) + ", this program reads " +
                       to_text(format));
    const StateList list = state_of_run(path, system, measures, run);
    for (const StateEntry& entry : list.entries())
      if (is_in_files(entry) && !is_empty(entry)) read_entry(file, entry);
  } catch (const InputError& error) {
    throw InputError(std::string("-restart ") + error.what() +
                     "; it must be a checkpoint of this grid and these cloths");
  }
  resume(system);
  return run;
}

template void write_checkpoint<2>(const std::string&, System<2>&, Measures<2>&, RunState&);
template void write_checkpoint<3>(const std::string&, System<3>&, Measures<3>&, RunState&);
template RunState read_checkpoint<2>(const std::string&, System<2>&, Measures<2>&);
template RunState read_checkpoint<3>(const std::string&, System<3>&, Measures<3>&);

}  // namespace washfsi
