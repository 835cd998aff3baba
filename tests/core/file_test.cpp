// SPDX-License-Identifier: MIT
#include "core/file.h"

#include <csignal>
#include <fstream>
#include <thread>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// An empty folder that is removed at the end.
struct Folder {
  fs::path path;
  Folder() {
    std::string name = (fs::temp_directory_path() / "ballpit-file-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw RunError(name, "no folder for the test");
    path = name;
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path operator/(const char* name) const { return path / name; }
  size_t count() const {
    return static_cast<size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator{}));
  }
};

void put(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

mode_t mode_of(const fs::path& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 ? status.st_mode : 0;
}

}  // namespace

TEST_CASE("a written file reads back completely, and no temporary file remains") {
  const Folder folder;
  const std::string bytes("a\0b\n", 4);
  write_file(folder / "x.bin", bytes);
  CHECK(read_file(folder / "x.bin") == bytes);
  CHECK(folder.count() == 1);
}

TEST_CASE("a failed write names path and reason, and leaves no partial file") {
  CHECK_THROWS_WITH(write_file("/nonexistent/x", "a"), Contains("/nonexistent/x") && Contains("No such file"));
  const Folder folder;
  {
    NewFile file(folder / "x");
    file.write("half");
    CHECK(fs::exists(folder / "x.part"));
  }
  CHECK(folder.count() == 0);
}

TEST_CASE("an output through a link, a chain of links or a dangling link is written to its target") {
  const Folder folder;
  fs::create_directory(folder / "far");
  put(folder / "far/target", "old");
  fs::create_symlink("far/target", folder / "relative");
  fs::create_symlink("relative", folder / "chain");
  fs::create_symlink("target", folder / "far/near");
  fs::create_symlink(folder / "far/near", folder / "through");
  for (const char* link : {"relative", "chain", "through"}) {
    INFO(link);
    NewFile file(folder / link);
    file.write(link);
    CHECK(fs::exists(folder / "far/target.part"));  // beside the replaced file, so that a rename suffices
    file.commit();
    CHECK(fs::is_symlink(folder / link));
    CHECK(read_file(folder / "far/target") == link);
  }
  fs::create_symlink("far/new", folder / "dangling");
  write_file(folder / "dangling", "x");
  CHECK(fs::is_symlink(folder / "dangling"));
  CHECK(read_file(folder / "far/new") == "x");
  CHECK(folder.count() == 5);
  fs::create_symlink("circle", folder / "circle");
  CHECK_THROWS_WITH(write_file(folder / "circle", "x"), Contains("circle: cannot write: Too many levels"));
  CHECK_THROWS_WITH(check_output(folder / "circle"), Contains("Too many levels"));
}

TEST_CASE("a pipe as output is written to, and remains a pipe") {
  const Folder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  fs::create_symlink("pipe", folder / "link");
  check_output(folder / "pipe");  // does not wait for a reader
  for (const char* name : {"pipe", "link"}) {
    std::string got;
    std::thread reader([&] { got = read_file(folder / "pipe"); });
    NewFile file(folder / name);
    file.write("some");
    file.write(" bytes");
    file.cut_to(4);  // has no effect
    file.commit();
    reader.join();
    CHECK(got == "some bytes");
    CHECK(S_ISFIFO(mode_of(folder / "pipe")));
    CHECK(fs::is_symlink(folder / "link"));
  }
  CHECK(folder.count() == 2);
}

TEST_CASE("writing to a pipe without a reader is an error") {
  const Folder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  const auto before = std::signal(SIGPIPE, SIG_IGN);  // as the program does
  const int reader = ::open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  NewFile file(folder / "pipe");
  ::close(reader);
  CHECK_THROWS_WITH(file.write("x"), Contains("pipe: cannot write: Broken pipe"));
  std::signal(SIGPIPE, before);
}

TEST_CASE("a device as output is written to, and remains a device") {
  const Folder folder;
  // Our own device files, so that replacing them by mistake is harmless. Only root can make them.
  if (::mknod((folder / "null").c_str(), S_IFCHR | 0666, 1 << 8 | 3) != 0) return;
  REQUIRE(::mknod((folder / "full").c_str(), S_IFCHR | 0666, 1 << 8 | 7) == 0);
  const int null = ::open((folder / "null").c_str(), O_WRONLY);
  if (null < 0) return;  // the file system does not support device files
  ::close(null);
  check_output(folder / "null");
  write_file(folder / "null", "x");
  CHECK(S_ISCHR(mode_of(folder / "null")));
  CHECK_THROWS_WITH(write_file(folder / "full", "x"), Contains("full: cannot write: No space left"));
  CHECK(S_ISCHR(mode_of(folder / "full")));
  CHECK(folder.count() == 2);
}

