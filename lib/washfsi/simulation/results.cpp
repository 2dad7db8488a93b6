// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/results.hpp"

#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "washfsi/output/marker_table.hpp"
#include "washfsi/simulation/version.hpp"
#include "washfsi/statistics/write_phases.hpp"
#include "washfsi/statistics/write_statistics.hpp"
#include "washfsi/support/hdf5_file.hpp"

namespace washfsi {

double peak_memory(MPI_Comm comm) {
  rusage usage{};
  (void)getrusage(RUSAGE_SELF, &usage);
  return ordered_sum(comm, 1024.0 * static_cast<double>(usage.ru_maxrss));
}

template <int Dim>
Results<Dim>::Results(const System<Dim>& system, Measures<Dim>& measures, std::vector<Profile<Dim>> profiles,
                      std::string folder, long restart_step)
    : system_(system),
      measures_(measures),
      profiles_(std::move(profiles)),
      folder_(std::move(folder)),
      flow_(system.model.grid, system.model.boundary, folder_, restart_step) {
  if (!system.model.body_list.empty()) {
    bodies_.emplace(system.model.grid, system.model.body_list, folder_, restart_step);
    surfaces_.emplace(system.model.grid, system.model.body_list, folder_, restart_step);
  }
  if (system.model.cloths.marker_count() > 0)
    cloth_.emplace(system.model.grid.comm(), system.model.cloths, folder_, restart_step);
  if (!flow_.is_new()) last_frame_ = restart_step;
}

template <int Dim>
bool Results<Dim>::holds_a_run(MPI_Comm comm, const std::string& folder) {
  return any_rank(comm, rank_of(comm) == 0 && std::filesystem::exists(folder + "/history.csv"));
}

template <int Dim>
bool Results<Dim>::holds_an_end(MPI_Comm comm, const std::string& folder) {
  return any_rank(comm, rank_of(comm) == 0 && std::filesystem::exists(folder + "/summary.json"));
}

template <int Dim>
void Results<Dim>::remove_summary(MPI_Comm comm, const std::string& folder) {
  std::error_code ignored;
  if (rank_of(comm) == 0) std::filesystem::remove(folder + "/summary.json", ignored);
  MPI_Barrier(comm);
}

template <int Dim>
void Results<Dim>::remove_ends(MPI_Comm comm, const std::string& folder) {
  std::error_code ignored;  // a file that cannot be removed cannot be written either, and that error says more
  if (rank_of(comm) == 0) {
    for (const char* name : {"checkpoint.h5", "checkpoint_before.h5", "summary.json", "cloth_final.csv",
                             "statistics.h5", "statistics.csv", "phases.h5"})
      std::filesystem::remove(folder + "/" + name, ignored);
    std::filesystem::remove_all(folder + "/profiles", ignored);
  }
  MPI_Barrier(comm);
}

namespace {

std::vector<Column> history_columns(const QuantityList& quantities) {
  std::vector<Column> columns{{"step", "-"}};
  for (const Column& column : quantities.columns()) columns.push_back(column);
  return columns;
}

std::vector<Column> cycle_columns(const Cycles& cycles) {
  std::vector<Column> columns{{"cycle", "-"}, {"start_up", "-"}, {"start", "s"}, {"end", "s"}};
  for (const CycleFigure& figure : cycles.figures()) columns.push_back({figure.name, figure.unit});
  return columns;
}

// Findings as JSON; numbers and limits only for those that have them, since JSON has no NaN.
nlohmann::ordered_json json_of(const Findings& findings) {
  auto list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    auto& entry = list.emplace_back(
        nlohmann::ordered_json{{"name", finding.name}, {"verdict", name_of(finding.verdict)}, {"found", finding.text}});
    if (std::isfinite(finding.value)) entry["value"] = finding.value;
    if (std::isfinite(finding.limit)) entry["limit"] = finding.limit;
    if (finding.verdict != Verdict::ok) entry["advice"] = finding.advice;
  }
  return list;
}

// Means over cycles with their spread; none before two are complete.
nlohmann::ordered_json summary_of(const Cycles& cycles) {
  auto figures = nlohmann::ordered_json::object();
  for (std::size_t n = 0; cycles.counted() > 0 && n < cycles.figures().size(); ++n) {
    const auto [mean, deviation] = cycles.mean(n);
    figures[cycles.figures()[n].name] = {{"mean", mean}, {"std", deviation}, {"unit", cycles.figures()[n].unit}};
  }
  return {{"time", cycles.period()},
          {"complete", cycles.completed()},
          {"first", Cycles::first_in_means},
          {"figures", figures}};
}

}  // namespace

