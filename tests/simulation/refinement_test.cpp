// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/refinement.hpp"

#include <gtest/gtest.h>

#include "support/option_database.hpp"
#include "washfsi/simulation/case.hpp"
#include "washfsi/simulation/options.hpp"

namespace washfsi::test {
namespace {

struct RefinedCase {
  RunOptions run;
  CaseOptions<3> chosen;
  std::string resolved;
};

RefinedCase read_case(const std::string& text) {
  const OptionDatabase database("-time_end 1 " + text);
  Options options(PETSC_COMM_WORLD);
  const Refinement refinement = Refinement::from_options(options);
  const RunOptions run = RunOptions::from_options(options, "refined", refinement);
  const auto chosen = CaseOptions<3>::from_options(options, refinement);
  return {run, chosen, options.resolved()};
}

using Counts = std::array<PetscInt, 2>;
const std::string coarse =
    "-grid_cells 20,20,10 -cloths towel,rope -towel_markers 8,6 -rope_markers 8,1 -time_step 3e-3 ";

TEST(Refinement, MultipliesCellsAndMarkersAndShortensTheStep) {
  const RefinedCase fine = read_case(coarse + "-refine 1.5");
  EXPECT_EQ(fine.chosen.model.grid.shape.cells, (std::array<PetscInt, 3>{30, 30, 15}));
  EXPECT_EQ(fine.chosen.model.cloths[0].markers, (Counts{12, 9}));
  EXPECT_EQ(fine.chosen.model.cloths[1].markers, (Counts{12, 1}));
  EXPECT_DOUBLE_EQ(fine.run.time_step, 2e-3);
}

TEST(Refinement, KeepsTheSpacingOfMarkersOverThatOfCells) {
  for (const char* lattice : {"centred", "nodal"}) {
    const std::string text = coarse + "-towel_markers 11 -towel_lattice " + lattice;
    const RefinedCase usual = read_case(text), fine = read_case(text + " -refine 3");
    const double wide = usual.chosen.model.cloths[0].sheet.ds, near = fine.chosen.model.cloths[0].sheet.ds;
    EXPECT_NEAR(wide / near, 3, 1e-12) << lattice;
  }
}

TEST(Refinement, IsRecordedInWhatItHasMade) {
  const RefinedCase fine = read_case(coarse + "-refine 1.5 -contact_distance 3e-3"), again = read_case(fine.resolved);
  EXPECT_EQ(again.resolved, fine.resolved);
  for (const char* line : {"-refine 1\n", "-grid_cells 30,30,15\n", "-towel_markers 12,9\n",
                           "-contact_distance 0.002\n", "-contact_body_distance 0\n"})
    EXPECT_NE(fine.resolved.find(line), std::string::npos) << line;
}

TEST(Refinement, BelowOneMakesTheCaseCoarser) {
  const RefinedCase rough = read_case(coarse + "-refine 0.2");
  EXPECT_EQ(rough.chosen.model.grid.shape.cells, (std::array<PetscInt, 3>{4, 4, 2}));
  EXPECT_EQ(rough.chosen.model.cloths[0].markers, (Counts{2, 2}));
  EXPECT_DOUBLE_EQ(rough.run.time_step, 15e-3);
}

}  // namespace
}  // namespace washfsi::test
