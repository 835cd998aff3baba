// SPDX-License-Identifier: MIT
#include "core/file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/interrupt.h"

namespace ballpit {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxLinks = 40;   // as in Linux
constexpr int kMaxParts = 100;  // runs that write to one output at the same time

[[noreturn]] void fail_writing(const fs::path& path, int reason = errno) {
  throw RunError(path.string(), fmt::format("cannot write: {}", std::strerror(reason)));
}

[[noreturn]] void fail_making(const fs::path& folder, const std::string& reason) {
  throw RunError(folder.string(), "cannot make the folder: " + reason);
}

/// The file, pipe or device behind an output.
struct Target {
  fs::path place;           ///< after following links
  int descriptor = -1;      ///< our own, if the output is one
  bool is_special = false;  ///< a pipe or a device
  struct stat status {};    ///< of the existing file; st_mode is 0 if there is none
};

/// N if a path is /proc/self/fd/N, or another name for it; else −1.
int own_descriptor(const fs::path& path) {
  const std::string name = path.filename();
  if (name.empty() || name.size() > 9 || name.find_first_not_of("0123456789") != std::string::npos) return -1;
  std::error_code missing;
  const fs::path own = fs::canonical("/proc/self/fd", missing);
  if (missing || fs::canonical(path.parent_path() / ".", missing) != own || missing) return -1;
  return std::stoi(name);
}

/// Follows links. Throws for a cycle of links.
fs::path follow_links(const fs::path& path) {
  fs::path place = path;
  std::error_code no_link;
  for (int links = 0; own_descriptor(place) < 0; ++links) {
    const fs::path next = fs::read_symlink(place, no_link);
    if (no_link) break;
    if (links == kMaxLinks) fail_writing(path, ELOOP);
    place = place.parent_path() / next;
  }
  return place;
}

/// Throws if the output cannot be a file, or must not be written.
Target find_target(const fs::path& path) {
  Target target;
  target.place = follow_links(path);
  target.descriptor = own_descriptor(target.place);
  if (target.descriptor >= 0) {
    const int flags = ::fcntl(target.descriptor, F_GETFL);
    if (flags < 0) fail_writing(path);
    if ((flags & O_ACCMODE) == O_RDONLY) fail_writing(path, EBADF);
    ::fstat(target.descriptor, &target.status);
    return target;
  }
  if (::stat(path.c_str(), &target.status) != 0) {
    if (errno != ENOENT) fail_writing(path);
    target.status.st_mode = 0;
    return target;
  }
  if (S_ISDIR(target.status.st_mode)) fail_writing(path, EISDIR);
  if (S_ISSOCK(target.status.st_mode)) fail_writing(path, ENXIO);
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) fail_writing(path);
  target.is_special = !S_ISREG(target.status.st_mode);
  if (target.is_special) target.place = path;
  return target;
}

/// Whether a signal that does not end the run has interrupted a system call.
bool is_to_be_repeated() { return errno == EINTR && !was_interrupted(); }

/// Opens one of our own descriptors, a pipe or a device. Waits for the reader of a pipe.
int open_special(const Target& target) {
  if (target.descriptor >= 0) return ::fcntl(target.descriptor, F_DUPFD_CLOEXEC, 0);
  for (;;) {
    const int descriptor = ::open(target.place.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
    if (descriptor >= 0 || !is_to_be_repeated()) return descriptor;
  }
}

/// Locks a temporary file. Returns false if it belongs to another run: not a regular file, another user's, locked or renamed.
bool lock_part(int descriptor, const fs::path& part) {
  struct stat opened = {}, named = {};
  if (::fstat(descriptor, &opened) != 0 || !S_ISREG(opened.st_mode) || opened.st_uid != ::geteuid()) return false;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  return ::lstat(part.c_str(), &named) == 0 && named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

/// Opens a temporary file beside a target and sets its name. Reuses the file of an interrupted run unless `is_new`. Returns −1
/// with errno if it cannot be opened.
int open_part(const fs::path& target, fs::path& part, mode_t mode, bool is_new) {
  for (int k = 1; k <= kMaxParts; ++k) {
    part = target;
    part += k > 1 ? fmt::format(".{}.part", k) : ".part";
    const int flags = O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | (is_new ? O_EXCL : 0);
    const int descriptor = ::open(part.c_str(), flags, mode);
    const int reason = errno;
    if (descriptor >= 0 && lock_part(descriptor, part)) return descriptor;
    struct stat other {};
    if (descriptor >= 0) {
      ::close(descriptor);
    } else if (::lstat(part.c_str(), &other) != 0) {
      errno = reason;
      return -1;
    }
  }
  errno = EEXIST;
  return -1;
}

/// Makes a temporary file beside a target and removes it. Returns −1 with errno if it fails.
int try_part(const fs::path& target) {
  fs::path part;
  const int descriptor = open_part(target, part, 0600, true);
  if (descriptor < 0) return -1;
  ::unlink(part.c_str());
  return ::close(descriptor);
}

/// Gives a new file the permissions of the file that it will replace, and its owner if this is allowed.
void keep_permissions(int descriptor, const struct stat& old) {
  (void)!::fchown(descriptor, old.st_uid, old.st_gid);  // first: it may remove permissions
  (void)::fchmod(descriptor, old.st_mode & 0777u);
}

}  // namespace

NewFile::NewFile(fs::path path) : path_(std::move(path)) {
  const Target target = find_target(path_);
  target_ = target.place;
  if (target.descriptor >= 0 || target.is_special) {
    descriptor_ = open_special(target);
    if (descriptor_ < 0) fail_writing(path_);
    return;
  }
  const bool is_there = target.status.st_mode != 0;
  fs::path part;
  descriptor_ = open_part(target_, part, is_there ? 0600 : 0666, false);
  if (descriptor_ < 0) fail_writing(path_);
  part_ = part;
  if (is_there) keep_permissions(descriptor_, target.status);
  cut_to(0);  // the content from an interrupted run
}

NewFile::~NewFile() {
  if (!part_.empty()) ::unlink(part_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

void NewFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<size_t>(written));
    } else if (errno == EAGAIN) {  // a descriptor in non-blocking mode
      pollfd ready{descriptor_, POLLOUT, 0};
      if (::poll(&ready, 1, -1) < 0 && !is_to_be_repeated()) fail_writing(path_);
    } else if (!is_to_be_repeated() && !(errno == EINTR && !part_.empty())) {
      fail_writing(path_);
    }
  }
}

