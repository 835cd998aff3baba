// SPDX-License-Identifier: MIT
// Reads the values of options, and applies the settings that were given on the command line or in the panel. All
// functions throw UserError with the option, what was found and what is allowed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "methods/number_range.h"
#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

/// A number in a range. Throws UserError naming the option.
template <class T>
T parse_number(std::string_view option, const std::string& text, const Range<T>& range) {
  if (const std::optional<T> value = number_in(range, text)) return *value;
  constexpr const char* kKind = std::is_integral_v<T> ? "an integer" : "a number";
  throw UserError(option, text, fmt::format("{} from {}", kKind, text_of(range)));
}

/// One of `choices`. Throws UserError naming the option.
const std::string& parse_choice(std::string_view option, const std::string& text,
                                const std::vector<std::string>& choices);

/// The items of a list "a,b,c"; empty ones count.
std::vector<std::string> split_list(const std::string& text, char separator = ',');

/// The names of such a list, each of them known. `alone` is the word for none or all, which the caller knows.
std::vector<std::string> parse_names(std::string_view option, const std::string& text,
                                     const std::vector<std::string>& known, std::string_view alone);

/// Names of overlays, "a,b,c", or "none". Throws UserError naming the option.
std::vector<std::string> parse_overlays(std::string_view option, const std::string& text);

/// Throws UserError if the paths of two options lead to the same file.
void reject_same_file(std::string_view option, const std::string& path, std::string_view name,
                      const std::string& other);

struct PictureSize {
  int width, height;  ///< [pixel]
};

/// "1280x720".
std::string text_of(PictureSize size);

/// "1280x720". Throws UserError.
PictureSize parse_size(const std::string& text);

/// Applies them in their order. Throws UserError naming the option.
void apply_given(Settings& settings, const std::vector<GivenOption>& given);

/// Throws UserError if an option does not fit the response.
void check_given(const Settings& settings, const std::vector<GivenOption>& given);

/// The scene's defaults, overridden by the options given. If these choose another response, defaults that do not fit it
/// are left out. Throws UserError naming the option, or file and line.
Settings combine(const std::vector<DefaultOption>& defaults, const std::vector<GivenOption>& given);

/// Warns of cells smaller than a diameter. They are allowed because a lecture shows what they do.
void warn_of_small_cells(const Settings& settings);

}  // namespace ballpit
