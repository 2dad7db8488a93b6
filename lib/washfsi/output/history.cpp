// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/history.hpp"

#include <fstream>
#include <sstream>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/hdf5_file.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

std::string header(const std::vector<Column>& columns) {
  std::vector<std::string> names, units;
  for (const Column& column : columns) {
    names.push_back(column.name);
    units.push_back(column.unit);
  }
  return join(names, ",") + "\n# " + join(units, ",") + "\n";
}

std::string row_text(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ",") + to_text(value);
  return text + "\n";
}

// The rows of an earlier run up to a step; empty if there is no such file or its columns are others.
std::string earlier_rows(const std::string& path, const std::string& wanted_header, long last_step) {
  std::ifstream file(path);
  std::string names, units, rows;
  if (!std::getline(file, names) || !std::getline(file, units) || names + "\n" + units + "\n" != wanted_header)
    return {};
  for (std::string line; std::getline(file, line) && !file.eof();)  // a row without its end was cut off
    if (std::atol(line.c_str()) <= last_step) rows += line + "\n";
  return rows;
}

}  // namespace

History::History(MPI_Comm comm, const std::string& path, const std::vector<Column>& columns, long restart_step)
    : comm_(comm), path_(path) {
  bool failed = false;
  if (rank_of(comm) == 0) {
    const std::string start = header(columns);
    const std::string text = start + (restart_step >= 0 ? earlier_rows(path, start, restart_step) : "");
    const std::string temporary = path + ".part";
    file_.reset(std::fopen(temporary.c_str(), "w"));  // the earlier rows stay until all are written anew
    failed = !file_ || std::fputs(text.c_str(), file_.get()) < 0 || std::fflush(file_.get()) != 0 ||
             !commit_file(temporary, path);
  }
  if (any_rank(comm, failed)) throw FileError(path + ": cannot be written");
}

void History::append(long step, const std::vector<double>& values) {
  bool failed = false;
  if (file_) {
    const std::string text = std::to_string(step) + "," + row_text(values);
    failed = std::fputs(text.c_str(), file_.get()) < 0 || std::fflush(file_.get()) != 0;
  }
  if (any_rank(comm_, failed)) throw FileError(path_ + ": cannot be written (is the disk full?)");
}

void write_table(MPI_Comm comm, const std::string& path, const std::vector<Column>& columns,
                 const std::vector<std::vector<double>>& rows) {
  std::string text = header(columns);
  for (const auto& row : rows) text += row_text(row);
  write_text_file(comm, path, text);
}

}  // namespace washfsi
