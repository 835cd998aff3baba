// SPDX-License-Identifier: MIT
// Reads one TOML table strictly: unknown keys, wrong types and values outside their limits are UserErrors that name file, line
// and key. Only the readers of scenes include this.
// Source: TOML 1.0 by toml++ (https://marzer.github.io/tomlplusplus/).
#pragma once

#include <optional>
#include <span>

#include <toml++/toml.h>

#include "core/math.h"
#include "scene/input_error.h"

namespace ballpit {

class TableReader {
 public:
  using Keys = std::initializer_list<std::string_view>;

  /// Throws UserError if `table` has keys other than `keys`; all are allowed if `keys` is empty. `label` is "[physics]", or ""
  /// at the top level. `table` must outlive the reader.
  TableReader(const toml::table& table, std::string file, std::string label, Keys keys);

  /// A reader for a table inside of this one.
  TableReader nested(const toml::table& table, std::string label, Keys keys) const {
    return {table, file_, std::move(label), keys};
  }

  const toml::table& table() const { return table_; }
  const std::string& file() const { return file_; }
  bool has(std::string_view key) const { return table_.contains(key); }

  /// The place of the key in the file, or of the table if it lacks the key.
  Place place(std::string_view key) const;

  // Each is empty if the table lacks the key.
  std::optional<double> number(std::string_view key, const Limits& limits) const;
  std::optional<int64_t> integer(std::string_view key, int64_t low, int64_t high) const;
  std::optional<std::string> text(std::string_view key) const;
  /// The index of the value among `names`.
  std::optional<size_t> choice(std::string_view key, std::span<const std::string_view> names) const;
  /// The indices of the values of an array; empty if the table lacks the key.
  std::vector<size_t> choices(std::string_view key, std::span<const std::string_view> names) const;
  /// `dimensions` numbers, or three; in planar scenes z is 0.
  std::optional<Vec3d> vector(std::string_view key, int dimensions, const Limits& limits) const;
  /// A number, or an array of two in order.
  std::optional<Limits> range(std::string_view key, const Limits& limits) const;
  /// The tables of an array [[key]].
  std::vector<const toml::table*> tables(std::string_view key) const;
  /// The table [key]; an empty one if it is missing.
  TableReader section(std::string_view key, Keys keys) const;

  /// For the caller to throw.
  UserError error(std::string_view key, std::string_view found, std::string_view allowed) const {
    return input_error(place(key), full_key(key), found, allowed);
  }
  UserError missing(std::string_view key, std::string_view allowed) const { return error(key, "nothing", allowed); }

 private:
  /// "[physics] restitution".
  std::string full_key(std::string_view key) const;
  double number_at(const toml::node& node, std::string_view key, const Limits& limits) const;

  const toml::table& table_;
  std::string file_;
  std::string label_;
};

/// A value as an error shows it: 1.5, "high", true, an array of 2 values.
std::string describe(const toml::node& node);

/// The value of an integer, or of a float without a fraction: 10, 10.0, 1e5. Empty for others.
std::optional<int64_t> whole_number(const toml::node& node);

/// Parses a whole file. Throws UserError with the line and the reason of a syntax error.
toml::table parse_toml(std::string_view text, std::string_view file_name);

}  // namespace ballpit