TEST_CASE("one of our own descriptors as output is written at its position, and not replaced") {
  const Folder folder;
  const int file = ::open((folder / "log").c_str(), O_WRONLY | O_CREAT, 0600);
  REQUIRE(file >= 0);
  REQUIRE(::write(file, "before ", 7) == 7);
  const std::string number = std::to_string(file);
  write_file("/dev/fd/" + number, "one ");
  fs::create_symlink("/proc/self/fd/" + number, folder / "link");
  write_file(folder / "link", "two ");
  REQUIRE(::write(file, "after", 5) == 5);
  CHECK(read_file(folder / "log") == "before one two after");
  CHECK(folder.count() == 2);
  ::close(file);
  CHECK_THROWS_WITH(check_output("/dev/fd/" + number), Contains("cannot write: Bad file descriptor"));
  CHECK_THROWS_WITH(write_file("/dev/fd/" + number, "x"), Contains("cannot write: Bad file descriptor"));
}

TEST_CASE("a file that is replaced keeps its permissions") {
  const Folder folder;
  for (const mode_t mode : {0600, 0640, 0666, 0755}) {
    put(folder / "x", "old");
    REQUIRE(::chmod((folder / "x").c_str(), mode) == 0);
    {
      NewFile file(folder / "x");
      CHECK((mode_of(folder / "x.part") & 0777) == mode);
      file.write("new");
      file.commit();
    }
    CHECK((mode_of(folder / "x") & 0777) == mode);
    CHECK(read_file(folder / "x") == "new");
  }
}

TEST_CASE("two writers of one output write separate files, and the file of the last one remains") {
  const Folder folder;
  NewFile first(folder / "x"), second(folder / "x");
  first.write("first, which is longer");
  second.write("second");
  CHECK(folder.count() == 2);
  first.commit();
  CHECK(read_file(folder / "x") == "first, which is longer");
  second.commit();
  CHECK(read_file(folder / "x") == "second");
  CHECK(folder.count() == 1);
}

TEST_CASE("the temporary file of an interrupted run is reused, other files of that name stay unchanged") {
  const Folder folder;
  put(folder / "x.part", "left by an interrupted run, and longer");
  check_output(folder / "x");
  CHECK(read_file(folder / "x.part") == "left by an interrupted run, and longer");
  write_file(folder / "x", "new");
  CHECK(read_file(folder / "x") == "new");
  CHECK(folder.count() == 1);
  put(folder / "precious", "precious");
  fs::create_symlink("precious", folder / "x.part");
  write_file(folder / "x", "newer");
  CHECK(read_file(folder / "x") == "newer");
  CHECK(read_file(folder / "precious") == "precious");
  CHECK(folder.count() == 3);
}

TEST_CASE("an output that cannot be written is found by a check that changes nothing") {
  const Folder folder;
  put(folder / "file", "old");
  check_output(folder / "file");
  check_output(folder / "new");
  check_output_folder(folder.path);
  check_output_folder(folder / "new/and/deep/");
  CHECK(read_file(folder / "file") == "old");
  CHECK(folder.count() == 1);
  CHECK_THROWS_WITH(check_output(folder.path), Contains("cannot write: Is a directory"));
  CHECK_THROWS_WITH(check_output(folder / "missing/x"), Contains("missing/x: cannot write: No such file"));
  CHECK_THROWS_WITH(check_output(folder / "file/x"), Contains("file/x: cannot write: Not a directory"));
  CHECK_THROWS_WITH(check_output("/proc/x"), Contains("/proc/x: cannot write: "));
  CHECK_THROWS_WITH(check_output_folder(folder / "file"), Contains("file: cannot make the folder: Not a directory"));
  CHECK_THROWS_WITH(check_output_folder(folder / "file/x"), Contains("file/x: cannot make the folder: Not a dir"));
  CHECK_THROWS_WITH(check_output_folder("/proc/x"), Contains("/proc/x: cannot make the folder: "));
  CHECK(folder.count() == 1);
}

TEST_CASE("outputs are the same if they lead to the same file") {
  const Folder folder;
  put(folder / "file", "");
  fs::create_symlink("file", folder / "link");
  fs::create_symlink("missing", folder / "dangling");
  CHECK(is_same_file(folder / "file", folder / "link"));
  CHECK(is_same_file(folder / "file", folder / "./file"));
  CHECK(is_same_file(folder / "missing", folder / "dangling"));
  CHECK_FALSE(is_same_file(folder / "file", folder / "missing"));
  CHECK_FALSE(is_same_file(folder / "one", folder / "missing"));
  CHECK_FALSE(is_same_file("", ""));
}

TEST_CASE("reading an unreadable file is a UserError") {
  CHECK_THROWS_AS(read_file("/nonexistent/x"), UserError);
  CHECK_THROWS_WITH(read_file("/tmp"), Catch::Contains("folder"));
}
