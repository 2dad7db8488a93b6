// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/cloth_measure.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/coupling/step_error.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Mean over the cloths of a group, which are equal. `sum` is the initial zero.
template <int Dim, class Value>
Value mean_over_cloths(const Cloths<Dim>& cloths, std::size_t group, const std::vector<Value>& values, Value sum) {
  for (std::size_t p = 0; p < values.size(); ++p)
    if (cloths.pieces()[p].group == group) sum += values[p];
  return sum / static_cast<double>(cloths.groups()[group].count);
}

}  // namespace

template <int Dim>
ClothMeasure<Dim>::ClothMeasure(const System<Dim>& system, const MachineAxis& machine, BodyDepths<Dim>& depths)
    : system_(system),
      groups_(system.model.cloths.groups().size()),
      means_(system.model.cloths),
      centers_(system.model.cloths.pieces().size(), Point<Dim>::Zero()),
      paths_(centers_.size()),
      time_integrals_(marker_quantities<Dim>().size() * system.model.cloths.owned(), 0.0),
      depths_(depths) {
  if constexpr (Dim == 3) {
    if (groups_.empty()) return;
    tumbles_.emplace(machine.axis, machine.orbit_center, centers_.size());
    crossings_.emplace(system.model.cloths);
  }
}

template <int Dim>
void ClothMeasure<Dim>::declare(QuantityList& quantities) {
  if (groups_.empty()) return;
  declare_all(quantities);
  for (std::size_t g = 0; g < groups_.size(); ++g) declare_group(quantities, g);
}

template <int Dim>
void ClothMeasure<Dim>::declare_all(QuantityList& quantities) {
  quantities.add(
      {"cloth_slip", "-", "rms difference of the velocities of cloth and water over the rms speed of the cloth",
       [this] { return system_.step.cloth_slip; }},
      {{"cloth_slip", "-", OverCycle::mean, "mean slip of the cloth in the water"}});
  quantities.add(
      {"step_error", "m/s",
       "what the velocities of the cloths err by in a step, rms: their motion less that by the trapezoidal rule",
       [this] { return step_error_; }});
  quantities.keep("averaged_time", {&averaged_time_, 1});
  quantities.keep("paths", paths_.totals());
  quantities.keep("path_ends", paths_.ends());
  if (!crossings_) return;
  quantities.add({"cloth_distance", "m", "least distance of a marker from another cloth, at most half a spacing",
                  [this] { return crossings_->least_distance(); }});
  quantities.add({"cloth_crossings", "-", "passages of markers through another cloth so far",
                  [this] { return crossings_->crossings(); }, Accumulation::none, "/cloth_crossings", true},
                 {{"cloth_crossings", "-", OverCycle::change, "passages of markers through another cloth", 0, true}});
  quantities.keep("crossings", crossings_->state());
  quantities.keep("tumbling_angles", tumbles_->angles());
  quantities.keep("tumbling_turned", tumbles_->turned());
}