template <int Dim>
void Results<Dim>::open_history(long restart_step) {
  history_.emplace(system_.model.grid.comm(), folder_ + "/history.csv", history_columns(measures_.quantities()),
                   restart_step);
  if (cloth_)
    tracks_.emplace(system_.model.grid.comm(), folder_ + "/tracks.csv", measures_.cloth().track_columns(),
                    restart_step);
  const Cycles& cycles = measures_.cycles();
  if (cycles.are_there())
    cycles_.emplace(system_.model.grid.comm(), folder_ + "/cycles.csv", cycle_columns(cycles),
                    restart_step < 0 ? -1 : cycles.completed());
}

namespace {

// Further fields of cells, beside velocity and pressure.
template <int Dim>
std::vector<CellField> further_fields(const Model<Dim>& model) {
  if (!model.liquid.has_models()) return {};
  CellField added{"eddy_viscosity", "Pa s", 1, {}};
  model.liquid.visit_added_viscosity([&](double viscosity) { added.values.push_back(viscosity); });
  return {added};
}

}  // namespace

template <int Dim>
void Results<Dim>::write_frame(long step) {
  if (step == last_frame_) return;
  last_frame_ = step;
  const double time = system_.state.clock.time;
  flow_.write(time, step, system_.model.fluid.velocity(), system_.model.fluid.projection().pressure(),
              further_fields(system_.model));
  if (bodies_) bodies_->write(time, step);
  if (surfaces_) surfaces_->write(time, step);
  if (cloth_) cloth_->write(time, step, system_.state.positions, system_.state.velocities, measures_.marker_fields());
}

template <int Dim>
void Results<Dim>::write_row(long step) {
  history_->append(step, measures_.quantities().row());
  if (tracks_) tracks_->append(step, measures_.cloth().track_row());
  for (const Cycles::Row& row : measures_.cycles().take_completed()) {
    std::vector<double> values{row.number < Cycles::first_in_means ? 1.0 : 0.0, row.start, row.end};
    values.insert(values.end(), row.values.begin(), row.values.end());
    cycles_->append(row.number, values);
  }
}

template <int Dim>
void Results<Dim>::write_final() const {
  for (const auto& profile : profiles_)
    profile.write(system_.model.grid, system_.model.boundary, system_.model.fluid.velocity(),
                  system_.model.fluid.projection().pressure(), system_.state.clock.time, folder_);
  if (measures_.statistics()) write_statistics<Dim>(*measures_.statistics(), folder_);
  if (measures_.phases()) write_phases(*measures_.phases(), folder_);
  if (cloth_)
    write_marker_table<Dim>(system_.model.grid.comm(), folder_ + "/cloth_final.csv", system_.model.cloths,
                            system_.state.positions, system_.state.velocities);
}

template <int Dim>
void Results<Dim>::write_summary(const RunSummary& summary) const {
  const SolverCounts counts = system_.model.fluid.counts();
  const double steps = std::max(1.0, static_cast<double>(system_.state.clock.step));
  nlohmann::ordered_json json;
  json["program"] = "washfsi";
  json["version"] = version_text;
  json["git"] = git_text;
  json["case"] = summary.case_name;
  json["status"] = summary.status;
  json["ranks"] = ranks_of(system_.model.grid.comm());
  json["steps"] = summary.steps;
  json["time"] = summary.time;
  json["wall_seconds"] = summary.wall_seconds;
  json["seconds_per_step"] = summary.seconds_per_step;
  json["iterations"] = {{"momentum", counts.momentum / steps},
                        {"pressure", counts.pressure / steps},
                        {"cloth", system_.step.cloth_iterations / steps}};
  for (const char* name : {"max_divergence", "max_cfl"})
    json[name] = measures_.quantities().summary_value(std::string("/") + name);
  json["peak_memory_bytes"] = std::llround(peak_memory(system_.model.grid.comm()));
  for (const char* part : {"bodies", "walls", "cloths"}) json[part] = nlohmann::ordered_json::object();
  for (const auto& [pointer, value, is_count] : measures_.quantities().summary()) {
    auto& entry = json[nlohmann::ordered_json::json_pointer(pointer)];
    if (is_count)
      entry = std::llround(value);
    else
      entry = value;
  }
  json["trust"] = {{"start", json_of(summary.at_start)}, {"end", json_of(summary.at_end)}};
  if (measures_.cycles().are_there()) json["cycles"] = summary_of(measures_.cycles());
  if (Dim == 2)  // a turn needs three dimensions
    for (auto& cloth : json["cloths"]) cloth["tumbles"] = nullptr;
  write_text_file(system_.model.grid.comm(), folder_ + "/summary.json", json.dump(2) + "\n");
}

template class Results<2>;
template class Results<3>;

}  // namespace washfsi
