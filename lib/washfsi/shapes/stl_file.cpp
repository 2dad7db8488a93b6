// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/stl_file.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

// Binary STL: a header without meaning, the number of facets, then for each facet the normal and three corners as
// floats, and two bytes without meaning.
constexpr std::size_t header_bytes = 80, preamble_bytes = 84, facet_bytes = 50, normal_bytes = 12;

template <class Value>
Value value_at(const std::string& bytes, std::size_t offset) {
  Value value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

std::size_t promised_bytes(const std::string& bytes) {
  return preamble_bytes + facet_bytes * std::size_t{value_at<std::uint32_t>(bytes, header_bytes)};
}

std::vector<Triangle> binary_facets(const std::string& bytes, const std::string& start) {
  std::vector<Triangle> facets;
  for (std::size_t offset = preamble_bytes; offset < bytes.size(); offset += facet_bytes) {
    Triangle facet;
    for (std::size_t n = 0; n < 9; ++n)
      facet[n / 3][static_cast<int>(n % 3)] = value_at<float>(bytes, offset + normal_bytes + 4 * n);
    for (const auto& corner : facet)
      if (!corner.allFinite())
        throw InputError(start + "facet " + std::to_string(facets.size() + 1) + " has a corner that is not finite");
    facets.push_back(facet);
  }
  return facets;
}

std::vector<std::string> lower_case_words(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    for (char& letter : word) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    words.push_back(word);
  }
  return words;
}

/// Reads ASCII STL line by line: solids, made of facets of seven lines each.
class AsciiReader {
 public:
  AsciiReader(const std::string& text, std::string start) : lines_(text), start_(std::move(start)) {}

  std::vector<Triangle> facets() {
    std::vector<Triangle> facets;
    bool in_solid = false;
    while (next()) {
      if (words_[0] == (in_solid ? "endsolid" : "solid"))
        in_solid = !in_solid;
      else if (in_solid && words_[0] == "facet")
        facets.push_back(facet());
      else
        refuse(in_solid ? "facet or endsolid" : "solid");
    }
    if (in_solid) throw InputError(start_ + "ends before its endsolid: it is cut short");
    return facets;
  }

 private:
  // The next line that is not blank; false at the end of the file.
  bool next() {
    for (std::string line; std::getline(lines_, line);) {
      ++number_;
      words_ = lower_case_words(line);
      if (!words_.empty()) return true;
    }
    return false;
  }

  Triangle facet() {
    Triangle facet;
    expect({"outer", "loop"});
    for (auto& corner : facet) corner = vertex();
    expect({"endloop"});
    expect({"endfacet"});
    return facet;
  }

  void expect(const std::vector<std::string>& words) {
    if (!next()) throw InputError(start_ + "ends within a facet: it is cut short");
    if (words_ != words) refuse(words.size() == 1 ? words[0] : words[0] + " " + words[1]);
  }

  Point<3> vertex() {
    if (!next()) throw InputError(start_ + "ends within a facet: it is cut short");
    if (words_[0] != "vertex" || words_.size() != 4) refuse("vertex and three numbers");
    return {coordinate(words_[1]), coordinate(words_[2]), coordinate(words_[3])};
  }

  double coordinate(const std::string& word) const {
    const char *begin = word.data() + (word[0] == '+' ? 1 : 0), *end = word.data() + word.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) refuse("vertex and three numbers");
    return value;
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    throw InputError(start_ + "line " + std::to_string(number_) + " must be: " + expected);
  }

  std::istringstream lines_;
  std::string start_;
  std::vector<std::string> words_;
  int number_ = 0;
};

}  // namespace

std::vector<Triangle> read_stl(MPI_Comm comm, const std::string& path, const std::string& option) {
  const std::string start = option + " " + path + ": ";
  const auto content = file_from_first_rank(comm, path);
  if (!content) throw InputError(start + "cannot be read");
  const std::string& bytes = *content;
  // the header of a binary file may begin with "solid" too, so the length decides
  const bool has_preamble = bytes.size() >= preamble_bytes;
  if (has_preamble && bytes.size() == promised_bytes(bytes)) return binary_facets(bytes, start);
  const auto words = lower_case_words(bytes.substr(0, header_bytes));
  const bool is_text = bytes.find('\0') == std::string::npos;
  if (is_text && !words.empty() && words[0] == "solid") return AsciiReader(bytes, start).facets();
  if (is_text || !has_preamble) throw InputError(start + "is no STL file");
  throw InputError(start + "is no STL file, or damaged: as a binary one it should have " +
                   std::to_string(promised_bytes(bytes)) + " bytes, but has " + std::to_string(bytes.size()));
}

}  // namespace washfsi
