// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/pair_distances.hpp"

#include <algorithm>

#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi {

namespace {

constexpr double least = 0.01;  // least share of the usual distance: things that start nearer are pushed apart

PairDistances::Nearest of_all(MPI_Comm comm, const PairDistances::Nearest& nearest) {
  struct Item {
    std::size_t one, other;
    double distance;
  };
  std::vector<Item> items;
  for (const auto& [pair, distance] : nearest) items.push_back({pair.first, pair.second, distance});
  PairDistances::Nearest all;
  for (const Item& item : of_all_ranks(comm, items)) note(all, item.one, item.other, item.distance);
  return all;
}

}  // namespace

void PairDistances::start(MPI_Comm comm, const Nearest& nearest) {
  has_started_ = true;
  less_ = of_all(comm, nearest);
  std::erase_if(less_, [this](const auto& item) { return item.second >= usual_; });
  for (auto& [pair, distance] : less_) distance = std::max(distance, least * usual_);
}

void PairDistances::follow(MPI_Comm comm, const Nearest& nearest, double beyond) {
  if (less_.empty()) return;
  const Nearest now = of_all(comm, nearest);
  for (auto& [pair, distance] : less_) {
    const auto place = now.find(pair);
    distance = std::max(distance, place == now.end() ? distance + beyond : place->second);
  }
  std::erase_if(less_, [this](const auto& item) { return item.second >= usual_; });
}

std::vector<double> PairDistances::stored() const {
  std::vector<double> numbers;
  if (!has_started_) return numbers;
  for (const auto& [pair, distance] : less_)
    numbers.insert(numbers.end(), {static_cast<double>(pair.first), static_cast<double>(pair.second), distance});
  numbers.push_back(usual_);
  return numbers;
}

void PairDistances::restore(const std::vector<double>& stored) {
  has_started_ = true;
  less_.clear();
  for (std::size_t n = 0; n + 2 < stored.size(); n += 3)
    less_[{static_cast<std::size_t>(stored[n]), static_cast<std::size_t>(stored[n + 1])}] = stored[n + 2];
}

}  // namespace washfsi
