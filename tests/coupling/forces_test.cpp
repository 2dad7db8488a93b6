// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"
#include "washfsi/support/of_all_ranks.hpp"
#include "washfsi/support/point_vectors.hpp"

namespace washfsi::test {
namespace {

/// A spring between two markers of one fibre: at first between the 3rd and the 12th, later between the 5th and the
/// 18th.
class ChangingSpring : public MarkerForce<2> {
 public:
  ChangingSpring(const Cloths<2>& cloths, double stiffness, double change)
      : cloths_(cloths), stiffness_(stiffness), change_(change) {}

  ForceKind kind() const override { return {.dependence = Dependence::potential}; }
  std::string origin() const override { return "a test"; }
  void begin_step(const StepStart<2>& start) override { changed_ = start.time > change_; }
  void add_force(const Points<2>& positions, const Points<2>&, Points<2>& forces) const override {
    const Points<2> all = of_all_ranks(PETSC_COMM_WORLD, positions);
    add_to_ends(-stiffness_ * (all[ends()[1]] - all[ends()[0]]), forces);
  }
  void add_energy(const Points<2>& positions, std::span<double> of_groups) const override {
    const Points<2> all = of_all_ranks(PETSC_COMM_WORLD, positions);
    if (cloths_.begin() == 0) of_groups[0] += 0.5 * stiffness_ * (all[ends()[1]] - all[ends()[0]]).squaredNorm();
  }
  void add_force_rates(const Points<2>&, const Points<2>& direction, Points<2>& rates) const override {
    const Points<2> all = of_all_ranks(PETSC_COMM_WORLD, direction);
    add_to_ends(-stiffness_ * (all[ends()[1]] - all[ends()[0]]), rates);
  }
  void visit_stiffness(const Points<2>&, GeometricStiffness, const AddMarkerBlock<2>& add) const override {
    const StiffnessBlock<2> block = stiffness_ * StiffnessBlock<2>::Identity();
    for (const std::size_t row : ends())
      for (const std::size_t column : ends())
        if (owns(row)) add(static_cast<PetscInt>(row), static_cast<PetscInt>(column), row == column ? block : -block);
  }
  long pattern() const override { return changed_ ? 1 : 0; }

 private:
  std::array<std::size_t, 2> ends() const {
    return changed_ ? std::array<std::size_t, 2>{4, 17} : std::array<std::size_t, 2>{2, 11};
  }
  bool owns(std::size_t marker) const {
    const auto number = static_cast<PetscInt>(marker);
    return number >= cloths_.begin() && number < cloths_.end();
  }
  // The force on the second end; the opposite on the first.
  void add_to_ends(const Point<2>& force, Points<2>& forces) const {
    for (std::size_t end = 0; end < 2; ++end)
      if (owns(ends()[end]))
        forces[ends()[end] - static_cast<std::size_t>(cloths_.begin())] += (end == 1 ? 1 : -1) * force;
  }

  const Cloths<2>& cloths_;
  double stiffness_, change_;
  bool changed_ = false;
};

constexpr double change = 0.004;

CaseOptions<2> fibre_with_spring() {
  CaseOptions<2> options = fibre_in_water(0.093, 0);
  options.model.surrounding_forces.emplace_back(
      [](const Surroundings<2>& around) { return std::make_unique<ChangingSpring>(around.cloths, 20.0, change); });
  return options;
}

void begin_step(System<2>& system, double time) {
  system.model.forces.begin_step({system.state.positions, system.state.velocities, time, 0});
}

// Minus the gradient of the energies, along a direction.
TEST(Forces, OfAllKindsAreTheGradientOfTheirEnergies) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_with_spring(), {});
  disturb(*system, 0.004);
  const Forces<2>& forces = system->model.forces;
  const Points<2>& x = system->state.positions;
  Points<2> direction(x.size());
  for (std::size_t m = 0; m < x.size(); ++m) direction[m] = {std::sin(900 * x[m][0]), std::cos(700 * x[m][0])};
  for (const double time : {0.0, 2 * change}) {
    begin_step(*system, time);
    constexpr double step = 1e-6;
    const double slope =
        (forces.energies(x + step * direction)[0] - forces.energies(x + (-step) * direction)[0]) / (2 * step);
    double work = 0;
    const Points<2> pushed = forces.of_places(x);
    for (std::size_t m = 0; m < x.size(); ++m) work += pushed[m].dot(direction[m]);
    EXPECT_NEAR(ordered_sum(PETSC_COMM_WORLD, work), -slope, 1e-6 * std::abs(slope));
  }
}

TEST(Forces, LayOutTheirStiffnessAnewWhenOthersMeet) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_with_spring(), {});
  disturb(*system, 0.004);
  Forces<2>& forces = system->model.forces;
  const Points<2>& x = system->state.positions;
  petsc::Matrix matrix;
  begin_step(*system, 0);
  const std::vector<long> before = forces.stiffness().pattern();
  forces.stiffness().lay_out(matrix);
  begin_step(*system, 2 * change);
  EXPECT_NE(forces.stiffness().pattern(), before);
  forces.stiffness().lay_out(matrix);
  forces.stiffness().set(x, GeometricStiffness::all, 1, matrix);
  petsc::Vector direction, product;
  WASH_PETSC(MatCreateVecs(matrix, direction.put(), product.put()));
  WASH_PETSC(VecSetRandom(direction, nullptr));
  WASH_PETSC(MatMult(matrix, direction, product));
  const Points<2> expected = forces.stiffness().product(x, to_points<2>(direction)), found = to_points<2>(product);
  double largest = 0;
  for (const auto& value : expected) largest = std::max(largest, value.norm());
  for (std::size_t m = 0; m < x.size(); ++m) EXPECT_LE((found[m] - expected[m]).norm(), 1e-12 * largest);
}

Points<2> places_with(const std::string& scheme, Mobility mobility, int steps) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_with_spring(), {});
  disturb(*system, 1e-3);
  CouplingOptions options;
  options.scheme = scheme;
  options.mobility = mobility;
  options.order = 1;
  options.tolerance = 1e-9;
  const auto coupling = make_coupling_scheme<2>(options, *system);
  for (int n = 0; n < steps; ++n) coupling->advance(*system, 2 * change / steps);
  return of_all_ranks(PETSC_COMM_WORLD, system->state.positions);
}

// The spring pulls its ends by some millimetres; the couplings may differ by what their first order leaves.
TEST(Forces, ThatChangeWhatTheyJoinMoveTheClothAlikeInEveryCoupling) {
  const Points<2> explicitly = places_with("explicit", Mobility::matrix, 160);
  for (const Mobility mobility : {Mobility::matrix, Mobility::row_sums}) {
    const Points<2> implicitly = places_with("semi_implicit", mobility, 160);
    for (std::size_t m = 0; m < explicitly.size(); ++m) EXPECT_LE((implicitly[m] - explicitly[m]).norm(), 1e-4);
  }
  EXPECT_GT((explicitly[4] - places_with("explicit", Mobility::matrix, 80)[4]).norm(), 0);
}

}  // namespace
}  // namespace washfsi::test
