// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi::test {

/// An empty folder for the files of the present test, removed at the end of the scope. Members other than `file` and
/// `has` are collective.
class ScratchFolder {
 public:
  ScratchFolder() : path_(name_of_test()) {
    if (rank_of(PETSC_COMM_WORLD) == 0) {
      std::filesystem::remove_all(path_);
      std::filesystem::create_directories(path_);
    }
    MPI_Barrier(PETSC_COMM_WORLD);
  }
  ~ScratchFolder() {
    if (std::uncaught_exceptions() > 0) return;  // other ranks may not come here
    MPI_Barrier(PETSC_COMM_WORLD);
    std::error_code ignored;
    if (rank_of(PETSC_COMM_WORLD) == 0) std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  bool has(const std::string& name) const { return std::filesystem::exists(file(name)); }

  /// Writes a file that consists of this text.
  void write(const std::string& name, const std::string& text) const {
    if (rank_of(PETSC_COMM_WORLD) == 0) std::ofstream(file(name)) << text;
    MPI_Barrier(PETSC_COMM_WORLD);
  }
  /// The lines of a file; none if there is no such file.
  std::vector<std::string> lines(const std::string& name) const {
    MPI_Barrier(PETSC_COMM_WORLD);
    std::ifstream stream(file(name));
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }

 private:
  // Tests on other numbers of ranks may run at the same time.
  static std::string name_of_test() {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    return std::string("scratch_") + info->test_suite_name() + "_" + info->name() + "_" +
           std::to_string(ranks_of(PETSC_COMM_WORLD));
  }

  std::string path_;
};

}  // namespace washfsi::test
