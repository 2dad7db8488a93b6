// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/size_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <unistd.h>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/format_text.hpp"

namespace washfsi {

namespace {

// Memory of all nodes on which the ranks run [B].
double memory_of_machine(MPI_Comm comm) {
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  const double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  const double all = ordered_sum(comm, rank_of(node) == 0 ? bytes : 0);
  MPI_Comm_free(&node);
  return all;
}

void refuse_beyond(double memory, double bytes, const std::string& what) {
  if (bytes <= memory) return;
  throw InputError(what +
                   format_text(": needs at least %.3g GB of memory; there are %.3g GB", bytes / 1e9, memory / 1e9));
}

void refuse_beyond_indices(double numbers, const std::string& what) {
  const double most = std::numeric_limits<PetscInt>::max();
  if (numbers > most)
    throw InputError(what + ": " + to_text(numbers) + " unknowns, but this PETSc counts to " + to_text(most));
}

// Pairs of markers of one cloth whose deltas overlap: a lower bound of the entries of the mobility matrix.
template <int Dim>
double overlapping_pairs(const ClothGroup<Dim>& group, const DeltaOptions& delta, const Point<Dim>& spacing) {
  const double reach = (delta.spread_width + delta.interpolate_width) * spacing.minCoeff();
  double near = 1, markers = static_cast<double>(group.count);
  for (int d = 0; d < 2; ++d) {
    const auto count = static_cast<double>(group.markers[d]);
    const double share = std::min(1.0, reach / group.size[d]);
    if (count > 1) near *= 1 + (2 - share) * share * (count - 1);  // less beside the edges
    markers *= count;
  }
  return near * markers;
}

template <int Dim>
std::string text_of(const Index<Dim>& counts) {
  std::vector<std::string> words;
  for (const PetscInt n : counts) words.push_back(std::to_string(n));
  return join(words, ",");
}

}  // namespace

template <int Dim>
void refuse_what_cannot_fit(MPI_Comm comm, const CaseOptions<Dim>& options) {
  // About 20 numbers per face and 20 per cell are stored; per marker the rows of its stiffness, with 5 or 25 blocks.
  constexpr double of_cell = 8 * (20 * Dim + 20), of_marker = (Dim == 2 ? 5 : 25) * Dim * Dim * 12;
  const double memory = memory_of_machine(comm);
  double cells = 1;
  for (const PetscInt n : options.model.grid.shape.cells) cells *= static_cast<double>(n);
  const std::string grid = "-grid_cells " + text_of<Dim>(options.model.grid.shape.cells);
  refuse_beyond_indices(Dim * cells, grid);
  refuse_beyond(memory, of_cell * cells, grid);
  const bool has_matrix = options.model.medium == Medium::water && options.coupling.scheme == "semi_implicit" &&
                          options.coupling.mobility == Mobility::matrix;
  constexpr double of_pair = 60;  // measured: the pair, and its part in the matrix that is solved
  double markers = 0, pairs = 0;
  for (const ClothGroup<Dim>& group : options.model.cloths) {
    const std::string what = "-" + group.name + "_markers " + std::to_string(group.markers[0]) +
                             (Dim == 3 ? "," + std::to_string(group.markers[1]) : "") + " of -" + group.name +
                             "_count " + std::to_string(group.count);
    markers += static_cast<double>(group.markers[0]) * static_cast<double>(group.markers[1]) *
               static_cast<double>(group.count);
    refuse_beyond_indices(Dim * markers, what);
    if (has_matrix) pairs += overlapping_pairs<Dim>(group, options.model.delta, options.model.grid.shape.spacing());
    refuse_beyond(memory, of_cell * cells + of_marker * markers + of_pair * pairs, what);
  }
}

template void refuse_what_cannot_fit<2>(MPI_Comm, const CaseOptions<2>&);
template void refuse_what_cannot_fit<3>(MPI_Comm, const CaseOptions<3>&);

}  // namespace washfsi
