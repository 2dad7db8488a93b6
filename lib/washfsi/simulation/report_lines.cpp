// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/report_lines.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/format_text.hpp"

namespace washfsi {

namespace {

template <int Dim>
std::string grid_text(const Grid<Dim>& grid) {
  std::vector<std::string> counts, spacings;
  for (int d = 0; d < Dim; ++d) {
    counts.push_back(std::to_string(grid.cells()[d]));
    spacings.push_back(format_text("%.4g", grid.spacing()[d]));
  }
  return join(counts, " x ") + " cells of " + join(spacings, " x ") + " m";
}

template <int Dim>
std::string cloth_text(const ClothGroup<Dim>& group) {
  return std::to_string(group.count) + " " + group.name + " of " + std::to_string(group.markers[0]) +
         (Dim == 3 ? " x " + std::to_string(group.markers[1]) : "") + " markers";
}

std::string solvers_text() {
  return "momentum " + petsc::option_value("", "-momentum_ksp_type", "gmres") + "/" +
         petsc::option_value("", "-momentum_pc_type", "jacobi") + ", pressure " +
         petsc::option_value("", "-pressure_ksp_type", "cg") + "/" +
         petsc::option_value("", "-pressure_pc_type", "transform");
}

std::string figure_text(const CycleFigure& figure, const Cycles::Mean& mean, long count) {
  const std::string unit = figure.unit == "-" ? "" : " " + figure.unit;
  const std::string spread = count > 1 ? format_text(" (+- %.2g)", mean.deviation) : "";
  return format_text("    %-26s %.4g%s", figure.name.c_str(), mean.mean, unit.c_str()) + spread;
}

}  // namespace

template <int Dim>
std::vector<std::string> banner_lines(const Model<Dim>& model, const std::string& case_name,
                                      const std::string& coupling) {
  const int ranks = ranks_of(model.grid.comm());
  std::vector<std::string> bodies, groups;
  for (const auto& body : model.body_list) bodies.push_back(body.name);
  for (const auto& group : model.cloths.groups()) groups.push_back(cloth_text(group));
  std::vector<std::string> lines{
      format_text("washfsi: case %s, %d rank%s", case_name.c_str(), ranks, ranks == 1 ? "" : "s"),
      "  grid      " + grid_text(model.grid)};
  if (!bodies.empty()) lines.push_back("  bodies    " + join(bodies, ", "));
  if (!groups.empty())
    lines.push_back("  cloth     " + join(groups, ", ") + " (" + std::to_string(model.cloths.marker_count()) +
                    " markers), coupled " + coupling);
  lines.push_back("  solvers   " + solvers_text());
  return lines;
}

std::string time_line(double step, double end, double bound, bool has_cloths) {
  return format_text("  time      step %.4g s, end %.4g s", step, end) +
         (std::isfinite(bound) ? format_text(", bound of the coupling %.4g s", bound)
          : has_cloths         ? ", which the coupling does not bound"
                               : "");
}

// The end that is advised is rounded up, so that the last cycle is complete.
std::vector<std::string> demonstration_lines(const Cycles& cycles, double end) {
  constexpr double rounding = 1e-6;
  if (!cycles.are_there() || end > (1 - rounding) * Cycles::first_in_means * cycles.period()) return {};
  const bool has_first = end > (1 - rounding) * cycles.period();
  const double wanted = Cycles::wanted * cycles.period(), unit = std::pow(10, std::floor(std::log10(wanted)) - 3);
  return {format_text("  cycles    %s: a demonstration; figures of a machine need %ld, -time_end %.4g",
                      has_first ? "one, which is start-up" : "not one complete", Cycles::wanted,
                      std::ceil(wanted / unit - rounding) * unit)};
}

namespace {

// Cost, and the main figures.
template <int Dim>
std::vector<std::string> result_lines(const System<Dim>& system, const Measures<Dim>& measures,
                                      const RunSummary& summary) {
  const SolverCounts counts = system.model.fluid.counts();
  const double steps = std::max(1.0, static_cast<double>(summary.steps));
  const QuantityList& quantities = measures.quantities();
  std::vector<std::string> lines{
      format_text("%s after %ld steps at t = %.6g s", summary.status.c_str(), summary.steps, summary.time),
      format_text("  wall time          %.2f s, %.3f ms a step", summary.wall_seconds, 1e3 * summary.seconds_per_step),
      format_text("  iterations a step  momentum %.2f, pressure %.2f", counts.momentum / steps,
                  counts.pressure / steps),
      format_text("  max divergence     %.3e 1/s", quantities.summary_value("/max_divergence"))};
  const char* unit = Dim == 2 ? "N (per metre: N m/m)" : "N m";
  for (const auto& body : system.model.body_list) {
    const std::string torque = "/bodies/" + body.name + "/torque" + (Dim == 3 ? "/2" : "");
    lines.push_back(format_text("  %-18s torque %.4g %s", body.name.c_str(), quantities.summary_value(torque), unit));
  }
  for (const auto& group : system.model.cloths.groups()) {
    const auto of_run = [&](const char* quantity) {
      return quantities.summary_value("/cloths/" + group.name + quantity);
    };
    lines.push_back(format_text("  %-18s mean stress %.4g Pa (+- %.3g), largest stretch %.3g %%", group.name.c_str(),
                                of_run("/stress_mean"), of_run("/stress_std"), 100 * of_run("/max_stretch")));
  }
  return lines;
}

// Means over the cycles, with their spread; empty without cycles.
std::vector<std::string> cycle_lines(const Cycles& cycles) {
  if (!cycles.are_there()) return {};
  if (cycles.counted() == 0)
    return {format_text("  cycles             %ld of %.4g s complete; figures begin with the second",
                        cycles.completed(), cycles.period())};
  std::vector<std::string> lines{
      format_text("  cycle              mean of %ld from the second on (+- their spread)", cycles.counted())};
  for (std::size_t n = 0; n < cycles.figures().size(); ++n)
    if (cycles.figures()[n].is_headline)
      lines.push_back(figure_text(cycles.figures()[n], cycles.mean(n), cycles.counted()));
  return lines;
}

}  // namespace

std::vector<std::string> trust_lines(const Findings& findings, bool all) {
  std::vector<std::string> lines;
  for (const Finding& finding : findings)
    if (all || finding.verdict != Verdict::ok || finding.display == Display::always) lines.push_back(line_of(finding));
  return lines;
}

template <int Dim>
std::vector<std::string> end_lines(const System<Dim>& system, const Measures<Dim>& measures, const RunSummary& summary,
                                   const std::string& folder) {
  std::vector<std::string> lines = result_lines(system, measures, summary);
  for (const auto& further : {cycle_lines(measures.cycles()), trust_lines(summary.at_end, true)})
    lines.insert(lines.end(), further.begin(), further.end());
  lines.push_back("  results            " + folder);
  return lines;
}

template std::vector<std::string> banner_lines<2>(const Model<2>&, const std::string&, const std::string&);
template std::vector<std::string> banner_lines<3>(const Model<3>&, const std::string&, const std::string&);
template std::vector<std::string> end_lines<2>(const System<2>&, const Measures<2>&, const RunSummary&,
                                               const std::string&);
template std::vector<std::string> end_lines<3>(const System<3>&, const Measures<3>&, const RunSummary&,
                                               const std::string&);

}  // namespace washfsi
