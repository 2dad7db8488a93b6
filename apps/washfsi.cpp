// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <iostream>

#include "washfsi/simulation/document.hpp"
#include "washfsi/simulation/presets.hpp"
#include "washfsi/simulation/simulation.hpp"
#include "washfsi/simulation/version.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/command_line.hpp"
#include "washfsi/support/program.hpp"

namespace washfsi {
namespace {

constexpr const char* help_text =
    "washfsi: cloth and water in a washing machine.\n"
    "  mpirun -n 2 washfsi -options_file wash.opts [options]\n"
    "Options of washfsi are listed below PETSc's own; SI units throughout.\n";

void simulate(Options& options, const std::string& case_name) {
  if (dimension_from_options(options) == 2)
    Simulation<2>(options, case_name).run();
  else
    Simulation<3>(options, case_name).run();
}

std::string quantities(Options& options) {
  return dimension_from_options(options) == 2 ? document_quantities<2>(options) : document_quantities<3>(options);
}

void print_version() {
  const std::string commit = git_text;
  if (rank_of(MPI_COMM_WORLD) == 0)
    std::cout << "washfsi " << version_text << (commit.empty() ? "" : " (" + commit + ")") << "\n";
}

void run_or_document(const CommandLine& line) {
  Options options(PETSC_COMM_WORLD, false, line.given());
  const Document document = document_from_options(options);
  if (document == Document::none) return simulate(options, line.case_name());
  const std::string text = document == Document::options ? document_options(options.comm()) : quantities(options);
  if (rank_of(options.comm()) == 0) std::cout << text;
}

}  // namespace
}  // namespace washfsi

int main(int argc, char** argv) {
  return washfsi::run_program("washfsi", [&] {
    washfsi::CommandLine line(MPI_COMM_WORLD, argc, argv, washfsi::preset_options());
    if (line.asks_for_version()) return washfsi::print_version();
    WASH_PETSC(PetscInitialize(&line.count(), &line.words(), nullptr, washfsi::help_text));
    (void)std::signal(SIGPIPE, SIG_IGN);  // a reader that has seen enough does not end a run
    washfsi::run_or_document(line);
  });
}
