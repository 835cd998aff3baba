// SPDX-License-Identifier: MIT
#include "methods/settings.h"

#include <catch2/catch.hpp>

#include "core/error.h"
#include "methods/methods.h"

using namespace ballpit;

TEST_CASE("settings take values from text") {
  Settings settings;
  apply_setting(settings, "broadphase", "brute-force", "--broadphase");
  apply_setting(settings, "cell-size", "1.5", "--cell-size");
  apply_setting(settings, "table", "hashed", "--table");
  apply_setting(settings, "axis", "y", "--axis");
  apply_setting(settings, "skin", "0.25", "--skin");
  apply_setting(settings, "dt", "0.004166667", "--dt");
  apply_setting(settings, "threads", "8", "--threads");
  apply_setting(settings, "seed", "18446744073709551615", "--seed");
  CHECK(settings.broadphase == BroadPhase::brute_force);
  CHECK(settings.cell_size == 1.5);
  CHECK(settings.table == CellTable::hashed);
  CHECK(settings.axis == SweepAxis::y);
  CHECK(settings.skin == 0.25);
  CHECK(settings.dt == 0.004166667);
  CHECK(settings.threads == 8);
  CHECK(settings.seed == UINT64_MAX);
  CHECK_FALSE(settings.mass_ratio);
  apply_setting(settings, "mass-ratio", "1e6", "--mass-ratio");
  CHECK(settings.mass_ratio == 1e6);
}

TEST_CASE("a value that is not allowed names option, finding and choices") {
  struct Row {
    const char* name;
    const char* value;
    const char* message;
  };
  const Row row = GENERATE(values<Row>({
      {"broadphase", "magic",
       "--broadphase: found magic, allowed auto, brute-force, sort-and-sweep, linked-cell, sorted-grid, "
       "lecture/brute-force, lecture/sort-and-sweep, lecture/linked-cell"},
      {"table", "sparse", "--table: found sparse, allowed auto, dense, hashed"},
      {"axis", "w", "--axis: found w, allowed auto, x, y, z"},
      {"skin", "-0.1", "--skin: found -0.1, allowed 0 to 10"},
      {"dt", "0", "--dt: found 0, allowed 1e-12 to 10"},
      {"dt", "nan", "--dt: found nan, allowed 1e-12 to 10"},
      {"dt", "1s", "--dt: found 1s, allowed 1e-12 to 10"},
      {"cell-size", "-1", "--cell-size: found -1, allowed 0.05 to 1000"},
      {"threads", "1.5", "--threads: found 1.5, allowed 0 to 256"},
      {"threads", "257", "--threads: found 257, allowed 0 to 256"},
      {"count", "99999999999999999999", "--count: found 99999999999999999999, allowed 1 to 100000000"},
      {"seed", "-1", "--seed: found -1, allowed 0 to 18446744073709551615"},
      {"substeps", "", "--substeps: found nothing, allowed 1 to 1000"},
  }));
  Settings settings;
  CHECK_THROWS_WITH(apply_setting(settings, row.name, row.value, std::string("--") + row.name), row.message);
  CHECK_THROWS_AS(apply_setting(settings, row.name, row.value, "x"), UserError);
}

TEST_CASE("an unknown setting is refused with those that there are") {
  Settings settings;
  CHECK_THROWS_WITH(apply_setting(settings, "speed", "1", "a.toml:3: [defaults] speed"),
                    Catch::Contains("a.toml:3: [defaults] speed") && Catch::Contains("broadphase"));
}

TEST_CASE("every name of a method stands in the table of methods") {
  const auto check = [](auto value) { CHECK(find_method(value).name == name_of(value)); };
  for (const std::string_view name : kNames<BroadPhase>) check(named<BroadPhase>(name));
  for (const std::string_view name : kNames<Response>) check(named<Response>(name));
  for (const std::string_view name : kNames<Solver>) check(named<Solver>(name));
  for (const std::string_view name : kNames<Integrator>) check(named<Integrator>(name));
  for (const std::string_view name : kNames<Precision>) check(named<Precision>(name));
  for (const std::string_view name : kNames<BackendName>) check(named<BackendName>(name));
}

TEST_CASE(
    "a skin is as asked for, else a tenth where the program chooses the broad phase, and none where one is named") {
  Settings settings;
  for (const std::string_view method : kNames<BroadPhase>) {
    settings.broadphase = named<BroadPhase>(method);
    settings.skin.reset();
    CHECK(skin_of(settings) == (method == "auto" ? 0.1 : 0.0));
    settings.skin = 0.0;
    CHECK(skin_of(settings) == 0.0);
    settings.skin = 0.3;
    CHECK(skin_of(settings) == 0.3);
  }
}
