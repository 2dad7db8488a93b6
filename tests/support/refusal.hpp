// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace washfsi::test {

/// The message of the error of this type with which work is refused; empty if it is not.
template <class Error, std::invocable Work>
std::string refusal_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Expects that work is refused with an error of this type whose message is one line that contains these words.
template <class Error, std::invocable Work>
void expect_refusal(const Work& work, const std::string& words) {
  const std::string line = refusal_of<Error>(work);
  EXPECT_NE(line.find(words), std::string::npos) << "expected: " << words << "\n  found: " << line;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
}

/// Expects that each text is refused so when it is read, with the words beside it.
template <class Error, class Read>
void expect_refusals(const Read& read, const std::vector<std::pair<std::string, std::string>>& texts_and_words) {
  for (const auto& wrong : texts_and_words) expect_refusal<Error>([&] { (void)read(wrong.first); }, wrong.second);
}

}  // namespace washfsi::test
