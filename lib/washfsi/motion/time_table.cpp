// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/motion/time_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

std::string trimmed(const std::string& word) {
  const auto begin = word.find_first_not_of(" \t\r"), end = word.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : word.substr(begin, end - begin + 1);
}

// The numbers of a line; fewer if one cannot be read.
std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  for (const auto& field : split(line, ',')) {
    const std::string word = trimmed(field);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return {};
    numbers.push_back(value);
  }
  return numbers;
}

}  // namespace

std::vector<std::vector<double>> read_time_table(MPI_Comm comm, const std::string& path, const std::string& option,
                                                 const std::string& columns) {
  const auto width = static_cast<std::size_t>(1 + std::count(columns.begin(), columns.end(), ','));
  const std::string start = option + " " + path + ": ";
  const auto text = file_from_first_rank(comm, path);
  if (!text) throw InputError(start + "cannot be read");
  std::vector<std::vector<double>> rows;
  std::istringstream lines(*text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = trimmed(line);
    if (line.empty() || line[0] == '#' || (rows.empty() && line == columns)) continue;
    const std::vector<double> numbers = numbers_of(line);
    const std::string where = start + "line " + std::to_string(number);
    if (numbers.size() != width)
      throw InputError(where + " must be the " + std::to_string(width) + " numbers " + columns);
    if (!rows.empty() && numbers[0] < rows.back()[0] + 1e-9)
      throw InputError(where + ": time " + to_text(numbers[0]) +
                       " must be later than that of the row before, by 1e-9 s at least");
    rows.push_back(numbers);
  }
  if (rows.size() < 2) throw InputError(start + "must have at least 2 rows " + columns);
  return rows;
}

}  // namespace washfsi
