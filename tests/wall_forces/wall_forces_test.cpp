// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_forces/wall_forces.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/wall_forces/marker_loads.hpp"

namespace washfsi::test {
namespace {

constexpr double speed_of_rim = 0.3, radius = 0.15;

/// A disc that turns in water at rest, and others that do not. The water below their middles is `heavy` times as dense
/// as that above.
class Discs {
 public:
  Discs(std::size_t at_rest, double slip_tolerance, double heavy = 1)
      : bodies_(discs(at_rest)),
        grid_(PETSC_COMM_WORLD, shape()),
        boundary_(grid_, {}),
        walls_(grid_, boundary_, bodies_, treatment(slip_tolerance)),
        density_(grid_.face_vector()),
        velocity_(grid_.face_vector()) {
    set_density(heavy);
    walls_.place(0);
    WASH_PETSC(VecZeroEntries(velocity_));
    walls_.begin_trial({0, 0.01}, density_);
  }

  bool reduce_slip() { return walls_.reduce_slip_beyond_tolerance(velocity_, 1); }
  /// Solves for the forces that leave this slip [m/s].
  void solve(double slip, Projection& projection) const {
    NoSlipSolver<2> solver(walls_.markers(), treatment(slip));
    solver.place();
    solver.begin({0, 0.01}, density_);
    (void)solver.solve(solver.slips(velocity_), slip, projection);
  }
  /// Of the disc that turns, root mean square [m/s].
  double slip() const { return slip_of_bodies(walls_.markers(), walls_.markers().water_velocities(velocity_, 0))[0]; }

  /// The largest force on a body's patches.
  double force_on(std::size_t body) {
    walls_.accept();
    double most = 0;
    const PatchRange own = walls_.markers().layout().own();
    for (std::size_t p = own.begin; p < own.end; ++p)
      if (walls_.markers().layout().body_of(p) == body) most = std::max(most, walls_.previous()[p - own.begin].norm());
    return largest(PETSC_COMM_WORLD, most);
  }

 private:
  void set_density(double heavy) {
    const FaceView<2> density(grid_.face_dm(), density_);
    for (int c = 0; c < 2; ++c)
      for_each<2>(grid_.owned(), [&](const Index<2>& face) {
        const double below = (0.52 - grid_.face_center(face, c)[1]) / grid_.spacing()[1];
        density(face, c) = 1 + (heavy - 1) * 0.5 * (1 + std::tanh(below));
      });
  }
  static std::vector<Body<2>> discs(std::size_t at_rest) {
    std::vector<Body<2>> bodies(1 + at_rest);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      bodies[b].shape = std::make_unique<Sphere<2>>(radius);
      bodies[b].motion.center = {0.5 + static_cast<double>(b), 0.52};
    }
    bodies[0].motion.angular_speed = speed_of_rim / radius;
    return bodies;
  }
  static GridShape<2> shape() {
    GridShape<2> shape;
    shape.cells = {160, 40};
    shape.upper = {4, 1};
    return shape;
  }
  static BodyTreatment treatment(double slip_tolerance) {
    BodyTreatment treatment;
    treatment.method = BodyMethod::direct_forcing;
    treatment.slip_tolerance = slip_tolerance;
    return treatment;
  }

  std::vector<Body<2>> bodies_;
  Grid<2> grid_;
  Boundary<2> boundary_;
  WallForces<2> walls_;
  petsc::Vector density_, velocity_;
};

TEST(WallForces, CorrectBodiesBeyondTheToleranceAlone) {
  Discs discs(1, 0.1);
  EXPECT_TRUE(discs.reduce_slip());
  EXPECT_GT(discs.force_on(0), 0);
  EXPECT_EQ(discs.force_on(1), 0);
}

TEST(WallForces, JudgeEachBodyWhateverOthersDo) {
  for (const std::size_t at_rest : {0, 1, 3}) {
    EXPECT_TRUE(Discs(at_rest, 0.8).reduce_slip());
    EXPECT_FALSE(Discs(at_rest, 1.01).reduce_slip());
  }
}

TEST(WallForces, ActBesideABodyWithoutSurfaceInTheBox) {
  Discs discs(4, 0.1);  // the last lies beyond the end
  EXPECT_TRUE(discs.reduce_slip());
  EXPECT_GT(discs.force_on(0), 0);
}

TEST(WallForces, AreAsLargeAsTheWaterAtEachPatchIsDense) {
  Discs alike(0, 1e-3), layered(0, 1e-3, 1000);
  EXPECT_TRUE(alike.reduce_slip());
  EXPECT_TRUE(layered.reduce_slip());
  EXPECT_LT(alike.slip(), 0.3 * speed_of_rim);
  EXPECT_LT(layered.slip(), 1.4 * alike.slip());  // three times it by the least density
}

/// A projection that diverges when it is used for the nth time.
class DivergingProjection : public Projection {
 public:
  explicit DivergingProjection(int uses) : uses_left_(uses) {}
  void project_again() override {}
  void project_increment(Vec) override {
    if (uses_left_-- == 0) throw DivergedError("the projection diverged");
  }

 private:
  int uses_left_;
};

TEST(WallForces, PassOnWhatDivergesWithinTheirSolver) {
  const Discs discs(0, 1e-3);
  for (const int uses : {0, 1}) {
    DivergingProjection projection(uses);
    expect_refusal<DivergedError>([&] { discs.solve(1e-6, projection); }, "the projection diverged");
  }
  DivergingProjection lasting(-1);
  discs.solve(1e-3, lasting);
}

/// The overlaps of the patches of two discs, an inner and a larger one, shared by some ranks.
class Overlaps {
 public:
  explicit Overlaps(MPI_Comm comm)
      : comm_(comm), layout_(layout(comm)), patches_{of_disc(0.3), of_disc(0.4)}, inverse_(patches_, layout_, own()) {}

