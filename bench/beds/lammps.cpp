// SPDX-License-Identifier: MIT
#include "lammps.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "core/error.h"
#include "core/file.h"
#include "core/program.h"
#include "response/pair_force.h"

namespace ballpit {

namespace {

namespace fs = std::filesystem;

constexpr const char* kData = "bed.data";
constexpr const char* kInput = "bed.in";
constexpr const char* kLog = "bed.log";

/// The file for read_data, in atom_style sphere. Numbers have 17 digits, so that they read back exactly.
std::string data_file(const Scene& scene) {
  const Bodies& bodies = scene.bodies;
  const Vec3d low = scene.domain.min, high = scene.domain.max;
  std::string text = fmt::format("Ballpit: bed {}\n\n{} atoms\n1 atom types\n\n", scene.name, bodies.size());
  for (int axis = 0; axis < 3; ++axis) {
    text += fmt::format("{0:.17g} {1:.17g} {2}lo {2}hi\n", low[axis], high[axis], "xyz"[axis]);
  }
  text += "\nAtoms # sphere: id type diameter density x y z\n\n";
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    const double r = bodies.radius[i];
    const Vec3d& p = bodies.position[i];
    const double density = bodies.mass[i] / (4.0 / 3 * std::numbers::pi * r * r * r);
    text += fmt::format("{} 1 {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, 2 * r, density, p.x, p.y, p.z);
  }
  text += "\nVelocities # id, linear, angular\n\n";
  for (size_t i = 0; i < bodies.velocity.size(); ++i) {
    const Vec3d& v = bodies.velocity[i];
    text += fmt::format("{} {:.17g} {:.17g} {:.17g} 0 0 0\n", i + 1, v.x, v.y, v.z);
  }
  return text;
}

/// "hooke kₙ kₜ γₙ γₜ μ dampflag": arguments of pair_style gran/ and fix wall/gran. No tangential force.
std::string hooke(double stiffness, double restitution, double effective_mass) {
  return fmt::format("hooke {:.17g} 0 {:.17g} 0 0 0", stiffness,
                     2 * damping_of(restitution, false) * std::sqrt(stiffness / effective_mass));
}

std::string input_script(const Bed& bed, const LammpsOptions& options, const Stretch& stretch) {
  const Physics& physics = bed.scene.physics;
  const Domain& domain = bed.scene.domain;
  const double mass = bed.scene.bodies.mass.front(), radius = bed.scene.bodies.radius.front();
  constexpr const char* kScript = R"script(# Ballpit: bed {name}, written by bench_beds
units si
atom_style sphere
boundary f f f
newton {newton}
comm_modify vel yes
read_data {data}

pair_style gran/{pair}
pair_coeff * *
neighbor {skin:.17g} bin
neigh_modify delay 0 every 1 check yes

fix gravity all gravity {gravity:.17g} vector 0 -1 0
fix floor all wall/gran {wall} yplane {floor:.17g} NULL
fix walls_x all wall/gran {wall} xplane {low_x:.17g} {high_x:.17g}
fix walls_z all wall/gran {wall} zplane {low_z:.17g} {high_z:.17g}
fix motion all nve{rotation}
timestep {dt:.17g}

thermo_style custom step ke
thermo_modify norm no lost error
run {warmup}
run {steps}

compute contact all contact/atom
compute contacts all reduce sum c_contact
thermo_style custom step ke c_contacts
thermo_modify norm no
run 0
print "kinetic_energy $(ke:%.12g)"
print "contacts $(c_contacts/2:%.0f)"
)script";
  return fmt::format(kScript, fmt::arg("name", bed.name), fmt::arg("newton", options.newton ? "on" : "off"),
                     fmt::arg("data", kData), fmt::arg("pair", hooke(physics.stiffness, physics.restitution, mass / 2)),
                     fmt::arg("skin", options.skin * radius), fmt::arg("gravity", -physics.gravity.y),
                     fmt::arg("wall", hooke(physics.stiffness, physics.wall_restitution, mass)),
                     fmt::arg("floor", domain.min.y), fmt::arg("low_x", domain.min.x), fmt::arg("high_x", domain.max.x),
                     fmt::arg("low_z", domain.min.z), fmt::arg("high_z", domain.max.z),
                     fmt::arg("rotation", options.rotates ? "/sphere" : ""), fmt::arg("dt", bed.dt),
                     fmt::arg("warmup", stretch.warmup), fmt::arg("steps", stretch.steps));
}

/// What follows `key` in the last line of `text` that starts with it, as a number.
double number_after(const std::string& text, const std::string& key, const fs::path& log) {
  const size_t start = text.rfind("\n" + key);
  if (start == std::string::npos) throw RunError(log.string(), "no line \"" + key + "\"");
  return std::strtod(text.c_str() + start + 1 + key.size(), nullptr);
}

/// The line of an error, or an empty string.
std::string error_line(const std::string& text) {
  const size_t start = text.find("ERROR");
  return start == std::string::npos ? "" : text.substr(start, text.find('\n', start) - start);
}

/// The log up to where the timed run ends, which the last one, `run 0`, follows.
std::string timed_part(const std::string& text, const fs::path& log) {
  const size_t last = text.rfind("\nLoop time of ");
  if (last == std::string::npos) throw RunError(log.string(), "no loop time");
  return text.substr(0, last);
}

/// The share of the wall time for which LAMMPS had a core: from "99.8% CPU use with 1 MPI tasks", the last such line.
double cpu_share(const std::string& text, const fs::path& log) {
  const size_t end = text.rfind("% CPU use with");
  if (end == std::string::npos) throw RunError(log.string(), "no CPU use");
  const size_t start = text.rfind('\n', end) + 1;
  return 0.01 * std::strtod(text.c_str() + start, nullptr);
}

}  // namespace

std::optional<Lammps> Lammps::find(const std::string& program) {
  const std::string path = find_program(program);
  if (path.empty()) return std::nullopt;
  return Lammps(fs::absolute(path).string());
}

void Lammps::prepare(const fs::path& folder, const Bed& bed, const LammpsOptions& options, const Stretch& stretch) {
  fs::create_directories(folder);
  write_file(folder / kData, data_file(bed.scene));
  write_file(folder / kInput, input_script(bed, options, stretch));
}

Measured Lammps::run(const fs::path& folder) {
  setenv("OMP_NUM_THREADS", "1", 1);
  const fs::path log = folder / kLog;
  fs::remove(log);
  const ProgramResult result =
      call_program({path_, {"-in", kInput, "-log", kLog, "-screen", "none", "-nocite"}, "", folder.string()});
  const std::string text = fs::exists(log) ? read_file(log) : "";
  if (result.status != 0) {
    throw RunError(path_, fmt::format("ended with status {}: {}{}", result.status, error_line(text), result.errors));
  }
  const size_t open = text.find('('), close = text.find(")\n");
  if (open < close && close < 80) version_ = text.substr(open + 1, close - open - 1);
  const std::string timed = timed_part(text, log);
  if (number_after(timed, "Dangerous builds = ", log) > 0) {
    throw RunError(log.string(), "LAMMPS built neighbour lists too late");
  }
  Measured measured;
  measured.seconds = number_after(timed, "Loop time of ", log);
  measured.cpu_seconds = measured.seconds * cpu_share(timed, log);
  measured.kinetic_energy = number_after(text, "kinetic_energy ", log);
  measured.contacts = static_cast<int64_t>(number_after(text, "contacts ", log));
  measured.searches = static_cast<int64_t>(number_after(timed, "Neighbor list builds = ", log));
  return measured;
}

}  // namespace ballpit
