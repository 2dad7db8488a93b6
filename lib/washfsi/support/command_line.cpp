// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/command_line.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "washfsi/support/errors.hpp"
#include "washfsi/support/first_rank.hpp"
#include "washfsi/support/petsc_options.hpp"

namespace washfsi {

namespace {

// Files under way, each with what named it: a file that comes back includes itself.
using Inclusion = std::vector<std::filesystem::path>;

void check_file(const std::string& path, const std::string& named_by, Inclusion under_way);

// One line of an options file: nothing, a comment, or an option and its value.
void check_line(const std::string& line, const std::string& where, const Inclusion& under_way) {
  if (line.find('\0') != std::string::npos) throw InputError(where + "has a NUL byte; this is not a text file");
  std::istringstream words(line);
  std::string option, value, third;
  words >> option >> value >> third;
  if (option.empty() || option[0] == '#') return;
  if (!is_option_name(option)) throw InputError(where + "must begin with - and a name (an option) or # (a comment)");
  if (!third.empty() && value[0] != '#' && third[0] != '#')
    throw InputError(where + "one option and one value (lists without blanks), not " + option + " " + value + " " +
                     third);
  if (option != "-options_file") return;
  if (value.empty() || value[0] == '#') throw InputError(where + "-options_file: the name of a file is missing");
  check_file(value, where + "-options_file " + value, under_way);
}

void check_file(const std::string& path, const std::string& named_by, Inclusion under_way) {
  std::error_code ignored;
  const std::filesystem::path same = std::filesystem::weakly_canonical(path, ignored);
  if (std::find(under_way.begin(), under_way.end(), same) != under_way.end())
    throw InputError(named_by + ": this file includes itself");
  under_way.push_back(same);
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) throw InputError(named_by + ": this file cannot be read");
  std::string line;
  for (int number = 1; std::getline(file, line); ++number)
    check_line(line, (under_way.size() == 1 ? named_by : path) + ", line " + std::to_string(number) + ": ", under_way);
}

// What PETSc reads unasked: resource files at home and here, and an environment variable.
void check_petsc_resources() {
  const char* home = std::getenv("HOME");
  for (const std::string& path :
       {home ? std::string(home) + "/.petscrc" : "", std::string(".petscrc"), std::string("petscrc")})
    if (!path.empty() && std::filesystem::is_regular_file(path)) check_file(path, path, {});
  const char* variable = std::getenv("PETSC_OPTIONS");
  std::istringstream words(variable ? variable : "");
  bool after_option = false;
  for (std::string word; words >> word;) {
    if (!is_option_name(word) && !after_option)
      throw InputError("PETSC_OPTIONS: " + word + " belongs to no option (options begin with -)");
    after_option = is_option_name(word);
  }
}

// PETSc passes over a word that belongs to no option: most often a forgotten dash.
void check_for_stray_words(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (!is_option_name(argv[i]) && !is_option_name(argv[i - 1]))
      throw InputError(std::string(argv[i]) + ": this word belongs to no option (options begin with -)");
}

void check_all(int argc, char** argv) {
  check_for_stray_words(argc, argv);
  check_petsc_resources();
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) != "-options_file") continue;
    if (i + 1 == argc || is_option_name(argv[i + 1])) throw InputError("-options_file: the name of a file is missing");
    check_file(argv[i + 1], std::string("-options_file ") + argv[i + 1], {});
  }
}

}  // namespace

CommandLine::CommandLine(MPI_Comm comm, int argc, char** argv) {
  on_first_rank<InputError>(comm, [&] { check_all(argc, argv); });
  sort(argc, argv);
}

void CommandLine::sort(int argc, char** argv) {
  std::vector<char*> others;
  sorted_.assign(argv, argv + std::min(argc, 1));
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    asks_for_version_ = asks_for_version_ || word == "--version" || word == "-version";
    if (word != "-options_file") {
      others.push_back(argv[i]);
      continue;
    }
    case_name_ = std::filesystem::path(argv[i + 1]).stem().string();
    sorted_.insert(sorted_.end(), {argv[i], argv[i + 1]});
    ++i;
  }
  sorted_.insert(sorted_.end(), others.begin(), others.end());
  count_ = static_cast<int>(sorted_.size());
  sorted_.push_back(nullptr);
  words_ = sorted_.data();
}

}  // namespace washfsi
