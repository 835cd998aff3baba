// SPDX-License-Identifier: MIT
#include "show/given_options.h"

#include <optional>

#include <fmt/format.h>

#include "core/error.h"
#include "methods/methods.h"
#include "show/notes.h"

namespace ballpit {

void apply_given(Settings& settings, const std::vector<GivenOption>& given) {
  for (const GivenOption& option : given) apply_setting(settings, option.name, option.value, "--" + option.name);
}

void check_given(const Settings& settings, const std::vector<GivenOption>& given) {
  for (const GivenOption& option : given) {
    const std::string allowed = allowed_instead(settings.response, option.name, option.value);
    if (!allowed.empty()) throw UserError("--" + option.name, option.value, allowed);
  }
}

Settings combine(const std::vector<DefaultOption>& defaults, const std::vector<GivenOption>& given) {
  Settings settings;
  for (const DefaultOption& option : defaults) apply_setting(settings, option.key, option.value, option.where);
  const Response of_scene = settings.response;
  apply_given(settings, given);
  const Response response = settings.response;
  check_given(settings, given);
  Settings fitting;
  for (const DefaultOption& option : defaults) {
    const std::string allowed = allowed_instead(response, option.key, option.value);
    if (allowed.empty()) {
      apply_setting(fitting, option.key, option.value, option.where);
    } else if (response == of_scene) {
      throw UserError(option.where, option.value, allowed);
    }
  }
  apply_given(fitting, given);
  return fitting;
}

void warn_of_small_cells(const Settings& settings) {
  if (!can_miss_contacts(settings)) return;
  warn(fmt::format("--cell-size {:g}", *settings.cell_size),
       "below 1, the block of cells around a sphere does not reach all that touch it, so contacts are missed");
}

}  // namespace ballpit
