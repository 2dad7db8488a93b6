// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/petsc_options.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "washfsi/support/petsc.hpp"

namespace washfsi {

bool is_option_name(const std::string& word) {
  const std::string name = word.starts_with("--") ? word.substr(1) : word;
  if (name.size() < 2 || name[0] != '-' || !std::isalpha(static_cast<unsigned char>(name[1]))) return false;
  char* end = nullptr;
  (void)std::strtod(name.c_str(), &end);  // -inf is a value
  return end == name.c_str() || *end == '_' || std::isalnum(static_cast<unsigned char>(*end));
}

std::map<std::string, std::string> options_in_database() {
  char* text = nullptr;
  WASH_PETSC(PetscOptionsGetAll(nullptr, &text));
  std::map<std::string, std::string> entries;
  std::istringstream words(text);
  std::string key;
  for (std::string word; words >> word;) {
    if (is_option_name(word))
      entries[key = word.substr(1)];
    else if (!key.empty())
      entries[key] += (entries[key].empty() ? "" : " ") + word;
  }
  (void)PetscFree(text);
  return entries;
}

bool belongs_to_petsc(const std::string& name) {
  static constexpr std::array<std::string_view, 40> starts{
      "log_",      "options_", "malloc", "memory_",  "info",      "help",     "version",  "citations",
      "on_error_", "fp_trap",  "check_", "error_",   "no_signal", "start_in", "stop_for", "debugger_",
      "get_total", "mpi_",     "petsc_", "objects_", "python",    "display",  "x_",       "draw_",
      "viewer_",   "vec_",     "mat_",   "is_",      "sf_",       "dm_",      "da_",      "pc_",
      "ksp_",      "snes_",    "ts_",    "tao_",     "use_gpu",   "device_",  "cuda_",    "saws_"};
  return std::any_of(starts.begin(), starts.end(), [&](std::string_view start) { return name.starts_with(start); });
}

bool is_read_after_solving(const std::string& name) {
  static constexpr std::array<std::string_view, 4> prefixes{"momentum_", "pressure_", "walls_", "cloth_"};
  static constexpr std::array<std::string_view, 6> reports{"ksp_view",         "pc_view",        "snes_view",
                                                           "converged_reason", "converged_rate", "final_residual"};
  const auto starts = [&](std::string_view prefix) { return name.starts_with(prefix); };
  const auto contains = [&](std::string_view report) { return name.find(report) != std::string::npos; };
  return std::any_of(prefixes.begin(), prefixes.end(), starts) && std::any_of(reports.begin(), reports.end(), contains);
}

bool lacks_prefix(const std::string& name) {
  static constexpr std::array<std::string_view, 5> starts{"pc_", "ksp_", "snes_", "ts_", "tao_"};
  return std::any_of(starts.begin(), starts.end(), [&](std::string_view start) { return name.starts_with(start); });
}

bool is_for_petsc(const std::string& name) {
  static constexpr std::array<std::string_view, 16> ours{
      "momentum_ksp_", "momentum_pc_",  "momentum_sub_",      "momentum_mat_",     "pressure_ksp_", "pressure_pc_",
      "pressure_mg_",  "pressure_mat_", "walls_overlap_ksp_", "walls_overlap_pc_", "walls_ksp_",    "walls_pc_",
      "cloth_snes_",   "cloth_ksp_",    "cloth_pc_",          "cloth_mat_"};
  return belongs_to_petsc(name) ||
         std::any_of(ours.begin(), ours.end(), [&](std::string_view start) { return name.starts_with(start); });
}

}  // namespace washfsi
