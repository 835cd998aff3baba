// SPDX-License-Identifier: MIT
#include "core/file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "core/error.h"

namespace ballpit {

namespace {

[[noreturn]] void fail_writing(const std::filesystem::path& path) {
  throw RunError(path.string() + ": cannot write: " + std::strerror(errno));
}

}  // namespace

NewFile::NewFile(std::filesystem::path path) : path_(std::move(path)), part_(path_.string() + ".part") {
  descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail_writing(path_);
}

NewFile::~NewFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  std::error_code ignored;
  if (!part_.empty()) std::filesystem::remove(part_, ignored);
}

void NewFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_writing(path_);
    bytes.remove_prefix(static_cast<size_t>(written));
  }
}

void NewFile::cut_to(int64_t bytes) {
  if (::ftruncate(descriptor_, bytes) != 0) fail_writing(path_);
}

void NewFile::commit() {
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) fail_writing(path_);
  if (::rename(part_.c_str(), path_.c_str()) != 0) fail_writing(path_);
  part_.clear();  // nothing is left to remove
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  NewFile file(path);
  file.write(bytes);
  file.commit();
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
