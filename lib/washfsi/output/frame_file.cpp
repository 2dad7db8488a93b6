// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/frame_file.hpp"

#include <cstdio>
#include <filesystem>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

std::string six_digits(std::size_t number) {
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits;
}

}  // namespace

FrameFile::FrameFile(MPI_Comm comm, std::string folder, std::string name, long restart_step)
    : comm_(comm), folder_(std::move(folder)), name_(std::move(name)) {
  const bool exists = any_rank(comm_, rank_of(comm_) == 0 && std::filesystem::exists(path()));
  if (restart_step >= 0 && exists) {
    try {
      keep_until(restart_step);
    } catch (const FileError& error) {
      set_aside(error.what());
    }
  }
  if (!frames_.empty()) return;
  Hdf5File file(comm_, path(), Hdf5File::Mode::create);
  file.create_group("/frames");
  file.close();
}

// A run that was killed while HDF5 wrote may leave a file that HDF5 does not read.
void FrameFile::set_aside(const std::string& why) {
  frames_.clear();
  std::error_code ignored;
  if (rank_of(comm_) == 0) {
    std::filesystem::rename(path(), path() + ".damaged", ignored);
    std::fprintf(stderr, "note: %s; it is kept as %s.h5.damaged, and the series begins anew\n", why.c_str(),
                 name_.c_str());
  }
  MPI_Barrier(comm_);
}

void FrameFile::keep_until(long restart_step) {
  Hdf5File file = open();
  for (const std::string& member : file.members("/frames")) {
    const std::string group = "/frames/" + member;
    // a frame gets its step last: without it, it is not finished
    if (!file.has_attribute(group, "step") || file.attribute(group, "step") > static_cast<double>(restart_step))
      file.remove(group);
    else
      frames_.push_back({group, file.attribute(group, "time")});
  }
  file.close();
}

void FrameFile::add(double time, long step, const std::function<void(Hdf5File&, const std::string&)>& write,
                    const std::function<std::string(const Frame&)>& describe) {
  frames_.push_back({"/frames/" + six_digits(frames_.size()), time});
  Hdf5File file = open();
  file.create_group(frames_.back().group);
  write(file, frames_.back().group);
  file.set_attribute(frames_.back().group, "time", time);
  file.set_attribute(frames_.back().group, "step", static_cast<double>(step));
  file.close();

  std::string text = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n<Grid Name=\"" + name_ +
                     "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const Frame& frame : frames_)
    text += "<Grid Name=\"" + name_ + "\" GridType=\"Uniform\">\n<Time Value=\"" + to_text(frame.time) + "\"/>\n" +
            describe(frame) + "</Grid>\n";
  text += "</Grid>\n</Domain>\n</Xdmf>\n";
  write_text_file(comm_, folder_ + "/" + name_ + ".xdmf", text);
}

std::string xdmf_data_item(const std::string& name, const std::string& dataset, const std::vector<hsize_t>& shape,
                           const std::string& type) {
  std::vector<std::string> dims;
  for (const hsize_t n : shape) dims.push_back(std::to_string(n));
  return "<DataItem Format=\"HDF\" " + type + " Dimensions=\"" + join(dims, " ") + "\">" + name + ".h5:" + dataset +
         "</DataItem>\n";
}

std::string xdmf_attribute(const std::string& attribute, const std::string& type, const std::string& center,
                           const std::string& data_item) {
  return "<Attribute Name=\"" + attribute + "\" AttributeType=\"" + type + "\" Center=\"" + center + "\">" + data_item +
         "</Attribute>\n";
}

}  // namespace washfsi
