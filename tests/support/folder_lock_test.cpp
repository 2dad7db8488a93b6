// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/folder_lock.hpp"

#include <optional>

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/hdf5_file.hpp"

namespace washfsi::test {
namespace {

TEST(FolderLock, RefusesAnotherRunOnAllRanksUntilTheFirstHasEnded) {
  const ScratchFolder folder;
  const auto lock_again = [&] { const FolderLock another(PETSC_COMM_WORLD, folder.path()); };
  std::optional<FolderLock> lock(std::in_place, PETSC_COMM_WORLD, folder.path());
  expect_refusal<FileError>(lock_again, "-output_dir " + folder.path() + ": another run is writing into this folder");
  lock.reset();
  MPI_Barrier(PETSC_COMM_WORLD);
  EXPECT_NO_THROW(lock_again());
}

TEST(FolderLock, LeavesNothingBehindAndPassesOverAKilledRuns) {
  const ScratchFolder folder;
  folder.write(".lock", "");  // as a killed run leaves it
  EXPECT_NO_THROW(const FolderLock lock(PETSC_COMM_WORLD, folder.path()));
  MPI_Barrier(PETSC_COMM_WORLD);
  EXPECT_FALSE(folder.has(".lock"));
}

TEST(FolderLock, IsOfOneFolderOnly) {
  const ScratchFolder folder;
  make_writable_folder(PETSC_COMM_WORLD, folder.file("other"));
  const FolderLock lock(PETSC_COMM_WORLD, folder.path());
  EXPECT_NO_THROW(const FolderLock another(PETSC_COMM_WORLD, folder.file("other")));
}

}  // namespace
}  // namespace washfsi::test
