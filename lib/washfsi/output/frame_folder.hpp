// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "washfsi/support/hdf5_file.hpp"

namespace washfsi {

/// One moment of a series.
struct Frame {
  long number = 0;
  double time = 0;  ///< time of the frame [s]
};

/// A time series for ParaView. Each frame is a file of its own, NAME/000012.h5, which exists completely or not at all;
/// NAME.h5 links to them as `/frames/000012`, NAME.xdmf describes them. All members are collective. Errors: FileError.
class FrameFolder {
 public:
  /// Attributes of NAME.h5.
  using Attributes = std::vector<std::pair<std::string, double>>;

  /// Starts a new series, or continues one up to and including `restart_step` (frames after it are removed).
  /// `constants` are the datasets that do not change in time, which NAME.h5 has at its root.
  FrameFolder(MPI_Comm comm, std::string folder, std::string name, long restart_step, Attributes attributes,
              std::vector<std::string> constants);

  /// Whether the series has no frame yet.
  bool is_new() const { return frames_.empty(); }

  /// Writes the data that do not change in time into NAME/constants.h5.
  void write_constants(const std::function<void(Hdf5File&)>& write) const;

  /// Whether a frame's XDMF describes one grid, or consists of several elements `Grid`.
  enum class Parts { one, several };

  /// Adds a frame: `write(file)` writes its datasets, `describe(frame)` returns the content of its XDMF grid element.
  void add(double time, long step, const std::function<void(Hdf5File&)>& write,
           const std::function<std::string(const Frame&)>& describe, Parts parts = Parts::one);

  /// XDMF text of a dataset of a frame, or of a constant one.
  std::string frame_item(const Frame& frame, const std::string& dataset, const std::vector<hsize_t>& shape) const;
  std::string constant_item(const std::string& dataset, const std::vector<hsize_t>& shape,
                            const std::string& type = float_type) const;

 private:
  static constexpr const char* float_type = "NumberType=\"Float\" Precision=\"8\"";
  std::string path(const std::string& file) const { return folder_ + "/" + name_ + file; }
  std::string item(const std::string& place, const std::vector<hsize_t>& shape, const std::string& type) const;
  void keep_or_remove(long number, long restart_step);
  static void set_aside(const std::string& file, const std::string& why);
  void write_whole(const std::string& file, const std::function<void(Hdf5File&)>& write) const;
  void write_index() const;
  void describe_all(const std::function<std::string(const Frame&)>& describe, Parts parts) const;

  MPI_Comm comm_;
  std::string folder_, name_;
  Attributes attributes_;
  std::vector<std::string> constants_;
  std::vector<Frame> frames_;
};

/// Writes a dataset with its unit beside it, as the attribute `unit`. Collective. Errors: FileError.
void write_with_unit(Hdf5File& file, const std::string& dataset, const std::string& unit, const Slab& slab,
                     const std::vector<double>& values);

/// XDMF text of an attribute on cells or nodes.
std::string xdmf_attribute(const std::string& attribute, const std::string& type, const std::string& center,
                           const std::string& data_item);

}  // namespace washfsi
