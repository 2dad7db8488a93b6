// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/document.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "washfsi/simulation/simulation.hpp"

namespace washfsi {

const ChoiceNames<Document>& names_of(Document) {
  static const ChoiceNames<Document> names{
      {"none", Document::none}, {"options", Document::options}, {"quantities", Document::quantities}};
  return names;
}

Document document_from_options(Options& options) {
  Document document = Document::none;
  options.block("", "Documents", [&](OptionBlock& block) {
    block.choice("document", document, "print what there is, in Markdown, and end");
  });
  return document;
}

namespace {

// An option in the plane and in space; one of them may be missing.
using DocumentedOption = std::array<const DeclaredOption*, 2>;

const DeclaredOption& any_of(const DocumentedOption& option) {
  return option[1] ? *option[1] : *option[0];
}

// Merges both lists; options in space only are placed after the option that they follow there. Laws of fabric have
// options of the same name, each in its block.
std::vector<DocumentedOption> merge(const std::array<std::vector<DeclaredOption>, 2>& declared) {
  std::vector<DocumentedOption> merged;
  for (std::size_t dimension = 0; dimension < 2; ++dimension) {
    auto place = merged.begin();
    for (const DeclaredOption& option : declared[dimension]) {
      const auto same = std::find_if(merged.begin(), merged.end(), [&](const DocumentedOption& known) {
        return any_of(known).name == option.name && any_of(known).block == option.block;
      });
      place = same == merged.end() ? merged.insert(place, DocumentedOption{}) : same;
      if (!(*place)[dimension]) (*place)[dimension] = &option;
      ++place;
    }
  }
  return merged;
}

// The text common to plane and space, or both texts.
std::string both_texts(const DocumentedOption& option, const std::function<std::string(const DeclaredOption&)>& text) {
  if (!option[0] || !option[1]) return text(any_of(option));
  const std::string plane = text(*option[0]), space = text(*option[1]);
  return plane == space ? plane : plane + "; 3D: " + space;
}

// Choices are listed one by one: a bar would end a table's cell.
std::string values_text(const DeclaredOption& option) {
  std::string allowed = option.allowed;
  for (std::size_t bar = 0; (bar = allowed.find('|', bar)) != std::string::npos;) allowed.replace(bar, 1, ", ");
  return allowed;
}

std::string default_text(const DeclaredOption& option) {
  return option.required ? "required" : option.value;
}

std::string row(const DocumentedOption& option) {
  const std::string only = !option[1] ? "2D only: " : !option[0] ? "3D only: " : "";
  const DeclaredOption& any = any_of(option);
  return "| `-" + any.name + "` | " + any.unit + " | " + both_texts(option, values_text) + " | " +
         both_texts(option, default_text) + " | " + only + any.meaning + " |\n";
}

// All options that are read for runs in Dim dimensions, with their defaults.
template <int Dim>
Options declare_all(MPI_Comm comm) {
  WASH_PETSC(PetscOptionsClear(nullptr));
  WASH_PETSC(PetscOptionsSetValue(nullptr, "-grid_cells", Dim == 2 ? "64,64" : "64,64,64"));
  Options options(comm, true);
  (void)document_from_options(options);
  const Simulation<Dim> nothing(options, "");
  return options;
}

std::string old_names_text(const std::vector<std::pair<std::string, std::string>>& aliases) {
  std::string text =
      "\n## Old names\n\nThey still hold, and a note tells the present one.\n\n| old | now |\n|---|---|\n";
  for (const auto& [old_name, name] : aliases) text += "| `-" + old_name + "` | `-" + name + "` |\n";
  return text;
}

}  // namespace

std::string document_options(MPI_Comm comm) {
  const Options plane = declare_all<2>(comm), space = declare_all<3>(comm);
  const std::array declared{plane.known().declared.list(), space.known().declared.list()};
  std::string text, block;
  for (const DocumentedOption& option : merge(declared)) {
    if (block != any_of(option).block) {
      block = any_of(option).block;
      text += (text.empty() ? "## " : "\n## ") + block + "\n\n| option | unit | values | default | meaning |\n" +
              "|---|---|---|---|---|\n";
    }
    text += row(option);
  }
  return text + old_names_text(space.known().old_names.all());
}

template <int Dim>
std::string document_quantities(Options& options) {
  const auto chosen = CaseOptions<Dim>::from_options(options);
  auto bodies = bodies_from_options<Dim>(options, chosen.model.grid.shape.spacing().minCoeff());
  const auto system = start_system<Dim>(options.comm(), chosen, std::move(bodies));
  const Measures<Dim> measures(*system, chosen.measure);
  return measures.quantities().document() + "\nOf a cycle, in `cycles.csv`:\n\n" + measures.cycles().document();
}

template std::string document_quantities<2>(Options&);
template std::string document_quantities<3>(Options&);

}  // namespace washfsi
