// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <mpi.h>

namespace washfsi {

/// A named number with its unit: a column of history.csv.
struct Column {
  std::string name, unit;
};

/// history.csv: a row of names, a row of units after '#', then one row per step, each on disk at once.
class History {
 public:
  /// Starts a new file, or continues one after `restart_step`. Collective. Errors: FileError.
  History(MPI_Comm comm, const std::string& path, const std::vector<Column>& columns, long restart_step);

  /// Appends a row: the step, then a value for each column after the first. Collective. Errors: FileError.
  void append(long step, const std::vector<double>& values);

 private:
  struct Close {
    void operator()(std::FILE* file) const { (void)std::fclose(file); }
  };
  MPI_Comm comm_;
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// Writes a text table with names and units in its first two rows, from rank 0's rows. Collective. Errors: FileError.
void write_table(MPI_Comm comm, const std::string& path, const std::vector<Column>& columns,
                 const std::vector<std::vector<double>>& rows);

}  // namespace washfsi
