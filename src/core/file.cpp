// SPDX-License-Identifier: MIT
#include "core/file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <unistd.h>

#include "core/error.h"

namespace ballpit {

namespace {

/// Removes a half-written file unless told that it is whole.
struct PartialFile {
  std::filesystem::path path;
  int descriptor = -1;
  bool whole = false;

  ~PartialFile() {
    if (descriptor >= 0) ::close(descriptor);
    std::error_code ignored;
    if (!whole) std::filesystem::remove(path, ignored);
  }
};

[[noreturn]] void fail_writing(const std::filesystem::path& path) {
  throw RunError(path.string() + ": cannot write: " + std::strerror(errno));
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  PartialFile part{path.string() + ".part"};
  part.descriptor = ::open(part.path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (part.descriptor < 0) fail_writing(path);
  while (!bytes.empty()) {
    const ssize_t written = ::write(part.descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_writing(path);
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  const int descriptor = part.descriptor;
  part.descriptor = -1;
  if (::close(descriptor) != 0) fail_writing(path);
  if (::rename(part.path.c_str(), path.c_str()) != 0) fail_writing(path);
  part.whole = true;
}

std::string read_file(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) throw UserError(path.string() + ": is a folder, a file is needed");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw UserError(path.string() + ": cannot read: " + std::strerror(errno));
  std::ostringstream content;
  content << in.rdbuf();
  if (in.bad()) throw UserError(path.string() + ": cannot read: " + std::strerror(errno));
  return std::move(content).str();
}

}  // namespace ballpit
