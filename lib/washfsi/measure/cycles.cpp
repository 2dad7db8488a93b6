// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/cycles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace washfsi {

namespace {

constexpr double rounding = 1e-6;  // tolerance in steps

}  // namespace

Cycles::Cycles(QuantityList& quantities, double period, const std::string& name)
    : period_(period),
      quantities_(quantities),
      current_(quantities.cycle_figures()),
      means_(current_.figures().size()) {
  const std::array<std::pair<const char*, double*>, 7> numbers{{{"_period", &kept_period_},
                                                                {"_figures", &kept_figures_},
                                                                {"_number", &number_},
                                                                {"_is_whole", &is_whole_},
                                                                {"_elapsed", &current_.kept_elapsed()},
                                                                {"_told", &told_},
                                                                {"_counted", &means_.kept_count()}}};
  for (const auto& [part, number] : numbers) quantities.keep(name + part, {number, 1});
  const auto keep = [&](const auto& of_figures) {
    for (const auto& [part, values] : of_figures)
      quantities.keep(name + part, values, QuantityList::IfOther::begin_anew);
  };
  keep(current_.kept());
  keep(means_.kept());
}

void Cycles::begin(double time) {
  const auto count = static_cast<double>(figures().size());
  if (!are_there() || (kept_period_ == period_ && kept_figures_ == count)) return;
  kept_period_ = period_;
  kept_figures_ = count;
  forget_means();
  told_ = 0;
  current_.take(quantities_.cycle_values());
  const double number = std::floor(time / period_ + rounding);
  enter(number, time <= start_of(number) + rounding * period_);
}

void Cycles::forget_means() {
  is_whole_ = 0;
  means_.forget();
}

void Cycles::enter(double number, bool is_whole) {
  number_ = number;
  is_whole_ = is_whole ? 1 : 0;
  current_.begin();
}

void Cycles::observe(double time, double interval) {
  if (!are_there() || interval == 0) return;
  const double middle = time - 0.5 * interval, tiny = rounding * interval;
  if (middle >= start_of(number_ + 1)) complete(time - interval, middle);
  current_.take(quantities_.cycle_values());
  current_.add(interval);
  if (time >= start_of(number_ + 1) - tiny) complete(time, time);
}

void Cycles::complete(double end, double next_time) {
  const double next = std::max(number_ + 1, std::floor(next_time / period_ + rounding));
  if (is_whole_ == 1 && current_.elapsed() > 0) {
    Row row{static_cast<long>(number_) + 1, end - current_.elapsed(), end, so_far()};
    told_ = static_cast<double>(row.number);
    if (row.number >= first_in_means) means_.add(row.values);
    completed_.push_back(std::move(row));
  }
  enter(next, next == number_ + 1);
}

std::vector<Cycles::Row> Cycles::take_completed() {
  return std::exchange(completed_, {});
}

std::string Cycles::document() const {
  std::string text = "| column | unit | meaning |\n|---|---|---|\n";
  for (const CycleFigure& figure : figures())
    text += "| `" + figure.name + "` | " + figure.unit + " | " + figure.meaning + " |\n";
  return text;
}

}  // namespace washfsi
