// SPDX-License-Identifier: MIT
// ballpit pairs: finds the overlapping pairs among spheres in a CSV file or a scene.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <new>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/pair_files.h"
#include "cli/progress.h"
#include "cli/summary.h"
#include "core/file.h"
#include "core/interrupt.h"
#include "measure/exact_pairs.h"
#include "measure/machine.h"
#include "measure/statistics.h"
#include "show/notes.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

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

struct PairsOutcome {
  std::string file;
  int64_t count = 0;            ///< spheres
  std::optional<Vec3d> period;  ///< [m] 0 along axes without a period; empty without any
  std::string backend;
  int threads = 0;                ///< of the CPU; 0 if it does not search
  std::vector<double> seconds{};  ///< [s] of each search, from bare arrays to the list
  SearchReport report{};
  WorkProfile work{};
  std::optional<Deviation> deviation{};  ///< from the exact reference, if it was computed
};

Json json_of(const WorkProfile& work) {
  Json histogram = Json::array();
  for (const WorkBin& bin : work.bins) {
    histogram.push_back({{"from", bin.low}, {"to", bin.high}, {"threads", bin.threads}});
  }
  return {{"threads", work.threads}, {"max", work.most},
          {"mean", work.mean},       {"histogram", histogram},
          {"warp_size", kWarpSize},  {"simd_efficiency", work.simd_efficiency ? Json(*work.simd_efficiency) : Json()}};
}

/// Stages of one search out of many, on average.
std::vector<Stage> mean_of(std::vector<Stage> stages, int64_t searches) {
  for (Stage& stage : stages) {
    stage.seconds /= static_cast<double>(searches);
    stage.launches /= searches;
  }
  return stages;
}

std::string text_of(const WorkProfile& work) {
  std::string text = fmt::format("{:g} a thread on average, at most {}", work.mean, work.most);
  if (!work.simd_efficiency) return text;
  return text + fmt::format("; warps of {} busy to {} %", kWarpSize, std::lround(100 * *work.simd_efficiency));
}

Json json_of(const PairsOutcome& outcome) {
  const SearchReport& report = outcome.report;
  Json json{{"file", outcome.file}, {"count", outcome.count}};
  if (outcome.period) json["period"] = {outcome.period->x, outcome.period->y, outcome.period->z};
  json["method"] = report.method;
  if (!report.reason.empty()) json["reason"] = report.reason;
  json["backend"] = outcome.backend;
  json["threads"] = outcome.threads > 0 ? Json(outcome.threads) : Json();
  json["contacts"] = report.contacts;
  json["candidates"] = report.candidates;
  if (outcome.deviation) {
    json["missed"] = outcome.deviation->missed;
    json["wrong"] = outcome.deviation->wrong;
    json["duplicate"] = outcome.deviation->duplicate;
  }
  const Spread spread = spread_of(outcome.seconds);
  json["repeat"] = outcome.seconds.size();
  json["seconds"] = spread.median;
  if (outcome.seconds.size() > 1) {
    json["seconds_min"] = spread.least;
    json["seconds_quartiles"] = {spread.lower, spread.upper};
  }
  json["bytes"] = report.bytes;
  json["work"] = json_of(outcome.work);
  json["stages"] = json_of(mean_of(report.stages, static_cast<int64_t>(outcome.seconds.size())));
  return json;
}

std::string text_of(const PairsOutcome& outcome) {
  const SearchReport& report = outcome.report;
  std::string text;
  const auto line = [&](const char* label, const std::string& value) {
    text += fmt::format("{:<18}{}\n", label, value);
  };
  line("spheres", fmt::format("{} in {}", outcome.count, outcome.file));
  if (const auto& period = outcome.period) {
    line("period", fmt::format("{}, {}, {} m", Json(period->x).dump(), Json(period->y).dump(), Json(period->z).dump()));
  } else {
    line("period", "none");
  }
  const std::string threads = outcome.threads > 0 ? fmt::format(", {} threads", outcome.threads) : "";
  const std::string reason = report.reason.empty() ? "" : "; chosen by auto: " + report.reason;
  line("method", fmt::format("{}, {}{}{}", report.method, outcome.backend, threads, reason));
  const Spread spread = spread_of(outcome.seconds);
  std::string took = fmt::format("{:g} s", spread.median);
  if (const size_t repeat = outcome.seconds.size(); repeat > 1) {
    took += fmt::format(", the median of {} searches; quartiles {:g} s and {:g} s", repeat, spread.lower, spread.upper);
  }
  line("took", took);
  line("memory", fmt::format("{:g} MB", static_cast<double>(report.bytes) / 1e6));
  line("contacts", fmt::format("{} among {} candidates", report.contacts, report.candidates));
  line("work", text_of(outcome.work));
  if (const auto& found = outcome.deviation) {
    line("against exact",
         fmt::format("{} missed, {} wrong, {} duplicate", found->missed, found->wrong, found->duplicate));
  }
  return text;
}

class PairsCommand {
 public:
  void add_options(CommandOptions& command) {
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
    add_settings(command, "Search (default: --broadphase auto)", given_, kSearchSettings);
  }

  void run() {
    if (!out_.empty()) check_output(out_);
    if (std::filesystem::is_regular_file(file_)) reject_same_file("--out", out_, "FILE", file_);
    Settings settings;
    settings.broadphase = BroadPhase::automatic;
    apply_given(settings, given_);
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
    PairsOutcome outcome{file_, input.spheres.size(), input.period, backend.name};
    if (backend.name == "cpu") outcome.threads = thread_count(settings.threads);
    const std::unique_ptr<PairSearch> search = search_repeatedly(backend, settings, arrays, outcome.seconds);
    outcome.report = search->report();
    outcome.work = profile_work(search->work_per_thread());
    if (verify_) outcome.deviation = verify(search->pairs(), arrays);
    if (!out_.empty()) {
      catch_interrupts();  // so that the file is complete
      write_file(out_, pairs_csv(search->pairs()));
    }
    print(json_, json_of(outcome), text_of(outcome));
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

  std::vector<GivenOption> given_;
  std::string file_, out_;
  std::optional<Vec3d> period_;  // [m]
  int repeat_ = 1;
  bool verify_ = false, json_ = false;
};

}  // namespace

std::function<void()> make_pairs_command(CommandOptions& options) { return make_command<PairsCommand>(options); }

}  // namespace ballpit