template <int Dim>
void ClothMeasure<Dim>::declare_group(QuantityList& quantities, std::size_t g) {
  const std::string& name = system_.model.cloths.groups()[g].name;
  const std::string pointer = "/cloths/" + name;
  const GroupMeasures<Dim>& group = groups_[g];
  quantities.add({name + "_elastic_energy", Units<Dim>::energy, "energy of elasticity and of the holding springs",
                  [&group] { return group.elastic_energy; }},
                 {{name + "_elastic_energy_change", Units<Dim>::energy, OverCycle::change,
                   "energy kept by the cloth and its holding springs", -1}});
  declare_markers(quantities, g);
  quantities.add({name + "_max_stretch", "-", "largest \\|X_s\\| - 1 of any edge so far",
                  [&group] { return group.stretch; }, Accumulation::largest_so_far, pointer + "/max_stretch"},
                 {{name + "_stretch", "-", OverCycle::peak, "largest \\|X_s\\| - 1 of any edge"}});
  quantities.add({name + "_depth", "m", "how deep the deepest face of a cloth reaches into a body; 0 if none does",
                  [&group] { return group.depth; }, Accumulation::largest, pointer + "/max_depth"},
                 {{name + "_depth", "m", OverCycle::peak, "how deep the deepest face of a cloth reaches into a body"}});
  if (tumbles_)
    quantities.add(
        {name + "_tumbles", "-", "turns of a cloth in the plane of radius and height so far, mean",
         [&group] { return group.tumbles; }, Accumulation::none, pointer + "/tumbles"},
        {{name + "_turns", "-", OverCycle::change, "turns of a cloth in the plane of radius and height", 0, true}});
  quantities.add({name + "_path", "m", "way that the centre of a cloth has come so far, mean",
                  [this, g] { return path(g); }, Accumulation::none, pointer + "/path"},
                 {{name + "_path", "m", OverCycle::change, "way that the centre of a cloth came, mean", 0, true}});
  for (int d = 0; d < Dim; ++d)
    quantities.add(
        {name + "_center_" + "xyz"[d], "m", "mean over its cloths", [&group, d] { return group.center[d]; }});
}

// The means over the markers now, and over the run.
template <int Dim>
void ClothMeasure<Dim>::declare_markers(QuantityList& quantities, std::size_t g) {
  const std::string& name = system_.model.cloths.groups()[g].name;
  const GroupMeasures<Dim>& group = groups_[g];
  const auto& all = marker_quantities<Dim>();
  for (std::size_t n = 0; n < all.size(); ++n) {
    const std::string pointer = "/cloths/" + name + "/" + all[n].name;
    std::vector<CycleFigure> figures;
    if (all[n].of_cycle)
      figures.push_back({name + "_" + all[n].name, all[n].unit, OverCycle::mean,
                         std::string("mean over markers and time: ") + all[n].meaning, 0, true});
    quantities.add({name + "_" + all[n].name + "_mean", all[n].unit,
                    std::string("mean over the markers: ") + all[n].meaning, [&group, n] { return group.now[n]; }},
                   figures);
    quantities.add({"", all[n].unit, "mean over time and markers", [&group, n] { return group.mean[n]; },
                    Accumulation::none, pointer + "_mean"});
    quantities.add({"", all[n].unit, "standard deviation over the markers of the mean over time",
                    [&group, n] { return group.deviation[n]; }, Accumulation::none, pointer + "_std"});
  }
}

template <int Dim>
double ClothMeasure<Dim>::elastic_energy() const {
  double energy = 0;
  for (const auto& group : groups_) energy += group.elastic_energy;
  return energy;
}

template <int Dim>
void ClothMeasure<Dim>::observe(const Observation<Dim>& seen) {
  if (groups_.empty()) return;
  step_error_ = step_error(system_);
  measure_markers(seen.interval);
  const Points<Dim>& positions = system_.state.positions;
  const std::vector<double> energies = system_.model.forces.elastic_energies(positions);
  const std::vector<double> stretches = largest_stretches(system_.model.cloths, positions);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].elastic_energy = energies[g];
    groups_[g].stretch = stretches[g];
  }
  measure_places();
  if (seen.interval > 0 || system_.state.clock.step == 0) paths_.observe(centers_);
  measure_depths();
  if constexpr (Dim == 3) measure_laundry();
}

