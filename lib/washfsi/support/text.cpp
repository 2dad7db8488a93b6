// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <sstream>

namespace washfsi {

std::string to_text(double value) {
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (std::size_t n = 0; n < words.size(); ++n) text += (n == 0 ? "" : separator) + words[n];
  return text;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string quoted(const std::string& value) {
  if (value.find_first_of(" \t#\"'") == std::string::npos) return value;
  const std::string mark = value.find('"') == std::string::npos ? "\"" : "'";
  return mark + value + mark;
}

std::vector<std::string> split(const std::string& list, char separator) {
  std::vector<std::string> words;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, separator);) words.push_back(word);
  if (!list.empty() && list.back() == separator) words.emplace_back();  // "1,2," has three words
  return words;
}

}  // namespace washfsi
