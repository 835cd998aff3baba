// SPDX-License-Identifier: MIT
#include "choose/candidates.h"

#include <set>

#include <catch2/catch.hpp>

#include "methods/methods.h"

using namespace ballpit;

namespace {

const Variant& variant(std::string_view name) {
  for (const Variant& v : variants()) {
    if (v.name == name) return v;
  }
  throw std::out_of_range(std::string(name));
}

std::optional<Settings> at(std::string_view name, int rung, const std::vector<GivenOption>& given = {}) {
  return settings_at(variant(name), rung, base_settings({}, given), given, 6);
}

std::string value_of(const std::vector<GivenOption>& options, std::string_view name) {
  for (const GivenOption& option : options) {
    if (option.name == name) return option.value;
  }
  return "";
}

}  // namespace

TEST_CASE("every response has a variant, and variants have different names") {
  std::set<std::string_view> names;
  std::set<Response> responses;
  for (const Variant& v : variants()) {
    CHECK(names.insert(v.name).second);
    responses.insert(v.response);
  }
  CHECK(responses.size() == kNames<Response>.size() - 1);  // all but auto
}

TEST_CASE("each second rung has steps half as long, which divide the duration") {
  CHECK(at("impulse", 0)->dt == Approx(6 / 60.0));
  for (int rung = 0; rung < 20; ++rung) {
    const double dt = at("impulse", rung)->dt, steps = 6 / dt;
    CHECK(steps == Approx(std::round(steps)).epsilon(1e-12));
    CHECK(dt / at("impulse", rung + 2)->dt == Approx(2).epsilon(0.02));
  }
  CHECK(at("event-driven", 0));
  CHECK_FALSE(at("event-driven", 1));
}

TEST_CASE("options that are given are kept, and exclude what does not fit them") {
  CHECK_FALSE(at("penalty", 0, {{"response", "impulse"}}));
  CHECK(at("impulse", 0, {{"response", "impulse"}}));
  CHECK(at("impulse", 0, {{"response", "auto"}}));
  CHECK_FALSE(at("event-driven", 0, {{"iterations", "7"}}));
  CHECK(at("impulse", 0, {{"dt", "0.01"}})->dt == 0.01);
  CHECK_FALSE(at("impulse", 1, {{"dt", "0.01"}}));
  CHECK(at("position-based", 3, {{"threads", "2"}, {"broadphase", "sorted-grid"}})->threads == 2);
  // Of the variants of impulses one stands for the iterations that are given.
  int count = 0;
  for (const Variant& v : variants()) {
    const auto settings = at(v.name, 0, {{"response", "impulse"}, {"iterations", "7"}});
    count += settings.has_value();
    if (settings) CHECK(settings->iterations == 7);
  }
  CHECK(count == 1);
}

TEST_CASE("options make the same settings again") {
  for (const Variant& v : variants()) {
    const Settings settings = *settings_at(v, 0, base_settings({}, {}), {}, 6);
    const std::vector<GivenOption> options = options_of(settings, {});
    const Settings again = base_settings({}, options);
    CHECK(typed(options_of(again, {})) == typed(options));
    CHECK(again.dt == settings.dt);
    CHECK(again.response == settings.response);
    CHECK(again.is_swept == settings.is_swept);
    for (const GivenOption& option : options) CHECK(goes_with(v.response, option.name, option.value));
  }
}

TEST_CASE("an option is named where the scene has another default") {
  const Settings settings = *at("impulse", 0);
  CHECK(value_of(options_of(settings, {}), "substeps").empty());
  CHECK(value_of(options_of(settings, {{"substeps", "10", ""}}), "substeps") == "1");
}

TEST_CASE("limits that stop a run are those of the scene") {
  Scene scene;
  scene.defaults = {{"max-overlap", "0.5", "a.toml:1"}, {"dt", "0.1", "a.toml:2"}, {"response", "penalty", "a.toml:3"}};
  const Settings settings = base_settings(scene, {});
  CHECK(settings.max_overlap == 0.5);
  CHECK(settings.dt == Settings{}.dt);
}
