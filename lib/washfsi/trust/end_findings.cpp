// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/trust/end_findings.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/format_text.hpp"

namespace washfsi {

namespace {

double figure_named(const Cycles& cycles, const std::string& name) {
  const std::vector<double> values = cycles.so_far();
  for (std::size_t n = 0; n < values.size(); ++n)
    if (cycles.figures()[n].name == name) return values[n];
  return 0;
}

double energy_put_in(const Cycles& run) {
  const std::vector<double> values = run.so_far();
  double sum = 0;
  for (std::size_t n = 0; n < values.size(); ++n)
    if (run.figures()[n].balance > 0) sum += values[n];
  return sum;
}

template <int Dim>
void add_energy(const Model<Dim>& model, const Cycles& run, Findings& findings) {
  const double work = energy_put_in(run);
  if (!(work > 0) || model.boundary.largest_speed(0) > 0) return;  // sides that move put energy in too
  const double open = std::abs(figure_named(run, "energy_open")) / work,
               mask = figure_named(run, "mask_dissipated") / work;
  const std::string of_work = format_text("of %.3g %s put in", work, Dim == 2 ? "J/m" : "J");
  findings.push_back(at_most("energy open", 100 * open, {5, 20}, format_text("%.2g %% ", 100 * open) + of_work,
                             "loads and flow are not in balance by so much; shorter -time_step, more -grid_cells"));
  if (mask > 0)
    findings.push_back(at_most("energy lost by the mask", 100 * mask, {10, 50},
                               format_text("%.2g %% ", 100 * mask) + of_work,
                               "the staircase of moving walls takes it; more -grid_cells"));
}

void add_drift(const Cycles& cycles, Findings& findings) {
  if (cycles.counted() < 2) return;
  for (std::size_t n = 0; n < cycles.figures().size(); ++n) {
    const CycleFigure& figure = cycles.figures()[n];
    const auto [mean, deviation] = cycles.mean(n);
    if (figure.balance <= 0 || mean == 0) continue;
    const double spread = deviation / std::abs(mean);
    findings.push_back(at_most(figure.name + " of cycles", 100 * spread, {10, 50},
                               format_text("spread by %.2g %% of their mean, over %ld", 100 * spread, cycles.counted()),
                               "one cycle does not stand for the others; longer -time_end, several seeds"));
  }
}

void add_steps(const QuantityList& quantities, double dt, Findings& findings) {
  const double courant = quantities.summary_value("/max_cfl");
  findings.push_back(at_most("CFL number", courant, {0.8}, format_text("at most %.3g", courant),
                             "the advection scheme gains energy there; -time_cfl 0.5"));
  const double change = dt * quantities.summary_value("/max_divergence");
  findings.push_back(at_most("volume", change, {1e-6, 1e-3}, format_text("kept to %.2g a step", change),
                             "water is made or lost; smaller -pressure_tolerance"));
}

template <int Dim>
void add_cloth(const Model<Dim>& model, const QuantityList& quantities, const std::string& name, Findings& findings) {
  const std::string pointer = "/cloths/" + name;
  const double stretch = quantities.summary_value(pointer + "/max_stretch");
  findings.push_back(at_most(name + " stretch", 100 * stretch, {5, 20}, format_text("%.2g %% at most", 100 * stretch),
                             "no fabric stretches as much; stiffer -" + name + "_ke, shorter -time_step"));
  if (model.bodies.empty()) return;
  const double depth = quantities.summary_value(pointer + "/max_depth"),
               cells = depth / model.grid.spacing().minCoeff();
  findings.push_back(at_most(name + " depth in bodies", cells, {0.5, 2},
                             format_text("%.2g m, %.2g cells", depth, cells),
                             "cloth goes through walls; larger -contact_pressure, shorter -time_step"));
}

template <int Dim>
void add_crossings(const Model<Dim>& model, const QuantityList& quantities, Findings& findings) {
  if (Dim == 2 || model.cloths.pieces().size() < 2) return;
  const double crossings = quantities.summary_value("/cloth_crossings");
  const double share = crossings / static_cast<double>(model.cloths.marker_count());
  findings.push_back(at_most("crossings", share, {0, 0.5},
                             format_text("%.0f of %d markers went through another cloth", crossings,
                                         static_cast<int>(model.cloths.marker_count())),
                             "cloths pass through each other; turns and stress of the load are wrong by it"));
}

}  // namespace

template <int Dim>
Findings end_findings(const System<Dim>& system, const Measures<Dim>& measures) {
  const Model<Dim>& model = system.model;
  const QuantityList& quantities = measures.quantities();
  Findings findings;
  if (model.has_fluid) {
    add_energy(model, measures.whole_run(), findings);
    const Clock& clock = system.state.clock;
    add_steps(quantities, clock.time / static_cast<double>(std::max(1L, clock.step)), findings);
  }
  add_drift(measures.cycles(), findings);
  for (const auto& group : model.cloths.groups()) add_cloth(model, quantities, group.name, findings);
  add_crossings(model, quantities, findings);
  return findings;
}

template Findings end_findings<2>(const System<2>&, const Measures<2>&);
template Findings end_findings<3>(const System<3>&, const Measures<3>&);

}  // namespace washfsi
