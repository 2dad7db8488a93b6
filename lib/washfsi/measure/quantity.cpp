// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/quantity.hpp"

#include <algorithm>

namespace washfsi {

void QuantityList::add(Quantity quantity, std::vector<CycleFigure> of_cycle) {
  taken_.push_back(0.0);
  double& largest = largest_.emplace_back(0.0);
  if (quantity.accumulation != Accumulation::none)
    keep("largest_" + (quantity.name.empty() ? quantity.summary : quantity.name), {&largest, 1}, IfOther::begin_anew);
  quantities_.push_back(std::move(quantity));
  of_cycle_.push_back(std::move(of_cycle));
}

void QuantityList::keep(const std::string& name, std::span<double> numbers, IfOther if_other) {
  std::string path = name;
  std::replace(path.begin(), path.end(), '/', '_');
  kept_.push_back(numbers_entry("/totals/" + path, numbers));
  kept_.back().if_other = if_other;
}

void QuantityList::accumulate() {
  for (std::size_t n = 0; n < quantities_.size(); ++n) {
    taken_[n] = quantities_[n].value();
    if (quantities_[n].accumulation != Accumulation::none) largest_[n] = std::max(largest_[n], taken_[n]);
  }
}

double QuantityList::shown(std::size_t n) const {
  return quantities_[n].accumulation == Accumulation::largest_so_far ? largest_[n] : taken_[n];
}

void QuantityList::register_state(StateList& state) {
  for (const StateEntry& entry : kept_) state.add(entry);
  state.add(numbers_entry("/measured", taken_)).if_other = IfOther::begin_anew;
}

std::vector<CycleFigure> QuantityList::cycle_figures() const {
  std::vector<CycleFigure> figures;
  for (const auto& of_one : of_cycle_) figures.insert(figures.end(), of_one.begin(), of_one.end());
  return figures;
}

std::vector<double> QuantityList::cycle_values() const {
  std::vector<double> values;
  for (std::size_t n = 0; n < quantities_.size(); ++n) values.insert(values.end(), of_cycle_[n].size(), taken_[n]);
  return values;
}

std::vector<Column> QuantityList::columns() const {
  std::vector<Column> columns;
  for (const Quantity& quantity : quantities_)
    if (!quantity.name.empty()) columns.push_back({quantity.name, quantity.unit});
  return columns;
}

std::vector<double> QuantityList::row() const {
  std::vector<double> row;
  for (std::size_t n = 0; n < quantities_.size(); ++n)
    if (!quantities_[n].name.empty()) row.push_back(shown(n));
  return row;
}

std::vector<QuantityList::SummaryEntry> QuantityList::summary() const {
  std::vector<SummaryEntry> entries;
  for (std::size_t n = 0; n < quantities_.size(); ++n) {
    const Quantity& quantity = quantities_[n];
    if (quantity.summary.empty()) continue;
    const bool of_run = quantity.accumulation != Accumulation::none;
    entries.push_back({quantity.summary, of_run ? largest_[n] : taken_[n], quantity.is_count});
  }
  return entries;
}

double QuantityList::summary_value(const std::string& pointer) const {
  for (const SummaryEntry& entry : summary())
    if (entry.pointer == pointer) return entry.value;
  return 0;
}

std::string QuantityList::document() const {
  std::string text = "| column | unit | meaning |\n|---|---|---|\n";
  for (const Quantity& quantity : quantities_)
    if (!quantity.name.empty())
      text += "| `" + quantity.name + "` | " + quantity.unit + " | " + quantity.meaning + " |\n";
  return text;
}

}  // namespace washfsi
