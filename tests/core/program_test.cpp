// SPDX-License-Identifier: MIT
// Programs that run beside ours: found, fed through a pipe, and ended.
#include "core/program.h"

#include <chrono>
#include <csignal>
#include <filesystem>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "core/error.h"

using namespace ballpit;

namespace {

ProgramCall shell(const std::string& script) { return {.path = "/bin/sh", .arguments = {"-c", script}}; }

}  // namespace

TEST_CASE("a program is found on the PATH, or by its path") {
  CHECK(std::filesystem::exists(find_program("sh")));
  CHECK(find_program("/bin/sh") == "/bin/sh");
  CHECK(find_program("no-such-program-anywhere").empty());
  CHECK(find_program("/nowhere/sh").empty());
}

TEST_CASE("a program gets its input, and its output, errors and status are returned") {
  ProgramCall call = shell("cat; echo oops >&2; exit 7");
  call.input = "some words\n";
  const ProgramResult result = call_program(call);
  CHECK(result.status == 7);
  CHECK(result.output == "some words\n");
  CHECK(result.errors == "oops\n");
}

TEST_CASE("a piped program reads all that is written, however much, while it runs") {
  PipedProgram program(shell("cat; echo end >&2; exit 5"));
  const std::string block(300'000, 'x');
  for (int k = 0; k < 10; ++k) CHECK(program.write(block));
  CHECK(program.write(""));
  const ProgramResult result = program.finish();
  CHECK(result.status == 5);
  CHECK(result.output.size() == 10 * block.size());
  CHECK(result.errors == "end\n");
}

TEST_CASE("writing to a piped program that has ended fails, and its reason is returned") {
  std::signal(SIGPIPE, SIG_IGN);  // as in main()
  PipedProgram program(shell("echo no >&2; exit 3"));
  bool reads = true;
  for (int k = 0; k < 1000 && reads; ++k) reads = program.write(std::string(100'000, 'x'));
  CHECK_FALSE(reads);
  const ProgramResult result = program.finish();
  CHECK(result.status == 3);
  CHECK(result.errors == "no\n");
  CHECK(PipedProgram(shell("kill -9 $$")).finish().status == 128 + SIGKILL);
}

TEST_CASE("a piped program that nobody waits for is killed") {
  const auto start = std::chrono::steady_clock::now();
  { const PipedProgram program(shell("sleep 100")); }
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(50));
}

TEST_CASE("a program that cannot be started is reported, and leaves no descriptor open") {
  const auto lowest_free = [] {
    const int free = ::dup(0);
    ::close(free);
    return free;
  };
  const int before = lowest_free();
  CHECK_THROWS_WITH(PipedProgram({.path = "/nowhere/ffmpeg"}),
                    "/nowhere/ffmpeg: cannot start: No such file or directory");
  CHECK_THROWS_AS(call_program({.path = "/nowhere/ffmpeg"}), RunError);
  CHECK(lowest_free() == before);
}
