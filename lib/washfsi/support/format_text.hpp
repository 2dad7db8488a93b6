// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace washfsi {

/// Formats a line as std::printf does, cut at 511 characters.
template <class... Arguments>
std::string format_text(const char* pattern, Arguments... arguments) {
  std::array<char, 512> text{};
  (void)std::snprintf(text.data(), text.size(), pattern, arguments...);
  return text.data();
}

}  // namespace washfsi
