// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <mpi.h>

#include "washfsi/support/given_options.hpp"

namespace washfsi {

/// Names of presets, each with options, without their dash, and values: -preset NAME stands for them.
using PresetOptions = std::map<std::string, std::vector<std::pair<std::string, std::string>>>;

/// The words of the command line, checked before PETSc sees them, which would print a trace for garbage. Options files
/// are read here, in the order in which they are named, and PETSc gets their options as words; those of the command
/// line itself come last, and so override them wherever they stand.
class CommandLine {
 public:
  /// Checks the words, the files that they name, PETSc's own resource files and PETSC_OPTIONS. A file named
  /// in a file is relative to its folder. The options of -preset come first, so that all others override them.
  /// Collective; rank 0's findings count. Errors: InputError.
  CommandLine(MPI_Comm comm, int argc, char** argv, const PresetOptions& presets = {});

  /// The words for PetscInitialize.
  int& count() { return count_; }
  char**& words() { return words_; }
  /// The options with their origins.
  const GivenOptions& given() const { return given_; }
  /// The name of the last options file on the command line, without its ending; else the program's name.
  const std::string& case_name() const { return case_name_; }
  /// Whether the user asks for the version only.
  bool asks_for_version() const { return asks_for_version_; }

 private:
  void make_words(const char* program);

  int count_ = 0;
  char** words_ = nullptr;
  GivenOptions given_;
  std::vector<std::string> texts_;
  std::vector<char*> pointers_;
  std::string case_name_ = "washfsi";
  bool asks_for_version_ = false;
};

}  // namespace washfsi
