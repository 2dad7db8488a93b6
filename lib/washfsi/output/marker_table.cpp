// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/marker_table.hpp"

#include "washfsi/output/history.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/hdf5_file.hpp"

namespace washfsi {

namespace {

// One line of text per marker of this rank.
template <int Dim>
std::string rows_of_rank(const Cloths<Dim>& cloths, const Points<Dim>& positions, const Points<Dim>& velocities) {
  std::vector<PetscInt> number_in_group;
  std::vector<PetscInt> seen(cloths.groups().size(), 0);
  for (const Piece& piece : cloths.pieces()) number_in_group.push_back(seen[piece.group]++);
  const std::vector<std::size_t>& piece_of = cloths.piece_of_marker();
  std::string text;
  for (std::size_t m = 0; m < piece_of.size(); ++m) {
    const Piece& piece = cloths.pieces()[piece_of[m]];
    const PetscInt number = cloths.begin() + static_cast<PetscInt>(m) - piece.first;
    const PetscInt width = cloths.groups()[piece.group].markers[1];
    text += cloths.groups()[piece.group].name + "," + std::to_string(number_in_group[piece_of[m]]) + "," +
            std::to_string(number / width) + "," + std::to_string(number % width);
    for (int d = 0; d < Dim; ++d) text += "," + to_text(positions[m][d]);
    for (int d = 0; d < Dim; ++d) text += "," + to_text(velocities[m][d]);
    text += "\n";
  }
  return text;
}

// All ranks' texts on rank 0, in rank order.
std::string gather_text(MPI_Comm comm, const std::string& mine) {
  const auto ranks = static_cast<std::size_t>(ranks_of(comm));
  std::vector<int> lengths(ranks), starts(ranks, 0);
  const int length = static_cast<int>(mine.size());
  MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, comm);
  for (std::size_t r = 1; r < ranks; ++r) starts[r] = starts[r - 1] + lengths[r - 1];
  std::string all(static_cast<std::size_t>(starts.back() + lengths.back()), ' ');
  MPI_Gatherv(mine.data(), length, MPI_CHAR, all.data(), lengths.data(), starts.data(), MPI_CHAR, 0, comm);
  return all;
}

}  // namespace

template <int Dim>
void write_marker_table(MPI_Comm comm, const std::string& path, const Cloths<Dim>& cloths, const Points<Dim>& positions,
                        const Points<Dim>& velocities) {
  const std::string names = Dim == 2 ? "group,cloth,i,j,x,y,u,v\n# -,-,-,-,m,m,m/s,m/s\n"
                                     : "group,cloth,i,j,x,y,z,u,v,w\n# -,-,-,-,m,m,m,m/s,m/s,m/s\n";
  write_text_file(comm, path, names + gather_text(comm, rows_of_rank(cloths, positions, velocities)));
}

template void write_marker_table<2>(MPI_Comm, const std::string&, const Cloths<2>&, const Points<2>&, const Points<2>&);
template void write_marker_table<3>(MPI_Comm, const std::string&, const Cloths<3>&, const Points<3>&, const Points<3>&);

}  // namespace washfsi
