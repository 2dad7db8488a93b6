// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// Shortest text that reads back as the same number.
std::string to_text(double value);
/// Coordinates as they are written in options: 1,2.5
template <int Dim>
std::string list_text(const Point<Dim>& point) {
  std::string text;
  for (int d = 0; d < Dim; ++d) text += (d ? "," : "") + to_text(point[d]);
  return text;
}
std::string join(const std::vector<std::string>& words, const std::string& separator);
std::string lower_case(std::string text);
/// A value as a word of an options file: in quotes if it contains blanks or #.
std::string quoted(const std::string& value);
std::vector<std::string> split(const std::string& list, char separator);

}  // namespace washfsi
