// SPDX-License-Identifier: BSD-3-Clause
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "washfsi/simulation/document.hpp"
#include "washfsi/simulation/simulation.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/program.hpp"

namespace washfsi {
namespace {

constexpr const char* help_text =
    "washfsi: cloth and water in a washing machine.\n"
    "  mpirun -n 2 washfsi -options_file wash.opts [options]\n"
    "Options of washfsi are listed below PETSc's own; SI units throughout.\n";

// PETSc would answer a bad options file with a trace: look at it first.
void check_options_file(const std::string& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    throw InputError("-options_file " + path + ": this file cannot be read");
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    const std::size_t start = line.find_first_not_of(" \t\r");
    if (start == std::string::npos || line[start] == '#') continue;
    const std::string where = "-options_file " + path + ", line " + std::to_string(number) + ": ";
    if (line[start] != '-') throw InputError(where + "must begin with - (an option) or # (a comment)");
    std::istringstream words(line);
    std::string option, value, third;
    words >> option >> value >> third;
    if (!third.empty() && value[0] != '#' && third[0] != '#')
      throw InputError(where + "one option and one value (lists without blanks), not " + option + " " + value + " " +
                       third);
  }
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && (std::isalpha(static_cast<unsigned char>(word[1])) || word[1] == '-');
}

// PETSc passes over a word that belongs to no option: most often a forgotten dash.
void check_for_stray_words(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (!is_option(argv[i]) && !is_option(argv[i - 1]))
      throw InputError(std::string(argv[i]) + ": this word belongs to no option (options begin with -)");
}

// Every rank looks at the arguments, rank 0's findings count. Returns the case's name.
std::string case_from_arguments(int argc, char** argv) {
  check_for_stray_words(argc, argv);
  std::string name = "washfsi", problem;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) != "-options_file") continue;
    if (i + 1 == argc) throw InputError("-options_file: the name of a file is missing");
    name = std::filesystem::path(argv[i + 1]).stem().string();
    if (rank_of(MPI_COMM_WORLD) != 0) continue;
    try {
      check_options_file(argv[i + 1]);
    } catch (const InputError& error) {
      problem = error.what();
    }
  }
  problem = from_first_rank(MPI_COMM_WORLD, problem);
  if (!problem.empty()) throw InputError(problem);
  return name;
}

void simulate(Options& options, const std::string& case_name) {
  if (dimension_from_options(options) == 2)
    Simulation<2>(options, case_name).run();
  else
    Simulation<3>(options, case_name).run();
}

std::string quantities(Options& options) {
  return dimension_from_options(options) == 2 ? document_quantities<2>(options) : document_quantities<3>(options);
}

void run_or_document(const std::string& case_name) {
  Options options(PETSC_COMM_WORLD);
  const Document document = document_from_options(options);
  if (document == Document::none) return simulate(options, case_name);
  const std::string text = document == Document::options ? document_options(options.comm()) : quantities(options);
  if (rank_of(options.comm()) == 0) std::cout << text;
}

}  // namespace
}  // namespace washfsi

int main(int argc, char** argv) {
  return washfsi::run_program("washfsi", [&] {
    const std::string case_name = washfsi::case_from_arguments(argc, argv);
    WASH_PETSC(PetscInitialize(&argc, &argv, nullptr, washfsi::help_text));
    washfsi::run_or_document(case_name);
  });
}
