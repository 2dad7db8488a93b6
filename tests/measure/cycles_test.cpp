// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/cycles.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/hand_over.hpp"

namespace washfsi::test {
namespace {

// A motor's power, what is lost and what is kept, over cycles of 1 s.
struct Machine {
  explicit Machine(double period = 1) {
    list.add({"power", "W", "", [this] { return power; }}, {{"work", "J", OverCycle::integral, "", 1},
                                                            {"mean", "W", OverCycle::mean, ""},
                                                            {"peak", "W", OverCycle::peak, ""},
                                                            {"rms", "W", OverCycle::rms, ""}});
    list.add({"loss", "W", "", [this] { return loss; }}, {{"lost", "J", OverCycle::integral, "", -1}});
    list.add({"energy", "J", "", [this] { return energy; }}, {{"kept", "J", OverCycle::change, "", -1}});
    cycles.emplace(list, period, "cycle");
    list.accumulate();
    cycles->begin(0);
  }

  void step(double dt) {
    const double middle = time + 0.5 * dt;
    time += dt;
    power = 3 * std::sin(7 * middle) - 1;
    loss = 0.5 * std::cos(middle);
    energy += 0.25 * dt * (power - loss);
    list.accumulate();
    cycles->observe(time, dt);
    for (auto& row : cycles->take_completed()) rows.push_back(row);
  }
  // Unevenly.
  void run_to(double end) {
    for (long n = 0; time < end - 1e-9; ++n) step(std::min(n % 3 == 0 ? 0.013 : 0.017, end - time));
  }
  // As a restart does.
  void go_on_from(Machine& other) {
    time = other.time;
    power = other.power, loss = other.loss, energy = other.energy;
    hand_over(other.list, list);
    cycles->begin(time);
  }

  double time = 0, power = 0, loss = 0, energy = 0;
  QuantityList list;
  std::optional<Cycles> cycles;
  std::vector<Cycles::Row> rows;
};

enum Figure : std::size_t { work, mean, peak, rms, lost, kept, open };

TEST(Cycles, CountEachRowOnce) {
  Machine machine;
  double put_in = 0, square = 0, largest = 0, seen = 0;
  const double energy = machine.energy;
  double energy_before = energy;
  while (machine.rows.size() < 3) {
    const double dt = machine.rows.size() == 1 ? 0.011 : 0.019;
    energy_before = machine.energy;
    machine.step(dt);
    put_in += dt * machine.power;
    square += dt * machine.power * machine.power;
    largest = std::max(largest, std::abs(machine.power));
    seen += dt;
  }
  double in_rows = 0, squares = 0, all = 0, peak_of_rows = 0, kept_in_rows = 0;
  for (const auto& row : machine.rows) {
    in_rows += row.values[work];
    all += row.end - row.start;
    squares += row.values[rms] * row.values[rms] * (row.end - row.start);
    peak_of_rows = std::max(peak_of_rows, row.values[peak]);
    kept_in_rows += row.values[kept];
    EXPECT_NEAR(row.values[mean], row.values[work] / (row.end - row.start), 1e-12);
    EXPECT_NEAR(row.values[open], row.values[work] - row.values[lost] - row.values[kept], 1e-12);
    EXPECT_NEAR(row.end, static_cast<double>(row.number), 0.01);
  }
  // the step that ends the last cycle may have begun the next
  const double beyond = seen - all;
  EXPECT_NEAR(beyond * machine.power, put_in - in_rows, 1e-12);
  EXPECT_NEAR(square - squares, beyond * machine.power * machine.power, 1e-12);
  EXPECT_EQ(peak_of_rows, largest);
  EXPECT_NEAR(kept_in_rows, (beyond > 0 ? energy_before : machine.energy) - energy, 1e-12);
}

TEST(Cycles, MeanAndSpreadBeginWithTheSecond) {
  Machine machine;
  machine.run_to(4);
  ASSERT_EQ(machine.rows.size(), 4U);
  ASSERT_EQ(machine.cycles->counted(), 3);
  double sum = 0, squares = 0;
  for (std::size_t n = 1; n < 4; ++n) sum += machine.rows[n].values[work];
  for (std::size_t n = 1; n < 4; ++n) squares += std::pow(machine.rows[n].values[work] - sum / 3, 2);
  EXPECT_NEAR(machine.cycles->mean(work).mean, sum / 3, 1e-12);
  EXPECT_NEAR(machine.cycles->mean(work).deviation, std::sqrt(squares / 2), 1e-12);
}

TEST(Cycles, GoOnFromWhatACheckpointKeepsToTheBit) {
  Machine whole, first, second;
  for (int n = 0; n < 300; ++n) whole.step(0.0137);
  for (int n = 0; n < 200; ++n) first.step(0.0137);
  second.go_on_from(first);
  second.rows = first.rows;
  for (int n = 200; n < 300; ++n) second.step(0.0137);
  ASSERT_EQ(whole.rows.size(), 4U);
  ASSERT_EQ(second.rows.size(), 4U);
  for (std::size_t n = 0; n < 4; ++n) EXPECT_EQ(second.rows[n].values, whole.rows[n].values);
  EXPECT_EQ(second.cycles->mean(rms).deviation, whole.cycles->mean(rms).deviation);
}

TEST(Cycles, OfAnotherPeriodBeginAnewWithTheNextWholeOne) {
  Machine first, second(0.3);
  first.run_to(1.4);
  second.go_on_from(first);
  second.run_to(2.15);
  ASSERT_EQ(second.rows.size(), 2U);  // 1.5 to 1.8, 1.8 to 2.1
  EXPECT_EQ(second.rows[0].number, 6);
  EXPECT_NEAR(second.rows[0].start, 1.5, 0.01);
  EXPECT_NEAR(second.rows[1].end, 2.1, 0.01);
}

TEST(Cycles, MeansBeginAnewWithTheNextWholeOneWhenTheCaseChanges) {
  Machine machine;
  machine.run_to(2.5);
  ASSERT_EQ(machine.cycles->counted(), 1);
  machine.cycles->forget_means();
  machine.run_to(4);
  EXPECT_EQ(machine.cycles->counted(), 1);  // the fourth; the third was seen in part
  ASSERT_EQ(machine.rows.size(), 3U);
  EXPECT_EQ(machine.rows.back().number, 4);
  EXPECT_EQ(machine.cycles->mean(work).mean, machine.rows.back().values[work]);
}

TEST(Cycles, RowsLongerThanACycleAreToldAsTheyAre) {
  Machine machine;
  for (int n = 0; n < 4; ++n) machine.step(2.5);
  for (const auto& row : machine.rows) EXPECT_LE(row.end - row.start, 2.5 + 1e-12);
}

TEST(Cycles, AreNotThereWithoutAPeriod) {
  Machine machine(0);
  machine.run_to(2);
  EXPECT_FALSE(machine.cycles->are_there());
  EXPECT_TRUE(machine.rows.empty());
}

}  // namespace
}  // namespace washfsi::test
