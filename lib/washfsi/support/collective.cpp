// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/collective.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace washfsi {

int rank_of(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}

int ranks_of(MPI_Comm comm) {
  int size = 0;
  MPI_Comm_size(comm, &size);
  return size;
}

std::vector<double> ordered_sum(MPI_Comm comm, const std::vector<double>& values) {
  const std::size_t n = values.size();
  std::vector<double> all(n * static_cast<std::size_t>(ranks_of(comm)));
  MPI_Allgather(values.data(), static_cast<int>(n), MPI_DOUBLE, all.data(), static_cast<int>(n), MPI_DOUBLE, comm);
  std::vector<double> sum(n, 0.0);
  for (std::size_t i = 0; i < all.size(); ++i) sum[i % n] += all[i];
  return sum;
}

double ordered_sum(MPI_Comm comm, double value) {
  return ordered_sum(comm, std::vector<double>{value})[0];
}

double largest(MPI_Comm comm, double value) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, comm);
  return value;
}

bool any_rank(MPI_Comm comm, bool mine) {
  int any = mine ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, comm);
  return any != 0;
}

std::string from_first_rank(MPI_Comm comm, const std::string& text) {
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, comm);
  std::string result = text;
  result.resize(static_cast<std::size_t>(length));
  MPI_Bcast(result.data(), length, MPI_CHAR, 0, comm);
  return result;
}

std::optional<std::string> file_from_first_rank(MPI_Comm comm, const std::string& path) {
  constexpr std::streamsize most = std::numeric_limits<int>::max() - 1;  // largest size of one broadcast
  std::string marked = "-";
  if (rank_of(comm) == 0) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();  // a folder can be opened, but not read
    if (file.is_open() && !std::filesystem::is_directory(path) && content.tellp() < most)
      marked = "+" + std::move(content).str();
  }
  marked = from_first_rank(comm, marked);
  if (marked[0] == '-') return std::nullopt;
  return marked.substr(1);
}

Located largest(MPI_Comm comm, const Located& mine) {
  struct {
    double value;
    int rank;
  } candidate{mine.value, rank_of(comm)}, winner{};
  MPI_Allreduce(&candidate, &winner, 1, MPI_DOUBLE_INT, MPI_MAXLOC, comm);
  Located result = mine;
  MPI_Bcast(&result, sizeof(Located), MPI_BYTE, winner.rank, comm);
  return result;
}

}  // namespace washfsi
