// SPDX-License-Identifier: MIT
#include "render/overlays/overlay.h"

#include <algorithm>

#include "core/error.h"
#include "render/overlays/grid.h"

namespace ballpit {

const std::vector<OverlayEntry>& overlay_table() {
  static const std::vector<OverlayEntry> table = {
      {"grid", "Grid cells", [] { return std::unique_ptr<Overlay>(new GridOverlay); }},
  };
  return table;
}

std::vector<std::string> parse_overlays(const std::string& names) {
  std::vector<std::string> result;
  std::string rest = names;
  while (!rest.empty()) {
    const std::string name = rest.substr(0, rest.find(','));
    rest.erase(0, std::min(name.size() + 1, rest.size()));
    std::vector<std::string_view> known;
    for (const OverlayEntry& entry : overlay_table()) known.push_back(entry.name);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw UserError("unknown overlay '" + name + "'; overlays are: " + join(known));
    }
    result.push_back(name);
  }
  return result;
}

}  // namespace ballpit
