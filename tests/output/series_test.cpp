// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/series.hpp"

#include <gtest/gtest.h>

#include "support/lattice_group.hpp"
#include "support/linear_flow.hpp"
#include "support/scratch_folder.hpp"
#include "washfsi/shapes/primitives.hpp"

namespace washfsi::test {
namespace {

// All values of a dataset of this shape in a frame.
std::vector<double> values_in(const std::string& path, const std::string& dataset, const std::vector<hsize_t>& shape) {
  Hdf5File file(PETSC_COMM_SELF, path, Hdf5File::Mode::read);
  return file.read(dataset, {shape, std::vector<hsize_t>(shape.size(), 0), shape});
}

// The unit beside a dataset.
std::string unit_in(const std::string& path, const std::string& dataset) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t attribute = H5Aopen_by_name(file, dataset.c_str(), "unit", H5P_DEFAULT, H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  std::string text(H5Tget_size(type), ' ');
  (void)H5Aread(attribute, type, text.data());
  (void)H5Tclose(type);
  (void)H5Aclose(attribute);
  (void)H5Fclose(file);
  return text;
}

// Rows along x, one after the other; velocities have three components.
TEST(FlowSeries, HasVelocityAndPressureInTheMiddlesOfCells) {
  const ScratchFolder folder;
  const LinearFlow flow;
  FlowSeries<2>(flow.grid, flow.boundary, folder.path(), -1).write(0.5, 3, flow.velocity, flow.pressure);
  const std::string frame = folder.file("flow/000000.h5");
  const auto velocity = values_in(frame, "/velocity", {6, 8, 3}), pressure = values_in(frame, "/pressure", {6, 8});
  for_each<2>(flow.grid.owned(), [&](const Index<2>& cell) {
    const auto n = 8 * static_cast<std::size_t>(cell[1]) + static_cast<std::size_t>(cell[0]);
    const Point<2> place = flow.grid.cell_center(cell), expected = LinearFlow::velocity_at(place);
    EXPECT_NEAR(velocity[3 * n], expected[0], 1e-13);
    EXPECT_NEAR(velocity[3 * n + 1], expected[1], 1e-13);
    EXPECT_EQ(velocity[3 * n + 2], 0);
    EXPECT_NEAR(pressure[n], LinearFlow::pressure_at(place), 1e-13);
  });
  EXPECT_EQ(unit_in(frame, "/velocity"), "m/s");
  EXPECT_EQ(unit_in(frame, "/pressure"), "Pa");
}

// Beside walls too; in the corners two walls mirror at once.
TEST(FlowSeries, HasTheVorticityOfALinearFlow) {
  const ScratchFolder folder;
  const LinearFlow flow;
  FlowSeries<2>(flow.grid, flow.boundary, folder.path(), -1).write(0.5, 3, flow.velocity, flow.pressure);
  const std::string frame = folder.file("flow/000000.h5");
  const auto vorticity = values_in(frame, "/vorticity", {6, 8});
  for_each<2>(flow.grid.owned(), [&](const Index<2>& cell) {
    const bool in_corner = (cell[0] == 0 || cell[0] == 7) && (cell[1] == 0 || cell[1] == 5);
    if (in_corner) return;
    EXPECT_NEAR(vorticity[8 * static_cast<std::size_t>(cell[1]) + static_cast<std::size_t>(cell[0])],
                LinearFlow::vorticity, 1e-12);
  });
  EXPECT_EQ(unit_in(frame, "/vorticity"), "1/s");
}

TEST(BodySeries, HasTheDistanceFromABodyWhereItIsAtThatTime) {
  const ScratchFolder folder;
  const LinearFlow flow;
  std::vector<Body<2>> bodies(1);
  bodies[0].name = "ball";
  bodies[0].shape = std::make_unique<Sphere<2>>(0.2);
  bodies[0].motion.center = {0.4, 0.5};
  bodies[0].motion.translation = {2, 0};
  BodySeries<2>(flow.grid, bodies, folder.path(), -1).write(0.1, 7);
  const std::string frame = folder.file("bodies/000000.h5");
  const auto distances = values_in(frame, "/ball", {6, 8});
  for_each<2>(flow.grid.owned(), [&](const Index<2>& cell) {
    const double expected = (flow.grid.cell_center(cell) - Point<2>(0.6, 0.5)).norm() - 0.2;
    EXPECT_NEAR(distances[8 * static_cast<std::size_t>(cell[1]) + static_cast<std::size_t>(cell[0])], expected, 1e-13);
  });
  EXPECT_EQ(unit_in(frame, "/ball"), "m");
}

// XDMF: 2, the number of markers and the markers of a line; 5 and the corners of a quadrilateral in their order.
TEST(ClothSeries, ConnectsTheMarkersOfEachClothAmongThemselvesOnly) {
  const ScratchFolder folder;
  const Cloths<3> cloths(PETSC_COMM_WORLD, {lattice_group<3>("belt", 1, {3, 1}), lattice_group<3>("towel", 2, {2, 2})});
  const ClothSeries<3> series(PETSC_COMM_WORLD, cloths, folder.path(), -1);
  const std::string constants = folder.file("cloth/constants.h5");
  EXPECT_EQ(values_in(constants, "/topology", {15}),
            (std::vector<double>{2, 3, 0, 1, 2, 5, 3, 4, 6, 5, 5, 7, 8, 10, 9}));
  EXPECT_EQ(values_in(constants, "/group", {11}), (std::vector<double>{0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(values_in(constants, "/cloth", {11}), (std::vector<double>{0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2}));
}

TEST(ClothSeries, HasPlacesVelocitiesAndFieldsWithTheirUnits) {
  const ScratchFolder folder;
  const Cloths<3> cloths(PETSC_COMM_WORLD, {lattice_group<3>("belt", 1, {2, 1})});
  ClothSeries<3> series(PETSC_COMM_WORLD, cloths, folder.path(), -1);
  series.write(0.25, 4, {{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {-1, -2, -3}}, {{"stress", "Pa", {10, 20}}});
  const std::string frame = folder.file("cloth/000000.h5");
  EXPECT_EQ(values_in(frame, "/position", {2, 3}), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(values_in(frame, "/velocity", {2, 3}), (std::vector<double>{7, 8, 9, -1, -2, -3}));
  EXPECT_EQ(values_in(frame, "/stress", {2}), (std::vector<double>{10, 20}));
  EXPECT_EQ(unit_in(frame, "/position"), "m");
  EXPECT_EQ(unit_in(frame, "/velocity"), "m/s");
  EXPECT_EQ(unit_in(frame, "/stress"), "Pa");
}

}  // namespace
}  // namespace washfsi::test
