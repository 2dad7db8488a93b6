// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/shared_file.hpp"

#include "washfsi/output/frame_folder.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

// Rank 0 writes it.
void SharedFile::write(const std::string& name, const std::string& unit, const std::vector<hsize_t>& shape,
                       const std::vector<double>& values) const {
  const std::vector<hsize_t> none(shape.size(), 0);
  const bool writes = rank_of(comm_) == 0;
  write_with_unit(file_, name, unit, {shape, none, writes ? shape : none}, writes ? values : std::vector<double>());
}

void write_shared_file(MPI_Comm comm, const std::string& path, const std::function<void(const SharedFile&)>& fill) {
  const std::string temporary = path + ".part";
  Hdf5File file(comm, temporary, Hdf5File::Mode::create);
  fill({comm, file});
  file.close();
  const bool committed = rank_of(comm) != 0 || commit_file(temporary, path);
  if (any_rank(comm, !committed)) throw FileError(path + ": cannot be written");
}

}  // namespace washfsi
