// SPDX-License-Identifier: MIT
#include "scene/table_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ballpit {

static int line_of(const toml::source_region& source) { return std::max(1, static_cast<int>(source.begin.line)); }

std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_quotes(text->get());
  if (const auto* number = node.as_floating_point()) return number_text(number->get());
  if (const auto* number = node.as_integer()) return std::to_string(number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* array = node.as_array()) return fmt::format("an array of {} values", array->size());
  return node.is_table() ? "a table" : "a date or time";
}

std::optional<int64_t> whole_number(const toml::node& node) {
  if (const auto* number = node.as_integer()) return number->get();
  const auto* number = node.as_floating_point();
  constexpr double kExact = 0x1p53;  // above it, not every integer is a double
  if (number == nullptr || !(std::abs(number->get()) <= kExact) || std::trunc(number->get()) != number->get()) {
    return std::nullopt;
  }
  return static_cast<int64_t>(number->get());
}

toml::table parse_toml(std::string_view text, std::string_view file_name) {
  try {
    return toml::parse(text, file_name);
  } catch (const toml::parse_error& error) {
    throw input_error({std::string(file_name), line_of(error.source())}, "",
                      fmt::format("a syntax error: {}", error.description()), "TOML 1.0");
  }
}

TableReader::TableReader(const toml::table& table, std::string file, std::string label, Keys keys)
    : table_(table), file_(std::move(file)), label_(std::move(label)) {
  for (const auto& [key, node] : table_) {
    if (keys.size() > 0 && std::find(keys.begin(), keys.end(), key.str()) == keys.end()) {
      throw error(key.str(), "an unknown key", join(keys));
    }
  }
}

Place TableReader::place(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return {file_, line_of(node != nullptr ? node->source() : table_.source())};
}

std::string TableReader::full_key(std::string_view key) const {
  return fmt::format("{}{}{}", label_, label_.empty() ? "" : " ", key);
}

double TableReader::number_at(const toml::node& node, std::string_view key, const Limits& limits) const {
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  if (value && limits.contains(*value)) return *value;
  const std::string allowed = (value ? "" : "a number, ") + limits_text(limits);
  throw input_error({file_, line_of(node.source())}, full_key(key), describe(node), allowed);
}

std::optional<double> TableReader::number(std::string_view key, const Limits& limits) const {
  const toml::node* node = table_.get(key);
  return node != nullptr ? std::optional(number_at(*node, key, limits)) : std::nullopt;
}

std::optional<int64_t> TableReader::integer(std::string_view key, int64_t low, int64_t high) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const std::optional<int64_t> value = whole_number(*node);
  if (value && *value >= low && *value <= high) return value;
  throw error(key, describe(*node), fmt::format("an integer, {} to {}", low, high));
}

std::optional<std::string> TableReader::text(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) throw error(key, describe(*node), "a text in quotes");
  return node->as_string()->get();
}

std::optional<size_t> TableReader::choice(std::string_view key, std::span<const std::string_view> names) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), node->value_or(std::string_view()));
  if (found == names.end()) throw error(key, describe(*node), join(names));
  return static_cast<size_t>(found - names.begin());
}

std::vector<size_t> TableReader::choices(std::string_view key, std::span<const std::string_view> names) const {
  std::vector<size_t> result;
  const toml::node* node = table_.get(key);
  if (node == nullptr) return result;
  if (!node->is_array()) throw error(key, describe(*node), "an array of texts: some of " + join(names));
  for (const toml::node& element : *node->as_array()) {
    const auto found = std::find(names.begin(), names.end(), element.value_or(std::string_view()));
    if (found == names.end()) throw error(key, describe(element), join(names));
    result.push_back(static_cast<size_t>(found - names.begin()));
  }
  return result;
}

std::optional<Vec3d> TableReader::vector(std::string_view key, int dimensions, const Limits& limits) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* array = node->as_array();
  const size_t size = array != nullptr ? array->size() : 0;
  if (size != 3 && (size != 2 || dimensions != 2)) {
    throw error(key, describe(*node), dimensions == 2 ? "an array of 2 or 3 numbers" : "an array of 3 numbers");
  }
  Vec3d result(0.0);
  for (size_t axis = 0; axis < size; ++axis) {
    result[static_cast<int>(axis)] = number_at((*array)[axis], fmt::format("{}[{}]", key, axis), limits);
  }
  if (dimensions == 2) result.z = 0.0;
  return result;
}

std::optional<Limits> TableReader::range(std::string_view key, const Limits& limits) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    const double value = number_at(*node, key, limits);
    return Limits{value, value};
  }
  if (array->size() != 2) throw error(key, describe(*node), "a number, or an array of 2 numbers, low and high");
  const Limits result{number_at((*array)[0], fmt::format("{}[0]", key), limits),
                      number_at((*array)[1], fmt::format("{}[1]", key), limits)};
  if (result.low <= result.high) return result;
  throw error(key, number_text(result.low) + " before " + number_text(result.high), "low before high");
}

std::vector<const toml::table*> TableReader::tables(std::string_view key) const {
  std::vector<const toml::table*> result;
  const toml::node* node = table_.get(key);
  if (node == nullptr) return result;
  const std::string allowed = fmt::format("tables [[{}]]", key);
  if (!node->is_array()) throw error(key, describe(*node), allowed);
  for (const toml::node& element : *node->as_array()) {
    if (!element.is_table()) {
      throw input_error({file_, line_of(element.source())}, full_key(key), describe(element), allowed);
    }
    result.push_back(element.as_table());
  }
  return result;
}

TableReader TableReader::section(std::string_view key, Keys keys) const {
  static const toml::table kEmpty;
  const toml::node* node = table_.get(key);
  if (node == nullptr) return nested(kEmpty, "", keys);
  const std::string outer = label_.empty() ? "" : label_.substr(1, label_.size() - 2) + ".";
  const std::string label = fmt::format("[{}{}]", outer, key);
  if (!node->is_table()) throw error(key, describe(*node), "a table " + label);
  return nested(*node->as_table(), label, keys);
}

}  // namespace ballpit
