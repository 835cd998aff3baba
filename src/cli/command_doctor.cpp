// SPDX-License-Identifier: MIT
// ballpit doctor: what this machine offers, and what is missing.
#include <iostream>
#include <thread>

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

Json examine_gl() {
  try {
    const GlContext context;
    const GlInfo& info = context.info();
    return {{"renderer", info.renderer},
            {"version", info.version},
            {"platform", info.platform},
            {"software", info.software}};
  } catch (const RunError& error) {
    return {{"error", error.what()}};
  }
}

Json examine_machine() {
  Json devices = Json::array();
  for (const EglDeviceInfo& device : list_egl_devices()) {
    devices.push_back({{"index", device.index}, {"name", device.name}, {"software", device.software}});
  }
  const Backend cuda = cuda_backend();
  Json tools;
  for (const char* tool : {"ffmpeg", "gnuplot"}) tools[tool] = find_program(tool);
  return {{"version", kVersion},
          {"compiler", kCompiler},
          {"build_type", kBuildType},
          {"threads", std::thread::hardware_concurrency()},
          {"cuda",
           {{"available", cuda.unavailable_reason.empty()},
            {"device", cuda.description},
            {"reason", cuda.unavailable_reason}}},
          {"egl_devices", devices},
          {"gl", examine_gl()},
          {"tools", tools}};
}

void print_text(const Json& found) {
  const auto line = [](const std::string& name, const std::string& text) {
    std::cout << name << std::string(14 - std::min<size_t>(13, name.size()), ' ') << text << "\n";
  };
  line("ballpit", found["version"].get<std::string>() + ", " + found["compiler"].get<std::string>() + ", " +
                      found["build_type"].get<std::string>());
  line("CPU threads", found["threads"].dump());
  line("CUDA", found["cuda"]["available"] ? found["cuda"]["device"].get<std::string>()
                                          : "not here: " + found["cuda"]["reason"].get<std::string>());
  for (const Json& device : found["egl_devices"]) {
    line("EGL device " + device["index"].dump(),
         device["name"].get<std::string>() + (device["software"] ? " (software)" : ""));
  }
  const Json& gl = found["gl"];
  line("OpenGL", gl.contains("error") ? "not here: " + gl["error"].get<std::string>()
                                      : gl["version"].get<std::string>() + ", " + gl["renderer"].get<std::string>() +
                                            ", " + gl["platform"].get<std::string>());
  for (const auto& [tool, path] : found["tools"].items()) {
    line(tool, path == "" ? "not here (optional)" : path.get<std::string>());
  }
}

class DoctorCommand final : public Command {
 public:
  void add_options(CommandOptions& command) override { command.add_flag("--json", json_, "print one JSON object"); }

  void run() override {
    const Json found = examine_machine();
    if (json_) {
      print_json(found);
    } else {
      print_text(found);
    }
  }

 private:
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_doctor_command() { return std::make_unique<DoctorCommand>(); }

}  // namespace ballpit
