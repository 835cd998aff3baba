// SPDX-License-Identifier: MIT
#include "export/frame_sequence.h"

#include <atomic>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "core/error.h"
#include "core/file.h"
#include "export/png.h"

using namespace ballpit;
namespace fs = std::filesystem;

namespace {

/// An empty folder that is removed at the end.
struct Folder {
  fs::path path;
  explicit Folder(const std::string& name) : path(fs::temp_directory_path() / ("ballpit-" + name)) {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
};

Image frame(uint8_t value) { return {16, 9, std::vector<uint8_t>(16 * 9 * 4, value)}; }

size_t count_files(const fs::path& folder) {
  return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

}  // namespace

TEST_CASE("pushed frames are in the folder, complete and numbered in order") {
  const Folder folder("sequence");
  FrameSequence sequence(folder.path / "new" / "film");
  for (int i = 0; i < 20; ++i) sequence.push(frame(static_cast<uint8_t>(i)));
  CHECK(sequence.next_index() == 20);
  sequence.finish();
  CHECK(count_files(folder.path / "new" / "film") == 20);
  for (int i = 0; i < 20; ++i) {
    CHECK(read_file(folder.path / "new" / "film" / frame_name(i)) == encode_png(frame(static_cast<uint8_t>(i))));
  }
  CHECK(frame_name(12) == "frame_00012.png");
}

TEST_CASE("a destroyed sequence still writes the pushed frames") {
  const Folder folder("dropped");
  {
    FrameSequence sequence(folder.path);
    for (int i = 0; i < 3; ++i) sequence.push(frame(7));
  }
  CHECK(next_frame_index(folder.path) == 3);
}

TEST_CASE("a sequence resumes after the last complete frame") {
  const Folder folder("resume");
  CHECK(next_frame_index(folder.path / "missing") == 0);
  CHECK(next_frame_index(folder.path) == 0);
  {
    FrameSequence sequence(folder.path);
    for (int i = 0; i < 5; ++i) sequence.push(frame(1));
    sequence.finish();
  }
  CHECK(next_frame_index(folder.path) == 5);
  std::ofstream(folder.path / "frame_00005.png.part") << "half";
  CHECK(next_frame_index(folder.path) == 5);
  CHECK_FALSE(fs::exists(folder.path / "frame_00005.png.part"));
  fs::resize_file(folder.path / frame_name(4), 30);
  CHECK(next_frame_index(folder.path) == 4);
  fs::remove(folder.path / frame_name(2));
  CHECK(next_frame_index(folder.path) == 2);
  {
    FrameSequence sequence(folder.path, 2);
    sequence.push(frame(2));
    sequence.push(frame(2));
    sequence.push(frame(2));
    sequence.finish();
  }
  CHECK(next_frame_index(folder.path) == 5);
}

TEST_CASE("memory is bounded: pushing waits while the encoder is too slow", "[slow]") {
  const Folder folder("bounded");
  // Opening a pipe for writing waits for a reader, so the encoder is blocked.
  const fs::path pipe = folder.path / "frame_00000.png";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  FrameSequence sequence(folder.path);
  std::atomic<int> pushed = 0;
  std::thread producer([&] {
    for (; pushed < 10; ++pushed) sequence.push(frame(5));
  });
  while (pushed < 4) std::this_thread::yield();
  for (int k = 0; k < 1000; ++k) std::this_thread::yield();
  CHECK(pushed == 4);  // three wait, one is being written
  {
    std::ifstream reader(pipe, std::ios::binary);
    CHECK(std::string(std::istreambuf_iterator<char>(reader), {}) == encode_png(frame(5)));
  }
  producer.join();
  sequence.finish();
  CHECK(pushed == 10);
  CHECK(count_files(folder.path) == 10);
}

TEST_CASE("the error of a folder that cannot be made names it") {
  const Folder folder("unwritable");
  std::ofstream(folder.path / "file") << "x";
  CHECK_THROWS_WITH(FrameSequence(folder.path / "file" / "film"), Catch::Contains("unwritable/file/film"));
  CHECK_THROWS_AS(FrameSequence(folder.path / "file" / "film"), RunError);
}

TEST_CASE("a full disk stops the sequence with the file's name and the reason, and keeps earlier frames") {
  if (!fs::exists("/dev/full")) return;
  const Folder folder("full");
  fs::create_symlink("/dev/full", folder.path / "frame_00002.png");
  FrameSequence sequence(folder.path);
  const auto push_many = [&] {
    for (int i = 0; i < 100; ++i) sequence.push(frame(3));
  };
  CHECK_THROWS_WITH(push_many(), Catch::Contains("frame_00002.png") && Catch::Contains("No space left"));
  CHECK_THROWS_AS(sequence.push(frame(3)), RunError);
  CHECK_THROWS_AS(sequence.finish(), RunError);
  CHECK(next_frame_index(folder.path) == 2);
  CHECK(count_files(folder.path) == 3);
  CHECK(fs::is_symlink(folder.path / "frame_00002.png"));
}

TEST_CASE("only files are removed as frames, a pipe and a link remain and are written to") {
  const Folder folder("kept");
  std::ofstream(folder.path / "frame_00000.png") << "x";
  REQUIRE(::mkfifo((folder.path / "frame_00001.png").c_str(), 0600) == 0);
  fs::create_symlink("elsewhere", folder.path / "frame_00002.png");
  remove_frames(folder.path, 0, 9);
  CHECK_FALSE(fs::exists(folder.path / "frame_00000.png"));
  CHECK(fs::is_fifo(folder.path / "frame_00001.png"));
  CHECK(fs::is_symlink(folder.path / "frame_00002.png"));
}

TEST_CASE("a frame contains its key, without a change of pixels") {
  const Folder folder("key");
  FrameSequence sequence(folder.path, 0, "size 16x9\nscene a\n");
  sequence.push(frame(3));
  sequence.finish();
  const auto head = read_png_head(folder.path / frame_name(0));
  REQUIRE(head);
  CHECK(head->width == 16);
  CHECK(head->height == 9);
  CHECK(head->key == "size 16x9\nscene a\n");
  const std::string with_key = read_file(folder.path / frame_name(0)), without = encode_png(frame(3));
  CHECK(with_key.substr(with_key.find("IDAT")) == without.substr(without.find("IDAT")));
  write_file(folder.path / frame_name(1), without);
  CHECK(read_png_head(folder.path / frame_name(1))->key.empty());
  write_file(folder.path / frame_name(2), "no picture");
  CHECK_FALSE(read_png_head(folder.path / frame_name(2)));
}

TEST_CASE("a folder that vanishes during a sequence is reported at the end at the latest") {
  const Folder folder("vanished");
  FrameSequence sequence(folder.path / "film");
  fs::remove_all(folder.path / "film");
  sequence.push(frame(1));
  CHECK_THROWS_WITH(sequence.finish(), Catch::Contains("frame_00000.png"));
}
