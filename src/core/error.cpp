// SPDX-License-Identifier: MIT
#include "core/error.h"

#include <fmt/format.h>

namespace ballpit {

namespace {

/// Both texts with the separator between them, unless one is empty.
std::string joined(std::string_view first, std::string_view separator, std::string_view second) {
  return fmt::format("{}{}{}", first, first.empty() || second.empty() ? "" : separator, second);
}

std::string user_line(std::string_view where, std::string_view found, std::string_view allowed, std::string_view hint) {
  const char* const quote = !found.empty() && found.find_first_not_of(' ') == std::string_view::npos ? "\"" : "";
  const std::string_view shown = found.empty() ? "nothing" : found;
  return joined(fmt::format("{0}: found {1}{2}{1}, allowed {3}", where, quote, shown, allowed), "; ", hint);
}

}  // namespace

UserError::UserError(std::string_view where, std::string_view found, std::string_view allowed, std::string_view hint)
    : std::runtime_error(user_line(where, found, allowed, hint)),
      where_(where),
      found_(found),
      allowed_(allowed),
      hint_(hint) {}

UserError UserError::inside(std::string_view outer) const {
  return {joined(outer, ": ", where_), found_, allowed_, hint_};
}

RunError::RunError(std::string_view where, std::string_view what_happened, std::string_view more)
    : std::runtime_error(joined(joined(where, ": ", what_happened), "; ", more)),
      where_(where),
      what_happened_(what_happened),
      more_(more) {}

RunError RunError::inside(std::string_view outer) const {
  return where_ == outer ? *this : RunError(joined(outer, ": ", where_), what_happened_, more_);
}

RunError RunError::with(std::string_view more) const { return {where_, what_happened_, joined(more_, "; ", more)}; }

}  // namespace ballpit
