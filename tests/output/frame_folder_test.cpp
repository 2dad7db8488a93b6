// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/frame_folder.hpp"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

const Slab one_number{{1}, {0}, {1}};

FrameFolder level_frames(const ScratchFolder& folder, long restart_step) {
  return {PETSC_COMM_WORLD, folder.path(), "level", restart_step, {{"lower_x", 0.25}}, {}};
}

// A frame of the level of water, at first 1 m and rising by a metre each second.
void add_level(FrameFolder& frames, double time, long step) {
  frames.add(
      time, step, [&](Hdf5File& file) { write_with_unit(file, "/height", "m", one_number, {1 + time}); },
      [&](const Frame& frame) { return frames.frame_item(frame, "/height", {1}); });
}

// Frames of the steps 0, 10 and 20, at 0, 0.5 and 1 s.
void write_three_levels(const ScratchFolder& folder) {
  FrameFolder frames = level_frames(folder, -1);
  for (const long n : {0L, 1L, 2L}) add_level(frames, 0.5 * static_cast<double>(n), 10 * n);
}

// The heights in all frames that the index links to, by their numbers.
std::vector<double> heights(const ScratchFolder& folder, const std::vector<std::string>& numbers) {
  Hdf5File index(PETSC_COMM_WORLD, folder.file("level.h5"), Hdf5File::Mode::read);
  std::vector<double> found;
  for (const std::string& number : numbers)
    found.push_back(index.read("/frames/" + number + "/height", one_number).at(0));
  return found;
}

bool is_linked(const ScratchFolder& folder, const std::string& number) {
  Hdf5File index(PETSC_COMM_WORLD, folder.file("level.h5"), Hdf5File::Mode::read);
  return index.has("/frames/" + number);
}

TEST(FrameFolder, LinksFramesThatKnowTheirTimeAndStep) {
  const ScratchFolder folder;
  write_three_levels(folder);
  EXPECT_EQ(heights(folder, {"000000", "000001", "000002"}), (std::vector<double>{1, 1.5, 2}));
  Hdf5File frame(PETSC_COMM_WORLD, folder.file("level/000002.h5"), Hdf5File::Mode::read);
  EXPECT_EQ(frame.attribute("/", "time"), 1);
  EXPECT_EQ(frame.attribute("/", "step"), 20);
  Hdf5File index(PETSC_COMM_WORLD, folder.file("level.h5"), Hdf5File::Mode::read);
  EXPECT_EQ(index.attribute("/", "lower_x"), 0.25);
}

TEST(FrameFolder, DescribesEachFrameWithItsTimeForParaView) {
  const ScratchFolder folder;
  write_three_levels(folder);
  const auto lines = folder.lines("level.xdmf");
  const auto count = [&](const std::string& line) { return std::count(lines.begin(), lines.end(), line); };
  for (const char* time : {"0", "0.5", "1"}) EXPECT_EQ(count("<Time Value=\"" + std::string(time) + "\"/>"), 1) << time;
  const std::string item = "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"1\">";
  EXPECT_EQ(count(item + "level/000001.h5:/height</DataItem>"), 1);
}

TEST(FrameFolder, AfterARestartGoesOnBehindTheFramesUpToIt) {
  const ScratchFolder folder;
  write_three_levels(folder);
  FrameFolder frames = level_frames(folder, 10);
  EXPECT_FALSE(frames.is_new());
  EXPECT_FALSE(folder.has("level/000002.h5"));
  EXPECT_FALSE(is_linked(folder, "000002"));
  add_level(frames, 0.75, 15);
  EXPECT_EQ(heights(folder, {"000000", "000001", "000002"}), (std::vector<double>{1, 1.5, 1.75}));
}

TEST(FrameFolder, OfANewRunHasNoFramesOfAnEarlierOneButLeavesOtherFiles) {
  const ScratchFolder folder;
  write_three_levels(folder);
  folder.write("level/notes.txt", "mine");
  folder.write("level/12.h5", "mine");
  FrameFolder frames = level_frames(folder, -1);
  EXPECT_TRUE(frames.is_new());
  for (const char* number : {"000000", "000001", "000002"})
    EXPECT_FALSE(folder.has("level/" + std::string(number) + ".h5"));
  EXPECT_TRUE(folder.has("level/notes.txt") && folder.has("level/12.h5"));
}

TEST(FrameFolder, SetsADamagedFrameAsideAndNeverUsesItsNumberTwice) {
  const ScratchFolder folder;
  write_three_levels(folder);
  folder.write("level/000001.h5", "damaged");
  testing::internal::CaptureStderr();
  FrameFolder frames = level_frames(folder, 20);
  const std::string note = testing::internal::GetCapturedStderr();
  EXPECT_NE(note.find("level/000001.h5: cannot be opened as an HDF5 file; it is kept as"), std::string::npos) << note;
  EXPECT_EQ(std::count(note.begin(), note.end(), '\n'), 1) << note;
  EXPECT_EQ(folder.lines("level/000001.h5.damaged"), std::vector<std::string>{"damaged"});
  EXPECT_FALSE(is_linked(folder, "000001"));
  add_level(frames, 1.5, 30);
  EXPECT_EQ(heights(folder, {"000000", "000002", "000003"}), (std::vector<double>{1, 2, 2.5}));
}

TEST(FrameFolder, ClearsAwayWhatAKilledRunHasLeftIncomplete) {
  const ScratchFolder folder;
  write_three_levels(folder);
  folder.write("level/000003.h5.part", "half of a frame");
  (void)level_frames(folder, 20);
  EXPECT_FALSE(folder.has("level/000003.h5.part"));
  EXPECT_TRUE(folder.has("level/000002.h5"));
}

TEST(FrameFolder, SetsAsideASeriesOfAnEarlierVersion) {
  const ScratchFolder folder;
  folder.write("level.h5", "frames within");
  testing::internal::CaptureStderr();
  const FrameFolder frames = level_frames(folder, 20);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("as earlier versions wrote them"), std::string::npos);
  EXPECT_TRUE(frames.is_new());
  EXPECT_EQ(folder.lines("level.h5.damaged"), std::vector<std::string>{"frames within"});
}

TEST(FrameFolder, TellsInOneLineThatItCannotBeWritten) {
  const ScratchFolder folder;
  folder.write("level", "a file where the folder should be");
  expect_refusal<FileError>([&] { (void)level_frames(folder, -1); }, "level");
  std::filesystem::remove(folder.file("level"));
  FrameFolder frames = level_frames(folder, -1);
  std::filesystem::remove_all(folder.file("level"));
  expect_refusal<FileError>([&] { add_level(frames, 0, 0); }, "level/000000.h5");
}

}  // namespace
}  // namespace washfsi::test
