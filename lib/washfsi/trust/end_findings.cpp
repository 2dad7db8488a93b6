// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/trust/end_findings.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/format_text.hpp"

namespace washfsi {

namespace {

/// The balance of energy over the whole run [J; in the plane J/m].
struct EnergyBalance {
  double put_in = 0, open = 0, by_mask = 0, by_advection = 0;
  double at_start = 0;  ///< kinetic

  explicit EnergyBalance(const Cycles& run) {
    const std::vector<double> values = run.so_far();
    for (std::size_t n = 0; n < values.size(); ++n) {
      const CycleFigure& figure = run.figures()[n];
      open += figure.balance * values[n];
      if (figure.balance > 0) put_in += values[n];
      if (figure.name == "mask_dissipated") by_mask = values[n];
      if (figure.name == "advection_dissipated") by_advection = values[n];
      if (figure.name == "kinetic_energy_change") at_start = run.at_start()[n];
    }
  }
};

// Whether energy passes unmeasured through sides of the box. Sides that move with a drum do its work, which is
// measured.
template <int Dim>
bool passes_sides(const Boundary<Dim>& boundary) {
  bool passes = boundary.has_outflow();
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : {End::lower, End::upper}) {
      const Side<Dim>& side = boundary.side(axis, end);
      passes = passes || (side.kind != BoundaryKind::periodic && !side.velocity.isZero(0));
    }
  return passes;
}

// Initially rotating water with little energy input is judged by its initial energy.
template <int Dim>
void add_energy(const Model<Dim>& model, const Cycles& run, Findings& findings) {
  const EnergyBalance energy(run);
  const double whole = std::max(energy.put_in, energy.at_start);
  if (!(whole > 0) || passes_sides(model.boundary)) return;
  const double open = std::abs(energy.open) / whole, mask = energy.by_mask / whole,
               advection = energy.by_advection / whole;
  const std::string of_whole = format_text(energy.put_in < whole ? "of the %.3g %s of the start" : "of %.3g %s put in",
                                           whole, Dim == 2 ? "J/m" : "J");
  findings.push_back(at_most("energy open", 100 * open, {5, 20}, format_text("%.2g %% ", 100 * open) + of_whole,
                             "loads and flow are not in balance by so much; shorter -time_step, more -grid_cells"));
  if (advection > 0)
    findings.push_back(at_most("numerical dissipation", 100 * advection, {10},
                               format_text("%.2g %% ", 100 * advection) + of_whole,
                               "the advection scheme takes so much of the work in place of eddies and layers that the "
                               "cells do not resolve; more -grid_cells"));
  if (mask > 0)
    findings.push_back(at_most("energy lost at moving walls", 100 * mask, {10, 50},
                               format_text("%.2g %% ", 100 * mask) + of_whole,
                               "shorter -time_step, more -grid_cells, -body_method direct_forcing"));
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

void add_steps(const QuantityList& quantities, double dt, double time_cfl, bool keeps_volume, Findings& findings) {
  const double courant = quantities.summary_value("/max_cfl");
  findings.push_back(at_most("CFL number", courant, {0.8}, format_text("at most %.3g", courant),
                             std::string("the advection scheme gains energy there; ") +
                                 (time_cfl > 0 && time_cfl <= 0.5 ? "smaller -time_cfl" : "-time_cfl 0.5")));
  if (!keeps_volume) return;
  const double change = dt * quantities.summary_value("/max_divergence");
  findings.push_back(at_most("volume", change, {1e-6, 1e-3}, format_text("kept to %.2g a step", change),
                             "water is made or lost; smaller -pressure_tolerance"));
}

// y+ is measured where eddies are modelled. With a law of the wall no y+ is too large.
template <int Dim>
void add_walls(const Liquid<Dim>& liquid, const QuantityList& quantities, Findings& findings) {
  const double plus = quantities.summary_value("/max_wall_y_plus");
  if (plus == 0 || liquid.walls()) return;
  findings.push_back(
      at_most("y+ at the sides", plus, {5}, format_text("at most %.3g in the first cell", plus),
              "friction of the box's sides is not resolved; more -grid_cells, or -wall_model equilibrium"));
}

template <int Dim>
void add_cloth(const Model<Dim>& model, const QuantityList& quantities, const std::string& name, Findings& findings) {
  const std::string pointer = "/cloths/" + name;
  const double stretch = quantities.summary_value(pointer + "/max_stretch");
  findings.push_back(at_most(name + " stretch", 100 * stretch, {5, 20}, format_text("%.2g %% at most", 100 * stretch),
                             "no fabric stretches as much; stiffer -" + name + "_ke, shorter -time_step"));
  if (model.body_list.empty()) return;
  const double depth = quantities.summary_value(pointer + "/max_depth"),
               cells = depth / model.grid.spacing().minCoeff();
  findings.push_back(
      at_most(name + " depth in bodies", cells, {0.5, 2}, format_text("%.2g m, %.2g cells", depth, cells),
              "cloth goes through walls; -contact barrier, or larger -contact_pressure, shorter -time_step"));
}

template <int Dim>
void add_crossings(const Model<Dim>& model, const QuantityList& quantities, Findings& findings) {
  if (Dim == 2 || model.cloths.pieces().size() < 2) return;
  const double crossings = quantities.summary_value("/cloth_crossings");
  const double share = crossings / static_cast<double>(model.cloths.marker_count());
  findings.push_back(at_most("crossings", share, {0, 0.5},
                             format_text("%.0f passages of markers through another cloth, of %d markers", crossings,
                                         static_cast<int>(model.cloths.marker_count())),
                             "cloths pass through each other; turns and stress of the load are wrong by it"));
}

}  // namespace

template <int Dim>
Findings end_findings(const System<Dim>& system, const Measures<Dim>& measures, double time_cfl) {
  const Model<Dim>& model = system.model;
  const QuantityList& quantities = measures.quantities();
  Findings findings;
  if (model.has_fluid) {
    const bool projects = model.fluid.projection().is_on();  // else neither volume nor energy are conserved
    if (projects) add_energy(model, measures.whole_run(), findings);
    add_walls(model.liquid, quantities, findings);
    const Clock& clock = system.state.clock;
    add_steps(quantities, clock.time / static_cast<double>(std::max(1L, clock.step)), time_cfl, projects, findings);
  }
  add_drift(measures.cycles(), findings);
  for (const auto& group : model.cloths.groups()) add_cloth(model, quantities, group.name, findings);
  add_crossings(model, quantities, findings);
  return findings;
}

template Findings end_findings<2>(const System<2>&, const Measures<2>&, double);
template Findings end_findings<3>(const System<3>&, const Measures<3>&, double);

}  // namespace washfsi
