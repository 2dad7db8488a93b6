// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/hdf5_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

/// Closes an HDF5 identifier at the end of its scope.
class Identifier {
 public:
  Identifier(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Identifier() {
    if (id_ >= 0) (void)close_(id_);
  }
  Identifier(Identifier&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Identifier(const Identifier&) = delete;
  Identifier& operator=(const Identifier&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

Identifier memory_space(const Slab& slab) {
  return {H5Screate_simple(static_cast<int>(slab.count.size()), slab.count.data(), nullptr), H5Sclose};
}

bool empty(const Slab& slab) {
  return std::find(slab.count.begin(), slab.count.end(), hsize_t{0}) != slab.count.end();
}

// Selects the slab in a file space and everything in a memory space, or nothing in both.
bool select(hid_t file_space, hid_t memory, const Slab& slab) {
  if (empty(slab)) return H5Sselect_none(file_space) >= 0 && H5Sselect_none(memory) >= 0;
  return H5Sselect_hyperslab(file_space, H5S_SELECT_SET, slab.offset.data(), nullptr, slab.count.data(), nullptr) >= 0;
}

// A file of one rank needs no MPI, which opens and closes files slowly.
bool is_shared(MPI_Comm comm) {
  return ranks_of(comm) > 1;
}

Identifier transfer_of(MPI_Comm comm) {
  Identifier transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  if (is_shared(comm)) (void)H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
  return transfer;
}

}  // namespace

Hdf5File::Hdf5File(MPI_Comm comm, const std::string& path, Mode mode) : comm_(comm), path_(path), mode_(mode) {
  (void)H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // we report errors ourselves, in one line
  const Identifier access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (is_shared(comm))
    (void)H5Pset_fapl_mpio(access, comm, MPI_INFO_NULL);
  else
    (void)H5Pset_sieve_buf_size(access, 0);        // errors when its buffer is flushed are not reported
  (void)H5Pset_file_locking(access, false, true);  // not every file system has locks; no other process writes this file
  if (mode == Mode::create)
    file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  else
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  agree(file_ >= 0, "cannot be opened as an HDF5 file");
}

Hdf5File::~Hdf5File() {
  // Closing is collective: while an exception unwinds, other ranks may not be here.
  if (file_ >= 0 && std::uncaught_exceptions() == 0) (void)H5Fclose(file_);
}

void Hdf5File::agree(bool succeeded, const std::string& what) const {
  if (!any_rank(comm_, !succeeded)) return;
  if (mode_ == Mode::read) throw InputError(path_ + ": " + what);
  throw FileError(path_ + ": " + what);
}

void Hdf5File::write(const std::string& dataset, const Slab& slab, hid_t type, const void* values) {
  const Identifier space(H5Screate_simple(static_cast<int>(slab.shape.size()), slab.shape.data(), nullptr), H5Sclose);
  const Identifier link(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  (void)H5Pset_create_intermediate_group(link, 1);
  const Identifier set(H5Dcreate2(file_, dataset.c_str(), type, space, link, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  agree(set >= 0, "cannot write " + dataset);
  const Identifier memory = memory_space(slab);
  const bool written =
      select(space, memory, slab) && H5Dwrite(set, type, memory, space, transfer_of(comm_), values) >= 0;
  agree(written, "cannot write " + dataset + " (is the disk full?)");
}

void Hdf5File::write(const std::string& dataset, const Slab& slab, const std::vector<double>& values) {
  write(dataset, slab, H5T_NATIVE_DOUBLE, values.data());
}

void Hdf5File::write(const std::string& dataset, const Slab& slab, const std::vector<long long>& values) {
  write(dataset, slab, H5T_NATIVE_LLONG, values.data());
}

bool Hdf5File::has(const std::string& dataset) {
  htri_t found = 1;
  for (std::size_t end = dataset.find('/', 1); found > 0; end = dataset.find('/', end + 1)) {
    found = H5Lexists(file_, dataset.substr(0, end).c_str(), H5P_DEFAULT);
    if (end == std::string::npos) break;
  }
  agree(found >= 0, "cannot be searched for " + dataset);
  return found > 0;
}

std::vector<hsize_t> Hdf5File::shape(const std::string& dataset) {
  const Identifier set(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  agree(set >= 0, "has no dataset " + dataset);
  const Identifier space(H5Dget_space(set), H5Sclose);
  std::vector<hsize_t> dims(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
  (void)H5Sget_simple_extent_dims(space, dims.data(), nullptr);
  return dims;
}

std::vector<double> Hdf5File::read(const std::string& dataset, const Slab& slab) {
  agree(shape(dataset) == slab.shape, "dataset " + dataset + " has another shape than this run's");
  const Identifier set(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  const Identifier space(H5Dget_space(set), H5Sclose);
  const Identifier memory = memory_space(slab);
  const hsize_t size = std::accumulate(slab.count.begin(), slab.count.end(), hsize_t{1}, std::multiplies<>());
  std::vector<double> values(size);
  const bool done = select(space, memory, slab) &&
                    H5Dread(set, H5T_NATIVE_DOUBLE, memory, space, transfer_of(comm_), values.data()) >= 0;
  agree(done, "cannot read " + dataset);
  return values;
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  const Identifier space(H5Screate(H5S_SCALAR), H5Sclose);
  const Identifier attribute(H5Acreate_by_name(file_, object.c_str(), name.c_str(), H5T_NATIVE_DOUBLE, space,
                                               H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  agree(attribute >= 0 && H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value) >= 0, "cannot write attribute " + name);
}

void Hdf5File::set_text(const std::string& object, const std::string& name, const std::string& text) {
  const Identifier space(H5Screate(H5S_SCALAR), H5Sclose), type(H5Tcopy(H5T_C_S1), H5Tclose);
  const bool typed =
      H5Tset_size(type, std::max<std::size_t>(1, text.size())) >= 0 && H5Tset_cset(type, H5T_CSET_UTF8) >= 0;
  const Identifier attribute(
      H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  agree(typed && attribute >= 0 && H5Awrite(attribute, type, text.c_str()) >= 0, "cannot write attribute " + name);
}

namespace {

// Mixes the bits of two numbers (splitmix64's finaliser).
std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t x = a + 0x9e3779b97f4a7c15ULL * (b + 1);
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// A digest of the values with their places in the dataset: a sum, independent of the distribution over ranks.
std::uint64_t digest(MPI_Comm comm, const Slab& slab, const std::vector<double>& values) {
  std::uint64_t sum = 0;
  const std::size_t held = empty(slab) ? 0 : values.size();
  for (std::size_t n = 0; n < held; ++n) {
    std::uint64_t place = 0, stride = 1, rest = n;
    for (std::size_t d = slab.shape.size(); d-- > 0;) {
      place += stride * (slab.offset[d] + rest % slab.count[d]);
      stride *= slab.shape[d];
      rest /= slab.count[d];
    }
    sum += mixed(std::bit_cast<std::uint64_t>(values[n]), place);
  }
  std::uint64_t all = 0;
  MPI_Allreduce(&sum, &all, 1, MPI_UINT64_T, MPI_SUM, comm);
  return all;
}

// The digest is stored in two halves, which doubles represent exactly.
constexpr std::uint64_t half = 1ULL << 32;
constexpr const char *upper_digest = "digest_upper", *lower_digest = "digest_lower";

}  // namespace

void Hdf5File::write_sealed(const std::string& dataset, const Slab& slab, const std::vector<double>& values) {
  write(dataset, slab, values);
  const std::uint64_t sum = digest(comm_, slab, values);
  const std::uint64_t upper = sum / half, lower = sum % half;
  set_attribute(dataset, upper_digest, static_cast<double>(upper));
  set_attribute(dataset, lower_digest, static_cast<double>(lower));
}

std::vector<double> Hdf5File::read_sealed(const std::string& dataset, const Slab& slab, Readers readers) {
  std::vector<double> values = read(dataset, slab);
  const bool counts = readers == Readers::parts || rank_of(comm_) == 0;
  const std::uint64_t sum = digest(comm_, slab, counts ? values : std::vector<double>());
  const std::uint64_t upper = sum / half, lower = sum % half;
  const bool same = attribute(dataset, upper_digest) == static_cast<double>(upper) &&
                    attribute(dataset, lower_digest) == static_cast<double>(lower);
  agree(same, "dataset " + dataset + " is damaged: its digest is another");
  return values;
}

double Hdf5File::attribute(const std::string& object, const std::string& name) {
  double value = 0;
  const Identifier attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  agree(attribute >= 0, "has no attribute " + name);
  const Identifier space(H5Aget_space(attribute), H5Sclose), type(H5Aget_type(attribute), H5Tclose);
  const bool number = H5Sget_simple_extent_npoints(space) == 1 && H5Tget_class(type) == H5T_FLOAT;
  agree(number && H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) >= 0 && std::isfinite(value),
        "attribute " + name + " is not a finite number");
  return value;
}

void Hdf5File::create_group(const std::string& name) {
  const Identifier group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  agree(group >= 0, "cannot create group " + name);
}

void Hdf5File::link(const std::string& name, const std::string& file, const std::string& object) {
  const herr_t status = H5Lcreate_external(file.c_str(), object.c_str(), file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  agree(status >= 0, "cannot write the link " + name);
}

void Hdf5File::close() {
  if (file_ < 0) return;
  const herr_t status = H5Fclose(file_);
  file_ = -1;
  agree(status >= 0, "cannot be completed (is the disk full?)");
}

void make_writable_folder(MPI_Comm comm, const std::string& path) {
  bool writable = true;
  if (rank_of(comm) == 0) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    writable = std::filesystem::is_directory(path, error) && access(path.c_str(), W_OK) == 0;
  }
  if (any_rank(comm, !writable)) throw FileError("-output_dir " + path + ": this folder cannot be made or written to");
}

namespace {

bool synced(const std::string& path, int flags) {
  const int file = open(path.c_str(), flags);
  const bool done = file >= 0 && fsync(file) == 0;
  if (file >= 0) (void)::close(file);
  return done;
}

}  // namespace

bool commit_file(const std::string& temporary, const std::string& path, const std::string& keep) {
  if (!synced(temporary, O_RDONLY)) return false;
  std::error_code error;
  if (!keep.empty() && std::filesystem::exists(path)) {
    std::filesystem::remove(keep, error);
    std::filesystem::create_hard_link(path, keep, error);
    if (error)  // a file system without links, or one that did not remove
      std::filesystem::copy_file(path, keep, std::filesystem::copy_options::overwrite_existing, error);
    if (error || !synced(keep, O_RDONLY)) return false;
  }
  std::filesystem::rename(temporary, path, error);
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return !error && synced(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
}

void remove_parts(const std::string& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".part" || entry.path().string().find(".part.locktest.") != std::string::npos)
      std::filesystem::remove(entry.path(), ignored);  // the latter Open MPI's, of the former
}

void write_text_file(MPI_Comm comm, const std::string& path, const std::string& text, Reach reach) {
  bool written = true;
  if (rank_of(comm) == 0) {
    const std::string temporary = path + ".part";
    std::ofstream file(temporary);
    file << text;
    file.close();
    std::error_code error;
    if (file && reach == Reach::system) std::filesystem::rename(temporary, path, error);
    written = file && (reach == Reach::disk ? commit_file(temporary, path) : !error);
  }
  if (any_rank(comm, !written)) throw FileError(path + ": cannot be written");
}

}  // namespace washfsi
