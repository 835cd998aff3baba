// SPDX-License-Identifier: MIT
// The language of what the audience reads: legends, the panel, lectures. Sources hold English; assets/german.toml holds
// what German readers see in its place. Messages of errors are English always, so that they can be searched for.
#pragma once

#include <string>
#include <string_view>

namespace ballpit {

enum class Language { english, german };

/// Of the whole program; English at the start.
Language language();
void set_language(Language language);

/// An English text in the language set. A text that the table lacks stays English.
std::string translated(std::string_view english);

/// Whether the table has a German text for it; for tests.
bool has_german(std::string_view english);

/// A text whose numbers have the decimal sign of the language set: "2.5 s" becomes "2,5 s".
std::string local_number(std::string text);

}  // namespace ballpit
