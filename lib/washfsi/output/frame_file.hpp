// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "washfsi/support/hdf5_file.hpp"

namespace washfsi {

/// One moment of a series.
struct Frame {
  std::string group;  ///< "/frames/000012" in the HDF5 file
  double time = 0;    ///< [s]
};

/// A time series that ParaView opens: NAME.h5 with the data and NAME.xdmf that describes it. The HDF5 file is closed
/// between frames, so that what was written survives a crash. All members are collective.
class FrameFile {
 public:
  /// Starts a new series, or continues one up to and including `restart_step` (frames after it are dropped).
  FrameFile(MPI_Comm comm, std::string folder, std::string name, long restart_step);

  /// Whether the series holds no frame yet, so that what does not change must still be written.
  bool is_new() const { return frames_.empty(); }
  /// Opens the file for what does not change in time.
  Hdf5File open() const { return Hdf5File(comm_, path(), Hdf5File::Mode::append); }

  /// Adds a frame: `write(file, group)` writes its datasets, `describe(frame)` gives its XDMF grid element.
  void add(double time, long step, const std::function<void(Hdf5File&, const std::string&)>& write,
           const std::function<std::string(const Frame&)>& describe);

 private:
  void keep_until(long restart_step);
  void set_aside(const std::string& why);
  std::string path() const { return folder_ + "/" + name_ + ".h5"; }

  MPI_Comm comm_;
  std::string folder_, name_;
  std::vector<Frame> frames_;
};

/// XDMF text of a dataset in `name`.h5.
std::string xdmf_data_item(const std::string& name, const std::string& dataset, const std::vector<hsize_t>& shape,
                           const std::string& type = "NumberType=\"Float\" Precision=\"8\"");
/// XDMF text of an attribute on cells or nodes.
std::string xdmf_attribute(const std::string& attribute, const std::string& type, const std::string& center,
                           const std::string& data_item);

}  // namespace washfsi
