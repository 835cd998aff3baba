// SPDX-License-Identifier: MIT
// simulate --observe: values with their units, as JSON and for people.
#include <sstream>

#include <catch2/catch.hpp>

#include "cli/summary.h"
#include "methods/methods.h"
#include "tests/cli/run_simulate.h"
#include "tests/support/run_program.h"

using namespace ballpit;
using Catch::Contains;

namespace {

nlohmann::json summary_of(const Arguments& arguments) { return run_simulate(arguments).json(); }

nlohmann::json observed(const Arguments& arguments) { return summary_of(arguments)["observables"]; }

/// A scene of a row of spheres, each overlapping its neighbours, across the border where the domain is periodic.
std::string row_of_spheres(const Scratch& folder, const std::string& boundary) {
  std::ostringstream scene;
  scene << "[domain]\nmin = [0, 0, 0]\nmax = [1.9, 1, 1]\nboundary = '" << boundary
        << "'\n[physics]\ninitial_overlap = 1\n";
  for (int i = 0; i < 10; ++i) {
    scene << "[[spheres]]\nposition = [" << 0.1 + 0.19 * i << ", 0.5, 0.5]\nradius = 0.1\n";
  }
  write_text(folder / "row.toml", scene.str());
  return folder / "row.toml";
}

}  // namespace

TEST_CASE("every observable is printed with its value and unit") {
  const nlohmann::json values = observed({"bouncing-balls", "--time", "0.1", "--observe", "all"});
  for (const Observable& observable : observables()) {
    INFO(observable.name);
    const nlohmann::json& entry = values.at(std::string(observable.name));
    CHECK(entry.size() == 2);
    CHECK(entry["unit"] == observable.unit);
    if (observable.name == "diffusion") {
      CHECK(entry["value"].is_null());  // walls
    } else {
      CHECK((observable.name == "momentum" ? entry["value"].size() == 3 : entry["value"].is_number()));
    }
  }
  CHECK(values.size() == observables().size());
}

TEST_CASE("observables agree with the summary, and only those that were asked for are printed") {
  const nlohmann::json summary = summary_of(
      {"bouncing-balls", "--time", "0.1", "--observe", "momentum,kinetic-energy,max-overlap,kinetic-energy"});
  const nlohmann::json& values = summary["observables"];
  CHECK(values.size() == 3);
  CHECK(values["kinetic-energy"]["value"] == summary["kinetic_energy"]);
  CHECK(values["momentum"]["value"] == summary["momentum"]);
  CHECK(values["max-overlap"]["value"] == summary["max_overlap"]);
  CHECK_FALSE(summary_of({"two-spheres", "--time", "0"}).contains("observables"));
}

TEST_CASE("two spheres that fly are observed to have the energy and height that their scene says") {
  // 2 spheres of π/6 kg·(2·radius)³·1000 at 1 m/s, in opposite directions
  const nlohmann::json values =
      observed({"two-spheres", "--time", "0", "--observe", "temperature,mean-square-speed,momentum,velocity-moment"});
  CHECK(values["mean-square-speed"]["value"].get<double>() == Approx(1.0));
  CHECK(values["velocity-moment"]["value"].get<double>() == Approx(1.0));
  CHECK(values["momentum"]["value"][0].get<double>() == Approx(0.0).margin(1e-9));
  CHECK(values["temperature"]["value"].get<double>() > 0);
}

TEST_CASE("what has no value is null in JSON, and a dash for people") {
  CHECK(observed({"two-spheres", "--time", "0", "--observe", "pressure"})["pressure"]["value"].is_null());
  const Outcome outcome = run_program({"simulate", "two-spheres", "--time", "0", "--observe", "all"});
  CHECK_THAT(outcome.out, Catch::Matches("(.|\n)*\npressure +-\n(.|\n)*") && !Contains("nan") && !Contains("inf"));
}

TEST_CASE("the text lists observables in aligned lines with their units") {
  const Outcome outcome = run_program(
      {"simulate", "two-spheres", "--time", "0", "--observe", "mean-square-speed,collisions-per-sphere,momentum"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("\nmean-square-speed       1 m²/s²\n") &&
                              Contains("\ncollisions-per-sphere   0\n") &&
                              Contains("\nmomentum                0, 0, 0 kg·m/s\n"));
}

TEST_CASE("pressure is a force on a length in planar scenes, and on an area in others") {
  CHECK(observed({"lecture-grid", "--time", "0.1", "--observe", "pressure"})["pressure"]["unit"] == "N/m");
  CHECK(observed({"bouncing-balls", "--time", "0.1", "--observe", "pressure"})["pressure"]["unit"] == "Pa");
}

TEST_CASE("contacts that small cells miss are counted, and are those that brute force finds besides") {
  const Scratch folder;
  for (const char* boundary : {"walls", "periodic"}) {
    INFO(boundary);
    const std::string scene = row_of_spheres(folder, boundary);
    const int64_t all = summary_of({scene, "--time", "0", "--broadphase", "brute-force"})["contacts"];
    CHECK(all == (boundary == std::string("walls") ? 9 : 10));
    const Arguments small{"--time", "0", "--cell-size", "0.5", "--observe", "missed-contacts"};
    for (const char* method : {"linked-cell", "sorted-grid"}) {
      const nlohmann::json summary = summary_of(with({scene, "--broadphase", method}, small));
      const double missed = summary["observables"]["missed-contacts"]["value"];
      if (method == std::string("linked-cell")) CHECK(missed > 0);  // a sorted grid may look farther
      CHECK(missed == static_cast<double>(all - summary["contacts"].get<int64_t>()));
    }
  }
}

TEST_CASE("no broad phase misses a contact with cells of its own choice") {
  const Scratch folder;
  for (const std::string_view method : kNames<BroadPhase>) {
    INFO(method);
    CHECK(observed({row_of_spheres(folder, "periodic"), "--time", "0", "--broadphase", std::string(method), "--observe",
                    "missed-contacts"})["missed-contacts"]["value"] == 0);
    CHECK(observed({"lecture-grid", "--time", "5.3", "--broadphase", std::string(method), "--observe",
                    "missed-contacts"})["missed-contacts"]["value"] == 0);
  }
}

TEST_CASE("a world keeps a tally where an observable needs it, and only there") {
  CHECK(need_tally(parse_observables("kinetic-energy,pressure")));
  CHECK_FALSE(need_tally(parse_observables("kinetic-energy,temperature")));
  CHECK(Session("two-spheres", {}, true).settings().keeps_tally);
  CHECK_FALSE(Session("two-spheres", {}).settings().keeps_tally);
}

TEST_CASE("observing changes nothing that is simulated") {
  const Arguments run{"bouncing-balls", "--count", "200", "--time", "0.5"};
  Arguments watched = run;
  watched.insert(watched.end(), {"--observe", "all"});
  CHECK(summary_of(watched)["state_hash"] == summary_of(run)["state_hash"]);
}

TEST_CASE("an observation that begins later counts the collisions after that, and the ways") {
  const Arguments gas{"gas-thin", "--time", "2", "--observe", "collisions-per-sphere,diffusion"};
  Arguments later = gas;
  later.insert(later.end(), {"--observe-from", "1"});
  const nlohmann::json all = observed(gas), half = observed(later);
  const double collisions = all["collisions-per-sphere"]["value"];
  CHECK(half["collisions-per-sphere"]["value"] > 0.4 * collisions);
  CHECK(half["collisions-per-sphere"]["value"] < 0.6 * collisions);
  CHECK(half["diffusion"]["value"] > 0);
  CHECK(half["diffusion"]["unit"] == "m²/s");
}