void NewFile::cut_to(int64_t bytes) {
  if (!part_.empty() && ::ftruncate(descriptor_, bytes) != 0) fail_writing(path_);
}

void NewFile::commit() {
  if (!part_.empty()) {
    // Some systems report a full disk when a file is closed. The lock lasts until both descriptors are closed.
    const int twin = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
    if (twin < 0 || ::close(twin) != 0) fail_writing(path_);
    if (::rename(part_.c_str(), target_.c_str()) != 0) fail_writing(path_);
    part_.clear();
  }
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) fail_writing(path_);
}

void write_file(const fs::path& path, std::string_view bytes) {
  NewFile file(path);
  file.write(bytes);
  file.commit();
}

void check_output(const fs::path& path) {
  const Target target = find_target(path);
  if (target.descriptor >= 0 || target.is_special) return;
  if (try_part(target.place) != 0) fail_writing(path);
}

void check_output_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) {
    if (try_part(folder / "ballpit") != 0) fail_writing(folder);
    return;
  }
  // The folder will be made in its nearest existing parent.
  fs::path there = folder;
  fs::file_status status = fs::symlink_status(there, error);
  while (status.type() == fs::file_type::not_found) {
    there = there.has_parent_path() ? there.parent_path() : fs::path(".");
    status = fs::status(there, error);
  }
  if (!fs::is_directory(status)) fail_making(folder, error ? error.message() : std::strerror(ENOTDIR));
  if (try_part(there / "ballpit") != 0) fail_making(folder, std::strerror(errno));
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  if (a.empty() || b.empty()) return false;
  struct stat one = {}, other = {};
  const bool is_there = ::stat(a.c_str(), &one) == 0;
  if (is_there != (::stat(b.c_str(), &other) == 0)) return false;
  if (is_there) return one.st_dev == other.st_dev && one.st_ino == other.st_ino;
  std::error_code unknown;
  const auto place = [&](const fs::path& path) {
    return fs::weakly_canonical(fs::absolute(follow_links(path)), unknown);
  };
  return place(a) == place(b);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail_making(folder, error.message());
}

void append_to_file(const fs::path& path, std::string_view lines) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  const ssize_t written = file < 0 ? -1 : ::write(file, lines.data(), lines.size());
  const int reason = written < 0 ? errno : ENOSPC;
  if (file >= 0) ::close(file);
  if (written != static_cast<ssize_t>(lines.size())) fail_writing(path, reason);
}

void shorten_file(const fs::path& path, int64_t bytes) {
  if (::truncate(path.c_str(), bytes) != 0) fail_writing(path);
}

void fail_reading(const fs::path& path) {
  throw UserError(path.string(), fmt::format("no readable file ({})", std::strerror(errno)), "a readable file");
}

std::string read_file(const fs::path& path) {
  if (fs::is_directory(path)) throw UserError(path.string(), "a folder", "a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_reading(path);
  std::ostringstream content;
  content << in.rdbuf();
  if (in.bad()) fail_reading(path);
  return std::move(content).str();
}

}  // namespace ballpit
