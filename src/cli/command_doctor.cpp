// SPDX-License-Identifier: MIT
// ballpit doctor: what this machine offers, and what is missing.
#include <iostream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/summary.h"
#include "core/error.h"
#include "core/program.h"
#include "render/gl_context.h"
#include "version.h"
#include "world/world.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

struct Tool {
  std::string name, path;  ///< no path: it is missing
};

struct Machine {
  unsigned threads = std::thread::hardware_concurrency();
  Backend cuda = cuda_backend();
  std::vector<EglDeviceInfo> egl_devices = list_egl_devices();
  std::optional<GlInfo> gl;
  std::string gl_error;
  std::vector<Tool> tools;
};

Machine examine_machine() {
  Machine machine;
  try {
    machine.gl = GlContext().info();
  } catch (const RunError& error) {
    machine.gl_error = error.what();
  }
  for (const char* tool : {"ffmpeg", "gnuplot"}) machine.tools.push_back({tool, find_program(tool)});
  return machine;
}

Json json_of(const Machine& machine) {
  Json devices = Json::array(), gl{{"error", machine.gl_error}}, tools;
  for (const EglDeviceInfo& device : machine.egl_devices) {
    devices.push_back({{"index", device.index}, {"name", device.name}, {"software", device.software}});
  }
  if (const auto& info = machine.gl) {
    gl = {{"renderer", info->renderer},
          {"version", info->version},
          {"platform", info->platform},
          {"software", info->software}};
  }
  for (const Tool& tool : machine.tools) tools[tool.name] = tool.path;
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
          {"tools", tools}};
}

void print_text(const Machine& machine) {
  const auto line = [](const std::string& name, const std::string& text) {
    std::cout << fmt::format("{:<13} {}\n", name, text);
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
  for (const Tool& tool : machine.tools) line(tool.name, tool.path.empty() ? "not here (optional)" : tool.path);
}

class DoctorCommand final : public Command {
 public:
  void add_options(CommandOptions& command) override { command.add_flag("--json", json_, "print one JSON object"); }

  void run() override {
    const Machine machine = examine_machine();
    if (json_) {
      print_json(json_of(machine));
    } else {
      print_text(machine);
    }
  }

 private:
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_doctor_command() { return std::make_unique<DoctorCommand>(); }

}  // namespace ballpit
