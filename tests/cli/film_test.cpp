// SPDX-License-Identifier: MIT
// ballpit render --film: the frames go to ffmpeg, and the file appears when it is complete. Most tests have a script in
// ffmpeg's place, which stores the bytes that it gets.
#include <chrono>
#include <csignal>
#include <thread>

#include <catch2/catch.hpp>

#include "core/program.h"
#include "export/frame_sequence.h"
#include "tests/support/picture_compare.h"
#include "tests/support/run_program.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A folder with a script named ffmpeg, which comes first on the PATH.
struct Fake {
  explicit Fake(const std::string& script =
                    "for last; do :; done; echo \"$@\" > \"$0.arguments\"; [ \"${last#file:}\" != \"$last\" ] && cat > "
                    "\"${last#file:}\"") {
    write_text(folder / "ffmpeg", "#!/bin/sh\n" + script + "\n");
    fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
  }

  Scratch folder;
  const Variable path{"PATH", folder.path().string() + ":" + std::getenv("PATH")};
};

Arguments render_grid(const Arguments& more, int frames = 3) {
  return with({"render", "lecture-grid", "--size", "64x36", "--frames", std::to_string(frames)}, more);
}

std::vector<std::string> names_in(const Scratch& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path())) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The run fails with status 1 and one line, and leaves no film.
void check_failure(const std::string& script, const std::string& reason) {
  const Fake fake(script);
  const Scratch scratch;
  const Outcome outcome = run_program(render_grid({"--film", scratch / "a.mp4"}, 30));
  INFO(outcome.err);
  CHECK(outcome.status == 1);
  CHECK(outcome.err == "ballpit: " + scratch / "a.mp4" + ": " + reason + "\n");
  CHECK(names_in(scratch).empty());
}

}  // namespace

TEST_CASE("ffmpeg gets the pixels of the frames, one after the other, and no picture is written") {
  const Fake fake;
  const Scratch scratch;
  const Outcome outcome = run_program(render_grid({"--film", scratch / "a.mp4", "--json"}));
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.json()["film"] ==
        nlohmann::json{{"file", scratch / "a.mp4"}, {"frames_per_second", 60.0}, {"seconds", 0.05}, {"speed", 1.0}});
  CHECK(outcome.json()["out"].is_null());
  CHECK(names_in(scratch) == std::vector<std::string>{"a.mp4"});
  REQUIRE(run_program(render_grid({"--out", scratch / "frames"})).status == 0);
  std::string pixels;
  for (int k = 0; k < 3; ++k) {
    const Image frame = read_png(scratch / "frames/" + frame_name(k));
    pixels.append(frame.pixels.begin(), frame.pixels.end());
  }
  const bool is_same = read_text(scratch / "a.mp4") == pixels;  // not in CHECK, which would print the bytes
  CHECK(is_same);
  const std::string words = read_text(fake.folder / "ffmpeg.arguments");
  for (const char* word : {" -video_size 64x36 ", " -framerate 60 ", " -pix_fmt yuv420p ", " -c:v libx264 "}) {
    CHECK_THAT(words, Contains(word));
  }
}

TEST_CASE("the option --out beside --film writes the pictures too") {
  const Fake fake;
  const Scratch scratch;
  REQUIRE(run_program(render_grid({"--film", scratch / "a.mp4", "--out", scratch / "frames"})).status == 0);
  CHECK(fs::file_size(scratch / "a.mp4") == 3 * 64 * 36 * 4);
  CHECK(next_frame_index(scratch / "frames") == 3);
}

TEST_CASE("a film plays in real time, and in slow motion where it has more than 60 frames a second") {
  const Fake fake;
  const Scratch scratch;
  const auto film = [&](const Arguments& more) {
    const nlohmann::json found =
        run_program(with(render_grid({"--film", scratch / "a.mp4", "--json"}), more)).json()["film"];
    return std::pair<double, double>(found["frames_per_second"], found["speed"]);
  };
  CHECK(film({"--fps", "30"}) == std::pair(30.0, 1.0));
  CHECK(film({"--every", "4"}) == std::pair(15.0, 1.0));
  CHECK_THAT(read_text(fake.folder / "ffmpeg.arguments"), Contains(" -framerate 15 "));
  CHECK(film({"--fps", "240"}) == std::pair(60.0, 0.25));
  CHECK(film({"--fps", "240", "--every", "4"}) == std::pair(60.0, 1.0));
}

TEST_CASE("a film replaces an earlier one when it is complete") {
  const Scratch scratch;
  write_text(scratch / "a.mp4", "an earlier film");
  {
    const Fake broken("exit 1");
    CHECK(run_program(render_grid({"--film", scratch / "a.mp4"})).status == 1);
    CHECK(read_text(scratch / "a.mp4") == "an earlier film");
  }
  const Fake fake;
  CHECK(run_program(render_grid({"--film", scratch / "a.mp4"})).status == 0);
  CHECK(fs::file_size(scratch / "a.mp4") == 3 * 64 * 36 * 4);
}

