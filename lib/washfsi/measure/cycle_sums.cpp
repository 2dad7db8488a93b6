// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/cycle_sums.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

namespace {

const CycleFigure* first_with_balance(const std::vector<CycleFigure>& figures, int balance) {
  const auto found = std::ranges::find(figures, balance, &CycleFigure::balance);
  return found == figures.end() ? nullptr : &*found;
}

}  // namespace

CycleSums::CycleSums(std::vector<CycleFigure> of_quantities) : figures_(std::move(of_quantities)) {
  if (const CycleFigure* work = first_with_balance(figures_, 1))
    figures_.push_back({"energy_open", work->unit, OverCycle::integral,
                        "what was put in and is neither kept nor lost where it is measured: what the scheme lost, or "
                        "what passed through sides that are open or move"});
  for (auto* values : {&sums_, &before_, &last_}) values->assign(figures_.size(), 0.0);
}

void CycleSums::take(const std::vector<double>& values) {
  std::ranges::copy(values, last_.begin());
}

void CycleSums::begin() {
  elapsed_ = 0;
  std::ranges::copy(last_, before_.begin());
  std::ranges::fill(sums_, 0.0);
}

void CycleSums::add(double interval) {
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

double CycleSums::of_cycle(std::size_t n) const {
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

std::vector<double> CycleSums::so_far() const {
  std::vector<double> values;
  double open = 0;
  for (std::size_t n = 0; n < figures_.size(); ++n) {
    values.push_back(of_cycle(n));
    open += figures_[n].balance * values.back();
  }
  if (first_with_balance(figures_, 1)) values.back() = open;
  return values;
}

std::array<std::pair<const char*, std::span<double>>, 3> CycleSums::kept() {
  return {{{"_sums", sums_}, {"_before", before_}, {"_last", last_}}};
}

}  // namespace washfsi
