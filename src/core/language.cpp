// SPDX-License-Identifier: MIT
#include "core/language.h"

#include <atomic>
#include <cctype>
#include <functional>
#include <map>

#include <toml++/toml.h>

#include "german_text.h"

namespace ballpit {

namespace {

std::atomic<Language> current = Language::english;  // read by threads that make choices, too

using Table = std::map<std::string, std::string, std::less<>>;

const Table& german() {
  static const Table table = [] {
    Table texts;
    const toml::table entries = toml::parse(german_text().front().text);
    for (const auto& [english, text] : entries) texts.emplace(english.str(), text.value_or(std::string()));
    return texts;
  }();
  return table;
}

}  // namespace

Language language() { return current; }
void set_language(Language language) { current = language; }

std::string translated(std::string_view english) {
  if (current == Language::english) return std::string(english);
  const auto entry = german().find(english);
  return entry == german().end() ? std::string(english) : entry->second;
}

bool has_german(std::string_view english) { return german().contains(english); }

std::string local_number(std::string text) {
  if (current == Language::english) return text;
  for (size_t k = 0; k + 1 < text.size(); ++k) {
    if (text[k] == '.' && std::isdigit(static_cast<unsigned char>(text[k + 1])) != 0) text[k] = ',';
  }
  return text;
}

}  // namespace ballpit
