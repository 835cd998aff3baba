// SPDX-License-Identifier: MIT
// ballpit doctor: what this machine offers, and what is missing.
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/summary.h"
#include "core/program.h"
#include "render/gl_context.h"
#include "version.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

struct Machine {
  unsigned threads = std::thread::hardware_concurrency();
  Backend cuda = cuda_backend();
  std::vector<EglDeviceInfo> egl_devices = list_egl_devices();
  std::optional<GlInfo> gl;
  std::string gl_error;
  std::map<std::string, std::string> tools;  ///< name and path; an empty path: it is missing
};

Machine examine_machine() {
  Machine machine;
  try {
    machine.gl = GlContext().info();
  } catch (const RunError& error) {
    machine.gl_error = error.what();
  }
  for (const char* tool : {"ffmpeg", "gnuplot"}) machine.tools[tool] = find_program(tool);
  return machine;
}

Json json_of(const Machine& machine) {
  Json devices = Json::array(), gl{{"error", machine.gl_error}};
  for (const EglDeviceInfo& device : machine.egl_devices) {
    devices.push_back({{"index", device.index}, {"name", device.name}, {"software", device.software}});
  }
  if (const auto& info = machine.gl) {
    gl = {{"renderer", info->renderer},
          {"version", info->version},
          {"platform", info->platform},
          {"software", info->software}};
  }
  return {{"version", kVersion},
          {"compiler", kCompiler},
          {"build_type", kBuildType},
          {"threads", machine.threads},
          {"cuda",
           {{"available", machine.cuda.unavailable_reason.empty()},
            {"device", machine.cuda.description},
            {"reason", machine.cuda.unavailable_reason}}},
          {"egl_devices", devices},
          {"gl", gl},
          {"tools", machine.tools}};
}

std::string text_of(const Machine& machine) {
  std::string text;
  const auto line = [&](const std::string& name, const std::string& what) {
    text += fmt::format("{:<13} {}\n", name, what);
  };
  line("ballpit", fmt::format("{}, {}, {}", kVersion, kCompiler, kBuildType));
  line("CPU threads", std::to_string(machine.threads));
  const std::string& reason = machine.cuda.unavailable_reason;
  line("CUDA", reason.empty() ? machine.cuda.description : "not here: " + reason);
  for (const EglDeviceInfo& device : machine.egl_devices) {
    line(fmt::format("EGL device {}", device.index), device.name + (device.software ? " (software)" : ""));
  }
  const auto& gl = machine.gl;
  line("OpenGL",
       gl ? fmt::format("{}, {}, {}", gl->version, gl->renderer, gl->platform) : "not here: " + machine.gl_error);
  for (const auto& [tool, path] : machine.tools) line(tool, path.empty() ? "not here (optional)" : path);
  return text;
}

}  // namespace

std::function<void()> make_doctor_command(CommandOptions& options) {
  const auto as_json = std::make_shared<bool>();
  options.add_flag("--json", *as_json, "print one JSON object");
  return [as_json] {
    const Machine machine = examine_machine();
    print(*as_json, json_of(machine), text_of(machine));
  };
}

}  // namespace ballpit