TEST_CASE("a name with blanks, colons or a leading dash is the name of the film") {
  const Fake fake;
  const Scratch scratch;
  Circumstances here;
  here.folder = scratch.path().string();
  for (const std::string name : {"a b.mp4", "http:film.mp4", "-x.mp4", "%03d.mp4"}) {
    INFO(name);
    CHECK(run_program(render_grid({"--film=" + name}), here).status == 0);
    CHECK(fs::file_size(scratch / name) == 3 * 64 * 36 * 4);
  }
}

TEST_CASE("a failing ffmpeg is reported in one line with its reason, and leaves no file") {
  check_failure("echo >&2; echo '[libx264 @ 0x55f0c0] no such thing' >&2; echo more >&2; exit 1",
                "ffmpeg failed: [libx264] no such thing");
  check_failure("exit 4", "ffmpeg ended with status 4");
  check_failure("kill -9 $$", "ffmpeg ended with status 137");
  check_failure("cat > /dev/null", "ffmpeg ended with status 0");                              // it has written nothing
  check_failure("cat > /dev/null; echo 'disk full' >&2; exit 1", "ffmpeg failed: disk full");  // at the end
}

TEST_CASE("a run that fails leaves no film") {
  const Fake fake;
  const Scratch scratch;
  Circumstances here;
  here.folder = scratch.path().string();
  const Outcome outcome = run_program({"render", "bouncing-balls", "--count", "50", "--dt", "2", "--fps", "1", "--size",
                                       "64x36", "--frames", "9", "--film", "a.mp4"},
                                      here);
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("left the domain"));
  CHECK(names_in(scratch) == std::vector<std::string>{"bouncing-balls-last-good.csv"});
}

TEST_CASE("without ffmpeg, --film is refused before anything is drawn, and the message says how to install it") {
  const Variable nowhere("PATH", "/nowhere");
  const Scratch scratch;
  const Outcome outcome = run_program(render_grid({"--film", scratch / "a.mp4", "--out", scratch / "frames"}));
  CHECK(outcome.status == 2);
  CHECK(
      outcome.err ==
      "ballpit: --film: found no ffmpeg on the PATH, allowed an installed ffmpeg; on Debian: apt-get install ffmpeg\n");
  CHECK(names_in(scratch).empty());
}

TEST_CASE("Ctrl-C leaves no film, no temporary file and no ffmpeg, also while ffmpeg does not read") {
  for (const char* script :
       {"for last; do :; done; [ \"${last#file:}\" != \"$last\" ] && cat > \"${last#file:}\"", "exec sleep 100"}) {
    const Fake fake("echo $$ > \"$0.id\"; " + std::string(script));
    const Scratch scratch;
    Program program(render_grid({"--film", scratch / "a.mp4"}, 100'000));
    for (int k = 0; k < 6000 && !fs::exists(fake.folder / "ffmpeg.id"); ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(300));  // some frames
    program.signal(SIGINT);
    const Outcome outcome = program.wait();
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err, Contains("lecture-grid: interrupted after ") && Contains("; no film was written\n"));
    CHECK(names_in(scratch).empty());
    const int id = std::stoi(read_text(fake.folder / "ffmpeg.id"));
    CHECK(::kill(id, 0) != 0);
  }
}

TEST_CASE("the real ffmpeg makes an H.264 file that shows the frames in their colours") {
  const std::string ffmpeg = find_program("ffmpeg");
  if (ffmpeg.empty()) {
    WARN("skipped: ffmpeg is not installed");
    return;
  }
  const Scratch scratch;
  const Outcome outcome = run_program({"render", "lecture-grid", "--size", "320x180", "--frames", "8", "--every", "4",
                                       "--film", scratch / "a.mp4", "--out", scratch / "frames"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(read_text(scratch / "a.mp4").substr(0, 64), Contains("ftyp") && Contains("moov"));  // plays while it loads
  const ProgramResult decoded = call_program(ProgramCall{
      .path = ffmpeg,
      .arguments = {"-loglevel", "error", "-i", scratch / "a.mp4", "-f", "rawvideo", "-pix_fmt", "rgba", "-"}});
  REQUIRE(decoded.status == 0);
  constexpr size_t kFrame = 320 * 180 * 4;
  REQUIRE(decoded.output.size() == 8 * kFrame);
  for (int k = 0; k < 8; ++k) {
    const Image frame = read_png(scratch / "frames/" + frame_name(k));
    double sum = 0;  // of differences
    for (size_t i = 0; i < kFrame; ++i) {
      sum += std::abs(frame.pixels[i] - int{static_cast<uint8_t>(decoded.output[static_cast<size_t>(k) * kFrame + i])});
    }
    CHECK(sum / kFrame < 3);
  }
}
