// SPDX-License-Identifier: BSD-3-Clause
//
// Preloaded into washfsi: ends the process, or lets a call fail, at the Nth call that changes a file of one folder.
//
//   FAULT_FOLDER   calls on paths below it count
//   FAULT_AT       number of the call, from 1
//   FAULT_KIND     kill     SIGKILL before the call
//                  torn     SIGKILL after it, with half of what it wrote
//                  ENOSPC   it and all later ones that need room fail: a full disk
//                  EIO      it alone fails: a bad sector
//   FAULT_COUNT    file for the number of calls, written at the end

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string target_of(const std::string& link) {
  std::array<char, 4096> text{};
  const ssize_t length = readlink(link.c_str(), text.data(), text.size());
  return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length)) : "";
}

std::string path_of(int file) {
  return target_of("/proc/self/fd/" + std::to_string(file));
}

enum class Need { room, none };  // whether the call can meet a full disk

class Faults {
 public:
  Faults() {
    if (!target_of("/proc/self/exe").ends_with("/washfsi")) folder_.clear();  // mpirun's helpers inherit the library
  }
  ~Faults() {
    if (folder_.empty() || variable("FAULT_COUNT").empty()) return;
    const std::string file = variable("FAULT_COUNT");
    if (std::FILE* out = std::fopen(file.c_str(), "w")) {
      (void)std::fprintf(out, "%ld\n", count_);
      (void)std::fclose(out);
    }
  }
  Faults(const Faults&) = delete;
  Faults& operator=(const Faults&) = delete;

  /// Calls `real` with the fault that is due. `file`, if any, is what it writes to.
  template <class Call>
  auto around(const std::string& path, Need need, int file, Call real) -> decltype(real()) {
    if (folder_.empty() || !path.starts_with(folder_)) return real();
    ++count_;
    if (count_ == at_ && kind_ == "kill") (void)std::raise(SIGKILL);
    if (count_ == at_ && kind_ == "torn") tear(file, real);
    const bool full = kind_ == "ENOSPC" && count_ >= at_ && need == Need::room;
    if (full || (kind_ == "EIO" && count_ == at_)) {
      errno = full ? ENOSPC : EIO;
      return static_cast<decltype(real())>(-1);
    }
    return real();
  }

 private:
  static off_t size_of(int file) {
    struct stat status {};
    return file >= 0 && fstat(file, &status) == 0 ? status.st_size : 0;
  }

  template <class Call>
  static void tear(int file, Call real) {
    const off_t before = size_of(file);
    (void)real();
    const off_t after = size_of(file);
    if (after > before) (void)truncate(path_of(file).c_str(), before + (after - before) / 2);
    (void)std::raise(SIGKILL);
  }

  std::string folder_ = variable("FAULT_FOLDER"), kind_ = variable("FAULT_KIND");
  long at_ = std::atol(variable("FAULT_AT").c_str()), count_ = 0;
};

Faults& faults() {
  static Faults the_faults;
  return the_faults;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

constexpr int creates = O_CREAT | O_TRUNC;

}  // namespace

extern "C" {

ssize_t write(int file, const void* data, size_t size) {
  static auto* real = next<ssize_t(int, const void*, size_t)>("write");
  return faults().around(path_of(file), Need::room, file, [&] { return real(file, data, size); });
}

ssize_t pwrite(int file, const void* data, size_t size, off_t place) {
  static auto* real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  return faults().around(path_of(file), Need::room, file, [&] { return real(file, data, size, place); });
}

ssize_t pwrite64(int file, const void* data, size_t size, off64_t place) {
  return pwrite(file, data, size, place);
}

ssize_t writev(int file, const iovec* data, int count) {
  static auto* real = next<ssize_t(int, const iovec*, int)>("writev");
  return faults().around(path_of(file), Need::room, file, [&] { return real(file, data, count); });
}

ssize_t pwritev(int file, const iovec* data, int count, off_t place) {
  static auto* real = next<ssize_t(int, const iovec*, int, off_t)>("pwritev");
  return faults().around(path_of(file), Need::room, file, [&] { return real(file, data, count, place); });
}

ssize_t pwritev64(int file, const iovec* data, int count, off64_t place) {
  return pwritev(file, data, count, place);
}

int fflush(FILE* stream) {
  static auto* real = next<int(FILE*)>("fflush");
  if (stream == nullptr) return real(stream);
  const int file = fileno(stream);
  return faults().around(path_of(file), Need::room, file, [&] { return real(stream); });
}

int fsync(int file) {
  static auto* real = next<int(int)>("fsync");
  return faults().around(path_of(file), Need::none, -1, [&] { return real(file); });
}

int ftruncate(int file, off_t size) {
  static auto* real = next<int(int, off_t)>("ftruncate");
  return faults().around(path_of(file), Need::room, -1, [&] { return real(file, size); });
}

int ftruncate64(int file, off64_t size) {
  return ftruncate(file, size);
}

int open(const char* path, int flags, ...) {
  static auto* real = next<int(const char*, int, ...)>("open");
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if ((flags & creates) == 0) return real(path, flags, mode);
  return faults().around(path, Need::room, -1, [&] { return real(path, flags, mode); });
}

// where off_t has 64 bits, the same
int open64(const char* path, int flags, ...) __attribute__((alias("open")));

int rename(const char* from, const char* to) {
  static auto* real = next<int(const char*, const char*)>("rename");
  return faults().around(to, Need::none, -1, [&] { return real(from, to); });
}

int link(const char* from, const char* to) {
  static auto* real = next<int(const char*, const char*)>("link");
  return faults().around(to, Need::room, -1, [&] { return real(from, to); });
}

int remove(const char* path) {
  static auto* real = next<int(const char*)>("remove");
  return faults().around(path, Need::none, -1, [&] { return real(path); });
}

int unlink(const char* path) {
  static auto* real = next<int(const char*)>("unlink");
  return faults().around(path, Need::none, -1, [&] { return real(path); });
}

int mkdir(const char* path, mode_t mode) {
  static auto* real = next<int(const char*, mode_t)>("mkdir");
  return faults().around(path, Need::room, -1, [&] { return real(path, mode); });
}

}  // extern "C"
