// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/command_line.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/first_rank.hpp"
#include "washfsi/support/petsc_options.hpp"

namespace washfsi {

namespace {

// The files being read: one that recurs includes itself.
using Inclusion = std::vector<std::filesystem::path>;

// A word of a line; one in quotes may be empty, or contain blanks and #.
struct Word {
  std::string text;
  bool quoted = false;
};

// Takes the next word from a line, of which # ends the rest; nothing at its end.
std::optional<Word> take_word(std::string& line, const std::string& where) {
  line.erase(0, line.find_first_not_of(" \t\r"));
  if (line.empty() || line[0] == '#') return std::nullopt;
  const bool quoted = line[0] == '"' || line[0] == '\'';
  const std::size_t begin = quoted ? 1 : 0, end = quoted ? line.find(line[0], 1) : line.find_first_of(" \t\r#");
  if (quoted && end == std::string::npos) throw InputError(where + "the quote " + line + " has no end");
  const Word word{line.substr(begin, end - begin), quoted};
  line.erase(0, end == std::string::npos ? end : end + begin);
  return word;
}

// Reads an options file, and the files named in it where they are named.
class FileReader {
 public:
  /// `in_folders`: files named in a file are relative to its folder; PETSc takes them from the working directory.
  FileReader(GivenOptions& given, bool in_folders) : given_(given), in_folders_(in_folders) {}

  void read(const std::string& path, const std::string& named_by, Inclusion under_way = {});

 private:
  void read_line(const std::string& line, const std::string& path, const std::string& where,
                 const Inclusion& under_way);

  GivenOptions& given_;
  bool in_folders_;
  std::set<std::string> recorded_;  ///< files that runs have written of their options
};

// One line of an options file: nothing, a comment, or an option and its value.
void FileReader::read_line(const std::string& line, const std::string& path, const std::string& where,
                           const Inclusion& under_way) {
  if (line.find('\0') != std::string::npos) throw InputError(where + "has a NUL byte; this is not a text file");
  std::string rest = line;
  const auto option = take_word(rest, where);
  if (!option) return;
  if (!is_option_name(option->text))
    throw InputError(where + "must begin with - and a name (an option) or # (a comment)");
  const auto value = take_word(rest, where), third = take_word(rest, where);
  if (third)
    throw InputError(where + "one option and one value (lists without blanks), not " + option->text + " " +
                     value->text + " " + third->text);
  const bool two_options = value && !value->quoted && is_option_name(value->text);
  if (option->text != "-options_file") {
    const bool recorded = recorded_.contains(path);
    given_.add({option->text, value && !two_options ? value->text : "", value && !two_options, path, recorded});
    if (two_options) given_.add({value->text, "", false, path, recorded});
    return;
  }
  if (!value || value->text.empty()) throw InputError(where + "-options_file: the name of a file is missing");
  const auto folder = in_folders_ ? std::filesystem::path(path).parent_path() : std::filesystem::path();
  read((folder / value->text).string(), where + "-options_file " + value->text, under_way);
}

void FileReader::read(const std::string& path, const std::string& named_by, Inclusion under_way) {
  std::error_code ignored;
  const std::filesystem::path same = std::filesystem::weakly_canonical(path, ignored);
  if (std::find(under_way.begin(), under_way.end(), same) != under_way.end())
    throw InputError(named_by + ": this file includes itself");
  under_way.push_back(same);
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) throw InputError(named_by + ": this file cannot be read");
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (number == 1 && line == resolved_head) recorded_.insert(path);
    read_line(line, path, (under_way.size() == 1 ? named_by : path) + ", line " + std::to_string(number) + ": ",
              under_way);
  }
}

// What PETSc reads by itself comes after presets have been put before all options.
void check_for_preset(const GivenOption& option, const std::string& place) {
  if (option.name() == "preset")
    throw InputError(place + ": -preset is read on the command line and in options files alone");
}