template <int Dim>
void ClothMeasure<Dim>::measure_markers(double interval) {
  averaged_time_ += interval;
  const double time = averaged_time_ > 0 ? averaged_time_ : 1;
  std::vector<double> values, averages, squares;
  for (const MarkerSample& sample : marker_samples(system_))
    for (const auto& quantity : marker_quantities<Dim>()) values.push_back(quantity.value(sample));
  for (std::size_t n = 0; n < values.size(); ++n) {
    time_integrals_[n] += interval * values[n];
    averages.push_back(time_integrals_[n] / time);
    squares.push_back(averages[n] * averages[n]);
  }
  const std::size_t each = marker_quantities<Dim>().size();
  const auto now = means_.of_groups(values, each), means = means_.of_groups(averages, each),
             mean_squares = means_.of_groups(squares, each);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].now = now[g];
    groups_[g].mean = means[g];
    groups_[g].deviation.clear();
    for (std::size_t n = 0; n < means[g].size(); ++n)
      groups_[g].deviation.push_back(std::sqrt(std::max(0.0, mean_squares[g][n] - means[g][n] * means[g][n])));
  }
}

template <int Dim>
void ClothMeasure<Dim>::measure_laundry() {
  if constexpr (Dim == 3) {
    tumbles_->observe(centers_);
    const std::vector<double> turns = tumbles_->turns();
    for (std::size_t g = 0; g < groups_.size(); ++g)
      groups_[g].tumbles = mean_over_cloths(system_.model.cloths, g, turns, 0.0);
    crossings_->observe(system_.state.positions);
  }
}

template <int Dim>
double ClothMeasure<Dim>::path(std::size_t group) const {
  const std::span<const double> totals = paths_.totals();
  return mean_over_cloths(system_.model.cloths, group, std::vector<double>(totals.begin(), totals.end()), 0.0);
}

template <int Dim>
void ClothMeasure<Dim>::measure_places() {
  for (int d = 0; d < Dim; ++d) {
    std::vector<double> coordinate;
    for (const auto& position : system_.state.positions) coordinate.push_back(position[d]);
    const std::vector<double> means = means_.of_cloths(coordinate);
    for (std::size_t p = 0; p < centers_.size(); ++p) centers_[p][d] = means[p];
  }
  for (std::size_t g = 0; g < groups_.size(); ++g)
    groups_[g].center = mean_over_cloths<Dim, Point<Dim>>(system_.model.cloths, g, centers_, Point<Dim>::Zero());
}

template <int Dim>
void ClothMeasure<Dim>::measure_depths() {
  depths_.look(system_.state.positions, system_.state.clock.time);
  for (std::size_t g = 0; g < groups_.size(); ++g) groups_[g].depth = depths_.of_groups()[g];
}

template <int Dim>
std::vector<MarkerField> ClothMeasure<Dim>::marker_fields() const {
  const std::vector<MarkerSample> samples = marker_samples(system_);
  std::vector<MarkerField> fields;
  for (const MarkerQuantity& quantity : marker_quantities<Dim>()) {
    MarkerField& field = fields.emplace_back(MarkerField{quantity.name, quantity.unit, {}});
    for (const MarkerSample& sample : samples) field.values.push_back(quantity.value(sample));
  }
  return fields;
}

template <int Dim>
std::vector<Column> ClothMeasure<Dim>::track_columns() const {
  std::vector<Column> columns{{"step", "-"}, {"time", "s"}};
  for (const auto& group : system_.model.cloths.groups())
    for (PetscInt cloth = 0; cloth < group.count; ++cloth)
      for (int d = 0; d < Dim; ++d) columns.push_back({group.name + "_" + std::to_string(cloth) + "_" + "xyz"[d], "m"});
  return columns;
}

template <int Dim>
std::vector<double> ClothMeasure<Dim>::track_row() const {
  std::vector<double> row{system_.state.clock.time};
  for (const auto& center : centers_) row.insert(row.end(), center.data(), center.data() + Dim);
  return row;
}

template <int Dim>
void ClothMeasure<Dim>::register_state(StateList& state) {
  state.add({.name = "/cloth/time_integrals",
             .slab = system_.model.cloths.slab(static_cast<int>(marker_quantities<Dim>().size())),
             .get = [this] { return time_integrals_; },
             .set = [this](StateEntry::Values values) { time_integrals_ = std::move(values); }});
}

template class ClothMeasure<2>;
template class ClothMeasure<3>;

}  // namespace washfsi
