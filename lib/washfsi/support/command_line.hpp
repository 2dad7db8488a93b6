// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <mpi.h>

namespace washfsi {

/// The words of the command line, checked before PETSc sees them, which would answer garbage with a trace; options
/// files come first, so that what stands on the command line itself wins wherever it stands.
class CommandLine {
 public:
  /// Looks at the words, at the files that they name, at PETSc's own resource files and at PETSC_OPTIONS. Collective;
  /// rank 0's findings count. Errors: InputError.
  CommandLine(MPI_Comm comm, int argc, char** argv);

  /// For PetscInitialize.
  int& count() { return count_; }
  char**& words() { return words_; }
  /// That of the last options file, without its ending; else the program's.
  const std::string& case_name() const { return case_name_; }
  /// Whether the user asks for the version only.
  bool asks_for_version() const { return asks_for_version_; }

 private:
  void sort(int argc, char** argv);

  int count_ = 0;
  char** words_ = nullptr;
  std::vector<char*> sorted_;
  std::string case_name_ = "washfsi";
  bool asks_for_version_ = false;
};

}  // namespace washfsi
