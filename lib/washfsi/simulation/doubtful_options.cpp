// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/doubtful_options.hpp"

#include <algorithm>

namespace washfsi {

namespace {

// Cases in units of their own have another density.
template <int Dim>
void warn_of_units(Options& options, const ModelOptions<Dim>& model) {
  constexpr double lightest = 900, heaviest = 1100;            // [kg/m3]
  constexpr double most_gravity = 100, most_excess_mass = 20;  // [m/s2, kg/m2]
  if (model.medium == Medium::none || model.fluid.density < lightest || model.fluid.density > heaviest) return;
  if (model.gravity.norm() > most_gravity)
    options.warn("-gravity " + list_text<Dim>(model.gravity) + ": ten times the earth's and more; it is in m/s2");
  for (const auto& group : model.cloths)
    if (group.excess_mass > most_excess_mass)
      options.warn("-" + group.name + "_excess_mass " + to_text(group.excess_mass) +
                   ": no fabric is so heavy; it is in kg/m2");
}

template <int Dim>
void warn_of_axis(Options& options, const PhaseOptions& phases, const std::vector<Body<Dim>>& bodies) {
  constexpr int z = 2;
  if (phases.count == 0 || phases.axis == z) return;
  for (const auto& body : bodies)
    if (body.motion.largest_speed(1) > body.motion.largest_speed(0)) {
      options.warn("-statistics_phase_axis " + std::string(1, "xyz"[phases.axis]) + ": body " + body.name +
                   " turns about z");
      return;
    }
}

}  // namespace

template <int Dim>
void warn_of_doubtful_options(Options& options, const CaseOptions<Dim>& chosen, const std::vector<Body<Dim>>& bodies) {
  if (options.help()) return;
  warn_of_units<Dim>(options, chosen.model);
  warn_of_axis<Dim>(options, chosen.measure.phases, bodies);
}

template <int Dim>
void warn_of_short_spans(Options& options, const Measures<Dim>& measures, double step) {
  constexpr double fewest_steps = 10;
  const Cycles& cycles = measures.cycles();
  if (cycles.are_there() && cycles.period() < fewest_steps * step * (1 - 1e-9))
    options.warn("-cycle_time: cycles of " + to_text(cycles.period()) + " s are shorter than ten steps of " +
                 to_text(step) + " s; their figures mean little");
  const PhaseStatistics* phases = measures.phases();
  if (phases && phases->count() > 1 &&
      phases->options().period < static_cast<double>(phases->count()) * step * (1 - 1e-9))
    options.warn("-statistics_phases " + std::to_string(phases->count()) + ": phases of a period of " +
                 to_text(phases->options().period) + " s are shorter than steps of " + to_text(step) +
                 " s; some get no sample");
}

template void warn_of_short_spans<2>(Options&, const Measures<2>&, double);
template void warn_of_short_spans<3>(Options&, const Measures<3>&, double);
template void warn_of_doubtful_options<2>(Options&, const CaseOptions<2>&, const std::vector<Body<2>>&);
template void warn_of_doubtful_options<3>(Options&, const CaseOptions<3>&, const std::vector<Body<3>>&);

}  // namespace washfsi
