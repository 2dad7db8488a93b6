// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/frame_folder.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/first_rank.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

std::string six_digits(long number) {
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits;
}

std::string file_of(long number) {
  return "/" + six_digits(number) + ".h5";
}

// The frames' numbers, from the names of their files.
std::vector<long> numbers_in(const std::string& folder) {
  std::vector<long> numbers;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    const bool digits =
        stem.size() >= 6 && stem.size() < 18 && stem.find_first_not_of("0123456789") == std::string::npos;
    if (digits && entry.path().extension() == ".h5" && six_digits(std::stol(stem)) == stem)
      numbers.push_back(std::stol(stem));
  }
  std::ranges::sort(numbers);
  return numbers;
}

// Frames of rank 0 on every rank.
std::vector<Frame> shared(MPI_Comm comm, std::vector<Frame> frames) {
  unsigned long long count = frames.size();
  MPI_Bcast(&count, 1, MPI_UNSIGNED_LONG_LONG, 0, comm);
  frames.resize(count);
  MPI_Bcast(frames.data(), static_cast<int>(count * sizeof(Frame)), MPI_BYTE, 0, comm);
  return frames;
}

}  // namespace

FrameFolder::FrameFolder(MPI_Comm comm, std::string folder, std::string name, long restart_step, Attributes attributes,
                         std::vector<std::string> constants)
    : comm_(comm),
      folder_(std::move(folder)),
      name_(std::move(name)),
      attributes_(std::move(attributes)),
      constants_(std::move(constants)) {
  on_first_rank<FileError>(comm_, [&] {
    const std::string index = path(".h5");
    if (restart_step >= 0 && std::filesystem::exists(index) && !std::filesystem::exists(path("")))
      set_aside(index, index + ": has its frames within, as earlier versions wrote them");
    std::filesystem::create_directories(path(""));
    remove_parts(path(""));
    for (const long number : numbers_in(path(""))) keep_or_remove(number, restart_step);
  });
  frames_ = shared(comm_, std::move(frames_));
  if (!is_new()) write_index();
}

// Keeps a frame of an earlier run that is not later than a step. Renames a damaged one.
void FrameFolder::keep_or_remove(long number, long restart_step) {
  const std::string file = path(file_of(number));
  try {
    if (restart_step >= 0) {
      Hdf5File frame(MPI_COMM_SELF, file, Hdf5File::Mode::read);
      if (frame.attribute("/", "step") <= static_cast<double>(restart_step)) {
        frames_.push_back({number, frame.attribute("/", "time")});
        return;
      }
    }
    std::filesystem::remove(file);
  } catch (const InputError& error) {
    set_aside(file, error.what());
  }
}

void FrameFolder::set_aside(const std::string& file, const std::string& why) {
  std::filesystem::rename(file, file + ".damaged");
  std::fprintf(stderr, "note: %s; it is kept as %s.damaged\n", why.c_str(), file.c_str());
}

void FrameFolder::write_constants(const std::function<void(Hdf5File&)>& write) const {
  write_whole(path("/constants.h5"), write);
}

void FrameFolder::add(double time, long step, const std::function<void(Hdf5File&)>& write,
                      const std::function<std::string(const Frame&)>& describe, Parts parts) {
  const Frame frame{frames_.empty() ? 0 : frames_.back().number + 1, time};
  write_whole(path(file_of(frame.number)), [&](Hdf5File& file) {
    write(file);
    file.set_attribute("/", "time", time);
    file.set_attribute("/", "step", static_cast<double>(step));
  });
  frames_.push_back(frame);
  write_index();
  describe_all(describe, parts);
}

// Writes under another name until the file is complete and on disk.
void FrameFolder::write_whole(const std::string& file, const std::function<void(Hdf5File&)>& write) const {
  const std::string temporary = file + ".part";
  Hdf5File part(comm_, temporary, Hdf5File::Mode::create);
  write(part);
  part.close();
  if (any_rank(comm_, rank_of(comm_) == 0 && !commit_file(temporary, file)))
    throw FileError(file + ": cannot be written (is the disk full?)");
}

// NAME.h5, which a restart writes anew from the files of the frames: it need not reach the disk with each frame.
void FrameFolder::write_index() const {
  on_first_rank<FileError>(comm_, [&] {
    const std::string temporary = path(".h5.part");
    Hdf5File index(MPI_COMM_SELF, temporary, Hdf5File::Mode::create);
    for (const auto& [attribute, value] : attributes_) index.set_attribute("/", attribute, value);
    for (const std::string& constant : constants_) index.link(constant, name_ + "/constants.h5", constant);
    index.create_group("/frames");
    for (const Frame& frame : frames_)
      index.link("/frames/" + six_digits(frame.number), name_ + file_of(frame.number), "/");
    index.close();
    std::filesystem::rename(temporary, path(".h5"));
  });
}

// NAME.xdmf, which the next frame writes anew: it need not reach the disk with each frame either.
void FrameFolder::describe_all(const std::function<std::string(const Frame&)>& describe, Parts parts) const {
  const std::string type = parts == Parts::one ? "Uniform" : "Collection\" CollectionType=\"Spatial";
  std::string text = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n<Grid Name=\"" + name_ +
                     "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const Frame& frame : frames_)
    text += "<Grid Name=\"" + name_ + "\" GridType=\"" + type + "\">\n<Time Value=\"" + to_text(frame.time) + "\"/>\n" +
            describe(frame) + "</Grid>\n";
  text += "</Grid>\n</Domain>\n</Xdmf>\n";
  write_text_file(comm_, path(".xdmf"), text, Reach::system);
}

std::string FrameFolder::item(const std::string& place, const std::vector<hsize_t>& shape,
                              const std::string& type) const {
  std::vector<std::string> dims;
  for (const hsize_t n : shape) dims.push_back(std::to_string(n));
  return "<DataItem Format=\"HDF\" " + type + " Dimensions=\"" + join(dims, " ") + "\">" + name_ + place +
         "</DataItem>\n";
}

std::string FrameFolder::frame_item(const Frame& frame, const std::string& dataset,
                                    const std::vector<hsize_t>& shape) const {
  return item(file_of(frame.number) + ":" + dataset, shape, float_type);
}

std::string FrameFolder::constant_item(const std::string& dataset, const std::vector<hsize_t>& shape,
                                       const std::string& type) const {
  return item("/constants.h5:" + dataset, shape, type);
}

std::string xdmf_attribute(const std::string& attribute, const std::string& type, const std::string& center,
                           const std::string& data_item) {
  return "<Attribute Name=\"" + attribute + "\" AttributeType=\"" + type + "\" Center=\"" + center + "\">" + data_item +
         "</Attribute>\n";
}

void write_with_unit(Hdf5File& file, const std::string& dataset, const std::string& unit, const Slab& slab,
                     const std::vector<double>& values) {
  file.write(dataset, slab, values);
  file.set_text(dataset, "unit", unit);
}

}  // namespace washfsi
