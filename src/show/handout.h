// SPDX-License-Identifier: MIT
// The handout of a lecture: a picture of each page, and one HTML page that holds all of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ballpit {

/// A picture of the handout, with what belongs to it.
struct HandoutPicture {
  std::string id;  ///< of its section: letters, digits and '-'
  std::string title, caption, notes;
  std::string png;  ///< the file's bytes
};

/// The whole page: pictures with alternative texts, and notes that open on request. Arrow keys and touch step through
/// it, and it prints a picture per sheet.
std::string handout_page(std::string_view title, const std::vector<HandoutPicture>& pictures);

/// In the alphabet of RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace ballpit