// Checks what PETSc reads by itself: resource files at home and here, and an environment variable.
void check_petsc_resources() {
  const char* home = std::getenv("HOME");
  for (const std::string& path :
       {home ? std::string(home) + "/.petscrc" : "", std::string(".petscrc"), std::string("petscrc")})
    if (!path.empty() && std::filesystem::is_regular_file(path)) {
      GivenOptions of_petsc;
      FileReader(of_petsc, false).read(path, path);
      for (const GivenOption& option : of_petsc.all()) check_for_preset(option, path);
    }
  const char* variable = std::getenv("PETSC_OPTIONS");
  std::istringstream words(variable ? variable : "");
  bool after_option = false;
  for (std::string word; words >> word;) {
    if (!is_option_name(word) && !after_option)
      throw InputError("PETSC_OPTIONS: " + word + " belongs to no option (options begin with -)");
    after_option = is_option_name(word);
    if (after_option) check_for_preset({word, "", false, ""}, "PETSC_OPTIONS");
  }
}

// PETSc passes over a word that belongs to no option: most often a forgotten dash.
void check_for_stray_words(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (!is_option_name(argv[i]) && !is_option_name(argv[i - 1]))
      throw InputError(std::string(argv[i]) + ": this word belongs to no option (options begin with -)");
}

// PETSc's word for help where the user says it as other programs have it.
std::string petsc_word(const std::string& word) {
  return word == "--help" || word == "-h" ? "-help" : word;
}

// Puts the options of the preset that is given last before all others. Nobody is told of those without effect.
GivenOptions after_preset(const GivenOptions& given, const PresetOptions& presets) {
  const auto preset = presets.find(given.value("preset"));
  if (preset == presets.end()) return given;
  GivenOptions all;
  for (const auto& [name, value] : preset->second) all.add({"-" + name, value, true, "-preset " + preset->first, true});
  for (const GivenOption& option : given.all()) all.add(option);
  return all;
}

// The options of files and the command line, in this order.
GivenOptions read_all(int argc, char** argv) {
  GivenOptions given, of_line;
  for (int i = 1; i < argc; ++i) {
    const bool has_value = i + 1 < argc && !is_option_name(argv[i + 1]);
    const std::string word = argv[i], value = has_value ? argv[i + 1] : "";
    if (word == "-options_file" && value.empty()) throw InputError("-options_file: the name of a file is missing");
    if (word == "-options_file")
      FileReader(given, true).read(value, "-options_file " + value);
    else
      of_line.add({petsc_word(word), value, has_value, ""});
    if (has_value) ++i;
  }
  for (const GivenOption& option : of_line.all()) given.add(option);
  return given;
}

// A name that can stand as a word in an options file.
std::string one_word(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isspace(c) || c == '#' || c == '"' || c == '\''; },
      '_');
  return name;
}

std::string last_options_file(int argc, char** argv) {
  std::string last;
  for (int i = 1; i + 1 < argc; ++i)
    if (std::string(argv[i]) == "-options_file") last = argv[i + 1];
  return last;
}

}  // namespace

CommandLine::CommandLine(MPI_Comm comm, int argc, char** argv, const PresetOptions& presets) {
  on_first_rank<InputError>(comm, [&] {
    check_for_stray_words(argc, argv);
    check_petsc_resources();
    given_ = after_preset(read_all(argc, argv), presets);
  });
  given_ = GivenOptions::unpacked(from_first_rank(comm, given_.packed()));
  if (const std::string file = last_options_file(argc, argv); !file.empty())
    case_name_ = one_word(std::filesystem::path(file).stem().string());
  make_words(argc > 0 ? argv[0] : "washfsi");
}

void CommandLine::make_words(const char* program) {
  texts_ = {program};
  for (const GivenOption& option : given_.all()) {
    const bool of_line = option.file.empty();
    asks_for_version_ = asks_for_version_ || (of_line && (option.word == "--version" || option.word == "-version"));
    texts_.push_back(option.word);
    if (option.has_value) texts_.push_back(option.value);
  }
  for (std::string& text : texts_) pointers_.push_back(text.data());
  count_ = static_cast<int>(pointers_.size());
  pointers_.push_back(nullptr);
  words_ = pointers_.data();
}

}  // namespace washfsi
