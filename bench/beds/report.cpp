// SPDX-License-Identifier: MIT
#include "report.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

double best(const Turns& turns) { return *std::max_element(turns.speed.begin(), turns.speed.end()); }

/// "12.3 (12.9)": median and best.
std::string speed(const std::optional<Turns>& turns) {
  return turns ? fmt::format("{:.3g} ({:.3g})", spread_of(turns->speed).median, best(*turns)) : "-";
}

std::string energy(const std::optional<Turns>& turns) {
  return turns ? fmt::format("{:.6g}", turns->last.kinetic_energy) : "-";
}

std::string contacts(const std::optional<Turns>& turns, int64_t count) {
  if (!turns) return "-";
  return fmt::format("{:.4f}", 2.0 * static_cast<double>(turns->last.contacts) / static_cast<double>(count));
}

std::string searches(const std::optional<Turns>& turns) { return turns ? std::to_string(turns->last.searches) : "-"; }

/// "2.10 (min 2.01)": median and least of the turns.
std::string ratio(const BedRow& row) {
  if (!row.has_both()) return "-";
  const Spread spread = row.ratio();
  return fmt::format("{:.2f} (min {:.2f})", spread.median, spread.least);
}

std::string csv_of(const std::optional<Turns>& turns) {
  if (!turns) return ",,,,";
  return fmt::format("{:.6g},{:.6g},{:.9g},{},{}", spread_of(turns->speed).median, best(*turns),
                     turns->last.kinetic_energy, turns->last.contacts, turns->last.searches);
}

Json json_of(const Turns& turns) {
  const Spread spread = spread_of(turns.speed);
  return {{"median", spread.median},
          {"lower_quartile", spread.lower},
          {"upper_quartile", spread.upper},
          {"best", best(turns)},
          {"turns", turns.speed},
          {"kinetic_energy", turns.last.kinetic_energy},
          {"contacts", turns.last.contacts},
          {"searches", turns.last.searches}};
}

}  // namespace

std::string table_head() {
  return fmt::format(
      "Speeds are million particle-steps a second, median (best); contacts count for both spheres.\n"
      "{:6} {:>8} {:>6}  {:14} {:14} {:17} {:>21} {:>9} {:>17} {:>9}\n",
      "bed", "spheres", "volume", "ours", "LAMMPS", "ratio", "kinetic energies [J]", "differ by", "contacts a sphere",
      "searches");
}

std::string table_line(const BedRow& row) {
  return fmt::format("{:6} {:8} {:6.3f}  {:14} {:14} {:17} {:>21} {:>9} {:>17} {:>9}\n", row.bed, row.count,
                     row.fraction, speed(row.ours), speed(row.theirs), ratio(row),
                     energy(row.ours) + " " + energy(row.theirs),
                     row.has_both() ? fmt::format("{:.1e}", row.energy_difference()) : "-",
                     contacts(row.ours, row.count) + " " + contacts(row.theirs, row.count),
                     searches(row.ours) + " " + searches(row.theirs));
}

std::string csv_of(const std::vector<BedRow>& rows, const Stretch& stretch) {
  std::string text =
      "bed,count,volume_fraction,warmup,steps,ours_median,ours_best,ours_kinetic_energy,ours_contacts,ours_searches,"
      "lammps_median,lammps_best,lammps_kinetic_energy,lammps_contacts,lammps_searches,ratio_least,ratio_lower,"
      "ratio_median,ratio_upper,energy_difference\n";
  for (const BedRow& row : rows) {
    text += fmt::format("{},{},{:.4f},{},{},{},{}", row.bed, row.count, row.fraction, stretch.warmup, stretch.steps,
                        csv_of(row.ours), csv_of(row.theirs));
    if (row.has_both()) {
      const Spread spread = row.ratio();
      text += fmt::format(",{:.6g},{:.6g},{:.6g},{:.6g},{:.3g}\n", spread.least, spread.lower, spread.median,
                          spread.upper, row.energy_difference());
    } else {
      text += ",,,,,\n";
    }
  }
  return text;
}

Json json_of(const std::vector<BedRow>& rows) {
  Json list = Json::array();
  for (const BedRow& row : rows) {
    Json entry{{"bed", row.bed}, {"count", row.count}, {"volume_fraction", row.fraction}};
    if (row.ours) entry["ours"] = json_of(*row.ours);
    if (row.theirs) entry["lammps"] = json_of(*row.theirs);
    if (row.has_both()) {
      const Spread spread = row.ratio();
      entry["ratio"] = {
          {"least", spread.least}, {"lower", spread.lower}, {"median", spread.median}, {"upper", spread.upper}};
      entry["energy_difference"] = row.energy_difference();
    }
    list.push_back(entry);
  }
  return list;
}

}  // namespace ballpit
