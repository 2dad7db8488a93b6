// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/results.hpp"

#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "washfsi/output/marker_table.hpp"
#include "washfsi/simulation/version.hpp"
#include "washfsi/support/hdf5_file.hpp"

namespace washfsi {

double peak_memory(MPI_Comm comm) {
  rusage usage{};
  (void)getrusage(RUSAGE_SELF, &usage);
  return ordered_sum(comm, 1024.0 * static_cast<double>(usage.ru_maxrss));
}

template <int Dim>
Results<Dim>::Results(const System<Dim>& system, const Measures<Dim>& measures, std::vector<Profile<Dim>> profiles,
                      std::string folder, long restart_step)
    : system_(system),
      measures_(measures),
      profiles_(std::move(profiles)),
      folder_(std::move(folder)),
      flow_(system.grid, system.boundary, folder_, restart_step) {
  if (!system.bodies.empty()) bodies_.emplace(system.grid, system.bodies, folder_, restart_step);
  if (system.cloths.marker_count() > 0) cloth_.emplace(system.grid.comm(), system.cloths, folder_, restart_step);
  if (!flow_.is_new()) last_frame_ = restart_step;
}

template <int Dim>
bool Results<Dim>::holds_a_run(MPI_Comm comm, const std::string& folder) {
  return any_rank(comm, rank_of(comm) == 0 && std::filesystem::exists(folder + "/history.csv"));
}

template <int Dim>
void Results<Dim>::remove_ends(MPI_Comm comm, const std::string& folder) {
  std::error_code ignored;  // what cannot be removed cannot be written either, which tells more
  if (rank_of(comm) == 0) {
    for (const char* name : {"checkpoint.h5", "summary.json", "cloth_final.csv"})
      std::filesystem::remove(folder + "/" + name, ignored);
    std::filesystem::remove_all(folder + "/profiles", ignored);
  }
  MPI_Barrier(comm);
}

template <int Dim>
void Results<Dim>::open_history(long restart_step) {
  history_.emplace(system_.grid.comm(), folder_ + "/history.csv", measures_.columns(), restart_step);
  if (cloth_)
    tracks_.emplace(system_.grid.comm(), folder_ + "/tracks.csv", measures_.cloth().track_columns(), restart_step);
}

template <int Dim>
void Results<Dim>::write_frame(long step) {
  if (step == last_frame_) return;
  last_frame_ = step;
  const double time = system_.fluid.time();
  flow_.write(time, step, system_.fluid.velocity(), system_.fluid.pressure());
  if (bodies_) bodies_->write(time, step);
  if (cloth_) cloth_->write(time, step, system_.positions, system_.velocities);
}

template <int Dim>
void Results<Dim>::write_row(long step, double dt) {
  history_->append(step, measures_.row(dt));
  if (tracks_) tracks_->append(step, measures_.cloth().track_row());
}

template <int Dim>
void Results<Dim>::write_final() const {
  for (const auto& profile : profiles_)
    profile.write(system_.grid, system_.boundary, system_.fluid.velocity(), system_.fluid.pressure(),
                  system_.fluid.time(), folder_);
  if (cloth_)
    write_marker_table<Dim>(system_.grid.comm(), folder_ + "/cloth_final.csv", system_.cloths, system_.positions,
                            system_.velocities);
}

namespace {

template <int Dim>
nlohmann::ordered_json json_of(const Load<Dim>& load) {
  nlohmann::ordered_json json;
  json["force"] = std::vector<double>(load.force.data(), load.force.data() + Dim);
  if (Dim == 2)
    json["torque"] = load.torque[0];
  else
    json["torque"] = std::vector<double>(load.torque.data(), load.torque.data() + rotation_components<Dim>);
  return json;
}

}  // namespace

template <int Dim>
void Results<Dim>::write_summary(const RunSummary& summary) const {
  const SolverCounts& counts = system_.fluid.counts();
  const double steps = counts.steps > 0 ? counts.steps : 1;
  nlohmann::ordered_json json;
  json["program"] = "washfsi";
  json["version"] = version_text;
  json["git"] = git_text;
  json["case"] = summary.case_name;
  json["status"] = summary.status;
  json["ranks"] = ranks_of(system_.grid.comm());
  json["steps"] = summary.steps;
  json["time"] = summary.time;
  json["wall_seconds"] = summary.wall_seconds;
  json["seconds_per_step"] = summary.seconds_per_step;
  json["iterations"] = {{"momentum", counts.momentum / steps},
                        {"pressure", counts.pressure / steps},
                        {"cloth", system_.cloth_iterations / steps}};
  json["max_divergence"] = measures_.largest_divergence();
  json["peak_memory_bytes"] = std::llround(peak_memory(system_.grid.comm()));
  json["bodies"] = nlohmann::ordered_json::object();
  for (std::size_t b = 0; b < system_.bodies.size(); ++b) {
    auto& body = json["bodies"][system_.bodies[b].name];
    body = json_of(measures_.loads()[b]);
    body["power"] = measures_.powers()[b];
    if (measures_.has_balance()) body["balance"] = json_of(measures_.balance_loads()[b]);
  }
  json["walls"] = nlohmann::ordered_json::object();
  const auto walls = measures_.wall_names();
  for (std::size_t w = 0; w < walls.size(); ++w) json["walls"][walls[w]] = json_of(measures_.loads_on_walls()[w]);
  json["cloths"] = nlohmann::ordered_json::object();
  for (std::size_t g = 0; g < measures_.cloth().groups().size(); ++g) {
    const GroupMeasures& group = measures_.cloth().groups()[g];
    auto& cloth = json["cloths"][system_.cloths.groups()[g].name];
    const auto& quantities = marker_quantities<Dim>();
    for (std::size_t n = 0; n < quantities.size(); ++n) {
      cloth[quantities[n].name + "_mean"] = group.mean[n];
      cloth[quantities[n].name + "_std"] = group.deviation[n];
    }
    cloth["max_stretch"] = group.max_stretch;
    cloth["max_depth"] = group.max_depth;
    if (Dim == 3)
      cloth["tumbles"] = group.tumbles;
    else
      cloth["tumbles"] = nullptr;  // a turn needs three dimensions
  }
  if (const ClothCrossings* crossings = measures_.cloth().crossings())
    json["cloth_crossings"] = std::llround(crossings->crossings());
  write_text_file(system_.grid.comm(), folder_ + "/summary.json", json.dump(2) + "\n");
}

template class Results<2>;
template class Results<3>;

}  // namespace washfsi
