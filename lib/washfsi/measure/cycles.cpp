// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/cycles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace washfsi {

namespace {

constexpr double rounding = 1e-6;  // tolerance in steps

const CycleFigure* first_with_balance(const std::vector<CycleFigure>& figures, int balance) {
  const auto found = std::ranges::find(figures, balance, &CycleFigure::balance);
  return found == figures.end() ? nullptr : &*found;
}

}  // namespace

Cycles::Cycles(QuantityList& quantities, double period, const std::string& name)
    : period_(period), quantities_(quantities), figures_(quantities.cycle_figures()) {
  if (const CycleFigure* work = first_with_balance(figures_, 1))
    figures_.push_back({"energy_open", work->unit, OverCycle::integral,
                        "what was put in and is neither kept nor lost where it is measured: what the scheme lost, or "
                        "what passed through sides that are open or move"});
  const std::array<std::pair<const char*, double*>, 7> numbers{{{"_period", &kept_period_},
                                                                {"_figures", &kept_figures_},
                                                                {"_number", &number_},
                                                                {"_is_whole", &is_whole_},
                                                                {"_elapsed", &elapsed_},
                                                                {"_told", &told_},
                                                                {"_counted", &counted_}}};
  for (const auto& [part, number] : numbers) quantities.keep(name + part, {number, 1});
  const std::array<std::pair<const char*, std::vector<double>*>, 5> of_figures{
      {{"_sums", &sums_}, {"_before", &before_}, {"_last", &last_}, {"_means", &means_}, {"_squares", &squares_}}};
  for (const auto& [part, values] : of_figures) {
    values->assign(figures_.size(), 0.0);
    quantities.keep(name + part, *values, QuantityList::IfOther::begin_anew);
  }
}

void Cycles::begin(double time) {
  const auto figures = static_cast<double>(figures_.size());
  if (!are_there() || (kept_period_ == period_ && kept_figures_ == figures)) return;
  kept_period_ = period_;
  kept_figures_ = figures;
  forget_means();
  told_ = 0;
  take_values();
  const double number = std::floor(time / period_ + rounding);
  enter(number, time <= start_of(number) + rounding * period_);
}

void Cycles::forget_means() {
  counted_ = is_whole_ = 0;
  std::ranges::fill(means_, 0.0);
  std::ranges::fill(squares_, 0.0);
}

void Cycles::take_values() {
  std::ranges::copy(quantities_.cycle_values(), last_.begin());
}

void Cycles::enter(double number, bool is_whole) {
  number_ = number;
  is_whole_ = is_whole ? 1 : 0;
  elapsed_ = 0;
  std::ranges::copy(last_, before_.begin());
  std::ranges::fill(sums_, 0.0);
}

void Cycles::observe(double time, double interval) {
  if (!are_there() || interval == 0) return;
  const double middle = time - 0.5 * interval, tiny = rounding * interval;
  if (middle >= start_of(number_ + 1)) complete(time - interval, middle);
  take_values();
  add(interval);
  if (time >= start_of(number_ + 1) - tiny) complete(time, time);
}

void Cycles::add(double interval) {
  elapsed_ += interval;
  for (std::size_t n = 0; n < figures_.size(); ++n) {
    const double value = last_[n];
    switch (figures_[n].over) {
      case OverCycle::mean:
      case OverCycle::integral:
        sums_[n] += interval * value;
        break;
      case OverCycle::rms:
        sums_[n] += interval * value * value;
        break;
      case OverCycle::peak:
        sums_[n] = std::max(sums_[n], std::abs(value));
        break;
      case OverCycle::change:
        break;
    }
  }
}

double Cycles::of_cycle(std::size_t n) const {
  switch (figures_[n].over) {
    case OverCycle::mean:
      return elapsed_ > 0 ? sums_[n] / elapsed_ : 0;
    case OverCycle::rms:
      return elapsed_ > 0 ? std::sqrt(sums_[n] / elapsed_) : 0;
    case OverCycle::change:
      return last_[n] - before_[n];
    default:
      return sums_[n];
  }
}

std::vector<double> Cycles::so_far() const {
  std::vector<double> values;
  double open = 0;
  for (std::size_t n = 0; n < figures_.size(); ++n) {
    values.push_back(of_cycle(n));
    open += figures_[n].balance * values.back();
  }
  if (first_with_balance(figures_, 1)) values.back() = open;
  return values;
}

void Cycles::complete(double end, double next_time) {
  const double next = std::max(number_ + 1, std::floor(next_time / period_ + rounding));
  if (is_whole_ == 1 && elapsed_ > 0) {
    Row row{static_cast<long>(number_) + 1, end - elapsed_, end, so_far()};
    told_ = static_cast<double>(row.number);
    if (row.number >= first_in_means) count(row.values);
    completed_.push_back(std::move(row));
  }
  enter(next, next == number_ + 1);
}

// Welford's update of mean and spread.
void Cycles::count(const std::vector<double>& values) {
  ++counted_;
  for (std::size_t n = 0; n < values.size(); ++n) {
    const double off = values[n] - means_[n];
    means_[n] += off / counted_;
    squares_[n] += off * (values[n] - means_[n]);
  }
}

Cycles::Mean Cycles::mean(std::size_t figure) const {
  const double deviation = counted_ > 1 ? std::sqrt(squares_[figure] / (counted_ - 1)) : 0.0;
  return {means_[figure], deviation};
}

std::vector<Cycles::Row> Cycles::take_completed() {
  return std::exchange(completed_, {});
}

std::string Cycles::document() const {
  std::string text = "| column | unit | meaning |\n|---|---|---|\n";
  for (const CycleFigure& figure : figures_)
    text += "| `" + figure.name + "` | " + figure.unit + " | " + figure.meaning + " |\n";
  return text;
}

}  // namespace washfsi
