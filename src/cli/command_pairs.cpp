// SPDX-License-Identifier: MIT
// ballpit pairs: the overlapping pairs among spheres in a CSV file or a scene, and what it takes to find them.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <new>
#include <optional>
#include <sstream>

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

/// The shared options that change how a single search is made.
constexpr std::array<std::string_view, 6> kSearchSettings{"broadphase", "cell-size", "axis",
                                                          "table",      "backend",   "threads"};

/// The search works in float. Far from the origin, that rounds by more than small spheres allow.
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
  std::ostringstream text;
  text << "coordinates as large as " << farthest << " are rounded by up to " << step / 2
       << " m in single precision, beside a radius of " << smallest << " m: pairs are those of the rounded spheres";
  warn(file, text.str());
}

/// Views of the spheres: one radius where all are equal.
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
    command
        .add_option("FILE", file_,
                    "spheres as CSV: a header that names x, y, z, radius; or a built-in scene, or a .toml file, as at "
                    "the scene's start")
        ->type_name("CSV")
        ->required();
    out_option_ = command.add_option("--out", out_, "write the pairs there, as CSV")->type_name("FILE");
    command.add_option("--repeat", repeat_, "searches to make, each from the bare arrays; times are their median")
        ->type_name("N")
        ->shows_default();
    command.add_flag("--verify", verify_, "compare with an exact reference, which takes longer");
    period_option_ =
        command
            .add_option("--period", period_,
                        "lengths after which the spheres of a CSV file repeat, 0 for an axis along which they do not; "
                        "default: no period. A periodic scene has its own")
            ->type_name("X,Y,Z");
    command.add_flag("--json", json_, "print the summary as one JSON object");
    settings_.add_to(command, "Search (default: --broadphase auto)", kSearchSettings);
  }

  void run() override {
    parse_path("FILE", file_);
    if (out_option_->is_given()) parse_output("--out", out_);
    if (std::filesystem::is_regular_file(file_)) reject_same_file("--out", out_, "FILE", file_);
    std::optional<Vec3d> period;
    if (period_option_->is_given()) period = parse_period(period_);
    const int64_t repeat = parse_integer("--repeat", repeat_, 1, 10000);
    Settings settings;
    settings.broadphase = BroadPhase::automatic;
    apply_given(settings, settings_.given());
    warn_of_small_cells(settings);
    const Backend backend = select_backend(settings.backend);
    try {
      search(backend, settings, repeat, period);
    } catch (const std::bad_alloc&) {
      throw RunError(file_, "out of memory", "it has more spheres, or more of them overlap, than memory can hold");
    }
  }

 private:
  void search(const Backend& backend, const Settings& settings, int64_t repeat, const std::optional<Vec3d>& period) {
    const PairInput input = read_pair_input(file_, period);
    warn_of_rounding(input.spheres, file_);
    const SphereArrays arrays = arrays_of(input);
    PairsOutcome outcome;
    outcome.file = file_;
    outcome.count = input.spheres.size();
    outcome.period = input.period;
    outcome.backend = backend.name;
    if (backend.name == "cpu") outcome.threads = thread_count(settings.threads);
    const std::unique_ptr<PairSearch> search = search_repeatedly(backend, settings, arrays, repeat, outcome.seconds);
    outcome.report = search->report();
    outcome.work = profile_work(search->work_per_thread());
    if (verify_) outcome.deviation = verify(search->pairs(), arrays);
    if (!out_.empty()) {
      catch_interrupts();  // a file is begun: it is also ended
      write_file(out_, pairs_csv(search->pairs()));
    }
    const auto summary = summarize(outcome);
    if (json_) {
      print_json(summary);
    } else {
      std::cout << describe_pairs(summary);
    }
  }

  /// Every search starts from the bare arrays, and makes its structure anew; memory and threads are those of the first.
  static std::unique_ptr<PairSearch> search_repeatedly(const Backend& backend, const Settings& settings,
                                                       const SphereArrays& spheres, int64_t repeat,
                                                       std::vector<double>& seconds) {
    Progress progress("searches", repeat);
    std::unique_ptr<PairSearch> search;
    for (int64_t k = 0; k < repeat; ++k) {
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
  std::string file_;
  std::string out_;
  std::string period_;
  std::string repeat_ = "1";
  CommandOption *out_option_ = nullptr, *period_option_ = nullptr;
  bool verify_ = false;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_pairs_command() { return std::make_unique<PairsCommand>(); }

}  // namespace ballpit