  /// A vector of the first disc's patches, along x; value(n) is that of the nth round it.
  template <class Value>
  Points<2> round(Value&& value) const {
    std::vector<std::pair<double, std::size_t>> round;
    for (std::size_t p = 0; p < patches_[0].size(); ++p)
      round.emplace_back(std::atan2(patches_[0].middle(p)[1], patches_[0].middle(p)[0]), p);
    std::sort(round.begin(), round.end());
    Points<2> values(count(), Point<2>::Zero());
    for (std::size_t n = 0; n < round.size(); ++n) values[round[n].second] = Point<2>(value(n), 0);
    return values;
  }
  /// Their means, and the forces that they need, on the patches of all ranks; given those of all.
  Points<2> means(const Points<2>& values) const { return whole(inverse_.means_about(part(values))); }
  Points<2> forces(const Points<2>& values) const { return whole(inverse_(part(values))); }

  /// Of the first disc's, root mean square.
  double mean_square(const Points<2>& values) const {
    double squares = 0;
    for (std::size_t p = 0; p < patches_[0].size(); ++p) squares += values[p].squaredNorm();
    return std::sqrt(squares / static_cast<double>(patches_[0].size()));
  }
  std::size_t count() const { return patches_[0].size() + patches_[1].size(); }
  PatchRange own() const {
    const auto rank = static_cast<std::size_t>(rank_of(comm_)), ranks = static_cast<std::size_t>(ranks_of(comm_));
    return {count() * rank / ranks, count() * (rank + 1) / ranks};
  }

  /// Of values on the patches of all ranks those of this rank's; and of all those of each.
  Points<2> part(const Points<2>& values) const {
    return {values.begin() + static_cast<long>(own().begin), values.begin() + static_cast<long>(own().end)};
  }
  Points<2> whole(const Points<2>& mine) const {
    std::vector<double> all(2 * count(), 0.0);
    for (std::size_t p = 0; p < mine.size(); ++p)
      for (std::size_t d = 0; d < 2; ++d) all[2 * (own().begin + p) + d] = mine[p][static_cast<int>(d)];
    all = ordered_sum(comm_, all);
    Points<2> values;
    for (std::size_t p = 0; p < count(); ++p) values.emplace_back(all[2 * p], all[2 * p + 1]);
    return values;
  }

 private:
  static MarkerLayout<2> layout(MPI_Comm comm) {
    MarkerLayout<2> layout{Point<2>::Constant(0.025), 1, KernelMoments(DeltaKernel::yang, 2)};
    layout.comm = comm;
    return layout;
  }
  MarkerPatches<2> of_disc(double size) const {
    return surface_markers<2>(Sphere<2>(size), Bounds<2>::round(Point<2>::Zero(), Point<2>::Constant(1)), layout_);
  }

  MPI_Comm comm_;
  MarkerLayout<2> layout_;
  std::vector<MarkerPatches<2>> patches_;
  OverlapInverse<2> inverse_;
};

double alternating(std::size_t n) {
  return n % 2 == 0 ? 1.0 : -1.0;
}

TEST(OverlapInverse, SeesWhatIsEvenAndHardlyWhatAlternates) {
  const Overlaps overlaps(PETSC_COMM_WORLD);
  EXPECT_NEAR(overlaps.mean_square(overlaps.means(overlaps.round([](std::size_t) { return 1.0; }))), 1, 1e-12);
  EXPECT_LT(overlaps.mean_square(overlaps.means(overlaps.round(alternating))), 0.5);
}

// (O + 0.3 D) times what is found gives what was asked for; on the other disc there is nothing.
TEST(OverlapInverse, InvertsTheRaisedOverlaps) {
  const Overlaps overlaps(PETSC_COMM_WORLD);
  const auto over_d = [&](const Points<2>& values) {  // D^-1 values
    const Points<2> forces = overlaps.forces(values);
    return overlaps.means(forces) + 0.3 * forces;
  };
  const Points<2> of_ones = over_d(Points<2>(overlaps.count(), Point<2>::Ones()));
  const Points<2> asked = overlaps.round([](std::size_t n) { return std::sin(0.3 * static_cast<double>(n)); });
  const Points<2> found = over_d(asked);
  for (std::size_t p = 0; p < asked.size(); ++p) {
    EXPECT_GT(of_ones[p][0], 0);
    EXPECT_NEAR((found[p].cwiseQuotient(of_ones[p]) - asked[p]).norm(), 0, 1e-3) << p;
  }
}

// Each rank alone, and all together.
TEST(OverlapInverse, IsTheSameOnAnyNumberOfRanks) {
  const Overlaps shared(PETSC_COMM_WORLD), alone(PETSC_COMM_SELF);
  ASSERT_EQ(shared.count(), alone.count());
  const Points<2> asked = shared.round(alternating);
  const Points<2> found = shared.forces(asked), expected = alone.forces(asked);
  for (std::size_t p = 0; p < found.size(); ++p)
    EXPECT_NEAR((found[p] - expected[p]).norm(), 0, 1e-12 * expected[p].norm()) << p;
}

}  // namespace
}  // namespace washfsi::test
