// SPDX-License-Identifier: MIT
#include "export/film_file.h"

#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"

namespace ballpit {

namespace fs = std::filesystem;

namespace {

/// ffmpeg's arguments. H.264 with 4:2:0 chroma is what every player shows. Colours are converted by the matrix of HDTV, and
/// the file says so; without it, ffmpeg converts by that of SDTV, and players shift the hues. Source: ITU-R BT.709-6.
ProgramCall call_of(const fs::path& part, int width, int height, double rate) {
  const auto words = [](const std::string& text) {
    std::istringstream in(text);
    return std::vector<std::string>(std::istream_iterator<std::string>(in), {});
  };
  ProgramCall call{.path = find_program("ffmpeg"), .gets_interrupts = false};
  call.arguments = words(fmt::format(
      "-nostdin -hide_banner -loglevel error -y -f rawvideo -pixel_format rgba -video_size {}x{} -framerate {} -i "
      "pipe:0 "
      "-vf scale=out_color_matrix=bt709 -pix_fmt yuv420p -colorspace bt709 -color_primaries bt709 "
      "-color_trc "
      "bt709 -color_range tv -c:v libx264 -preset medium -crf 18 -movflags +faststart -fflags +bitexact -f mp4",
      width, height, rate));
  call.arguments.push_back("file:" + part.string());  // a name with a colon is no protocol
  return call;
}

/// The first line that ffmpeg has printed: later ones are consequences. It names its parts with addresses in memory.
std::string reason_in(const std::string& errors) {
  std::istringstream lines(errors);
  std::string line;
  while (line.empty() && std::getline(lines, line)) {
  }
  const size_t address = line.find(" @ 0x"), end = line.find(']', address);
  if (address != line.npos && end != line.npos) line.erase(address, end - address);
  return line;
}

}  // namespace

FilmFile::FilmFile(const fs::path& path, int width, int height, double rate)
    : path_(path), file_(path), ffmpeg_(call_of(file_.part(), width, height, rate)) {}

void FilmFile::push(const Image& frame) {
  const std::string_view bytes(reinterpret_cast<const char*>(frame.pixels.data()), frame.pixels.size());
  if (!ffmpeg_.write(bytes)) fail(ffmpeg_.finish());
}

void FilmFile::finish() {
  const ProgramResult result = ffmpeg_.finish();
  std::error_code unknown;
  if (result.status != 0 || fs::file_size(file_.part(), unknown) == 0) fail(result);
  file_.commit();
}

void FilmFile::fail(const ProgramResult& result) const {
  const std::string reason = reason_in(result.errors);
  throw RunError(path_.string(), reason.empty() ? fmt::format("ffmpeg ended with status {}", result.status)
                                                : "ffmpeg failed: " + reason);
}

void check_film_file(std::string_view option, const fs::path& path) {
  if (path.extension() != ".mp4") throw UserError(option, path.string(), "a name that ends in .mp4");
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw UserError(option, path.string() + ", which is no file", "a new file, or one to replace");
  }
  if (find_program("ffmpeg").empty()) {
    throw UserError(option, "no ffmpeg on the PATH", "an installed ffmpeg", "on Debian: apt-get install ffmpeg");
  }
  check_output(path);
}

}  // namespace ballpit
