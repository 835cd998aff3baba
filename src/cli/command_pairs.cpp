// SPDX-License-Identifier: MIT
// ballpit pairs: finds the overlapping pairs among spheres in a CSV file or a scene.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <new>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/pair_input.h"
#include "cli/pairs_summary.h"
#include "cli/progress.h"
#include "cli/summary.h"
#include "core/error.h"
#include "core/file.h"
#include "core/interrupt.h"
#include "measure/machine.h"
#include "show/backends.h"
#include "show/notes.h"

namespace ballpit {

namespace {

/// The settings that affect a single search.
constexpr std::array<std::string_view, 6> kSearchSettings{"broadphase", "cell-size", "axis",
                                                          "table",      "backend",   "threads"};

/// The search works in float, which rounds too much for small spheres far from the origin.
void warn_of_rounding(const RestingSpheres& spheres, const std::string& file) {
  constexpr float kAllowed = 0.01f;  // of the smallest radius
  if (spheres.size() == 0) return;
  float farthest = 0;
  for (const Vec3& p : spheres.position) {
    farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  const float step = std::nextafter(farthest, std::numeric_limits<float>::infinity()) - farthest;
  const float smallest = *std::min_element(spheres.radius.begin(), spheres.radius.end());
  if (step / 2 <= kAllowed * smallest) return;
  warn(file,
       fmt::format("coordinates as large as {:g} are rounded by up to {:g} m in single precision, beside a radius of "
                   "{:g} m: pairs are those of the rounded spheres",
                   farthest, step / 2, smallest));
}

/// Views of the spheres; a single radius if all are equal.
SphereArrays arrays_of(const PairInput& input) {
  const RestingSpheres& spheres = input.spheres;
  const std::vector<float>& radius = spheres.radius;
  const bool is_uniform =
      !radius.empty() && std::all_of(radius.begin(), radius.end(), [&](float r) { return r == radius.front(); });
  return {{spheres.position.data(), spheres.size()}, {radius.data(), is_uniform ? 1 : spheres.size()}, input.box};
}

class PairsCommand final : public Command {
 public:
  void add_options(CommandOptions& command) override {
    command.add_path({.name = "FILE",
                      .type = "CSV",
                      .help = "spheres as CSV: a header that names x, y, z, radius; or a built-in scene, or a .toml "
                              "file, as at the scene's start",
                      .is_required = true},
                     file_);
    command.add_path({"--out", "FILE", "write the pairs there, as CSV"}, out_);
    command.add_number({"--repeat", "N", "searches to make, each from the bare arrays; times are their median"},
                       repeat_, Range{1, 10'000});
    command.add_flag("--verify", verify_, "compare with an exact reference, which takes longer");
    command.add(
        {"--period", "X,Y,Z",
         "lengths after which the spheres of a CSV file repeat, 0 for an axis along which they do not; default: "
         "no period. A periodic scene has its own"},
        [this](const std::string& text) { period_ = parse_period(text); });
    command.add_flag("--json", json_, "print the summary as one JSON object");
    settings_.add_to(command, "Search (default: --broadphase auto)", kSearchSettings);
  }

  void run() override {
    if (!out_.empty()) check_output(out_);
    if (std::filesystem::is_regular_file(file_)) reject_same_file("--out", out_, "FILE", file_);
    Settings settings;
    settings.broadphase = BroadPhase::automatic;
    apply_given(settings, settings_.given());
    warn_of_small_cells(settings);
    const Backend backend = select_backend(settings.backend);
    try {
      search(backend, settings);
    } catch (const std::bad_alloc&) {
      throw RunError(file_, "out of memory", "it has more spheres, or more of them overlap, than memory can hold");
    }
  }

 private:
  void search(const Backend& backend, const Settings& settings) {
    const PairInput input = read_pair_input(file_, period_);
    warn_of_rounding(input.spheres, file_);
    const SphereArrays arrays = arrays_of(input);
    PairsOutcome outcome;
    outcome.file = file_;
    outcome.count = input.spheres.size();
    outcome.period = input.period;
    outcome.backend = backend.name;
    if (backend.name == "cpu") outcome.threads = thread_count(settings.threads);
    const std::unique_ptr<PairSearch> search = search_repeatedly(backend, settings, arrays, outcome.seconds);
    outcome.report = search->report();
    outcome.work = profile_work(search->work_per_thread());
    if (verify_) outcome.deviation = verify(search->pairs(), arrays);
    if (!out_.empty()) {
      catch_interrupts();  // so that the file is complete
      write_file(out_, pairs_csv(search->pairs()));
    }
    if (json_) {
      print_json(json_of(outcome));
    } else {
      std::cout << text_of(outcome);
    }
  }

  /// Every search starts from the bare arrays and builds its structure again, in the memory of the first one.
  std::unique_ptr<PairSearch> search_repeatedly(const Backend& backend, const Settings& settings,
                                                const SphereArrays& spheres, std::vector<double>& seconds) const {
    Progress progress("searches", repeat_);
    std::unique_ptr<PairSearch> search;
    for (int k = 0; k < repeat_; ++k) {
      const auto start = std::chrono::steady_clock::now();
      if (!search) search = backend.make_pair_search(settings);
      search->find(spheres);
      seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      progress.show(k + 1);
    }
    return search;
  }

  static Deviation verify(std::vector<Pair> found, const SphereArrays& spheres) {
    Progress progress("spheres verified", spheres.position.size());
    const std::vector<Pair> exact = exact_pairs(spheres, [&](int64_t done) { progress.show(done); });
    return deviation_of(std::move(found), exact);
  }

  SettingOptions settings_;
  std::string file_, out_;
  std::optional<Vec3d> period_;  // [m]
  int repeat_ = 1;
  bool verify_ = false, json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_pairs_command() { return std::make_unique<PairsCommand>(); }

}  // namespace ballpit
