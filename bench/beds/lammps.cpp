// SPDX-License-Identifier: MIT
#include "lammps.h"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <sstream>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "response/damping.h"

namespace ballpit {

namespace {

namespace fs = std::filesystem;

constexpr const char* kData = "bed.data";
constexpr const char* kInput = "bed.in";
constexpr const char* kLog = "bed.log";

/// Numbers as written, to the last bit.
std::ostringstream exact_stream() {
  std::ostringstream out;
  out.precision(17);
  return out;
}

/// The file that read_data reads, for atom_style sphere.
std::string data_file(const Scene& scene) {
  const Bodies& bodies = scene.bodies;
  const Vec3d low = scene.domain.min, high = scene.domain.max;
  std::ostringstream out = exact_stream();
  out << "Ballpit: bed " << scene.name << "\n\n" << bodies.size() << " atoms\n1 atom types\n\n";
  out << low.x << ' ' << high.x << " xlo xhi\n" << low.y << ' ' << high.y << " ylo yhi\n";
  out << low.z << ' ' << high.z << " zlo zhi\n\nAtoms # sphere: id type diameter density x y z\n\n";
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    const double r = bodies.radius[i];
    const Vec3d& p = bodies.position[i];
    const double density = bodies.mass[i] / (4.0 / 3 * std::numbers::pi * r * r * r);
    out << i + 1 << " 1 " << 2 * r << ' ' << density << ' ' << p.x << ' ' << p.y << ' ' << p.z << '\n';
  }
  out << "\nVelocities # id, linear, angular\n\n";
  for (size_t i = 0; i < bodies.velocity.size(); ++i) {
    const Vec3d& v = bodies.velocity[i];
    out << i + 1 << ' ' << v.x << ' ' << v.y << ' ' << v.z << " 0 0 0\n";
  }
  return out.str();
}

/// "hooke kₙ kₜ γₙ γₜ μ dampflag": arguments of pair_style gran/ and fix wall/gran. No tangential force.
std::string hooke(double stiffness, double restitution, double effective_mass) {
  std::ostringstream out = exact_stream();
  out << "hooke " << stiffness << " 0 " << 2 * damping_of(restitution, false) * std::sqrt(stiffness / effective_mass)
      << " 0 0 0";
  return out.str();
}

std::string input_script(const Bed& bed, const LammpsOptions& options, const Stretch& stretch) {
  const Physics& physics = bed.scene.physics;
  const Domain& domain = bed.scene.domain;
  const double mass = bed.scene.bodies.mass.front(), radius = bed.scene.bodies.radius.front();
  const std::string wall = hooke(physics.stiffness, physics.wall_restitution, mass);
  std::ostringstream out = exact_stream();
  out << "# Ballpit: bed " << bed.name << ", written by bench_beds\n"
      << "units si\natom_style sphere\nboundary f f f\n"
      << "newton " << (options.newton ? "on" : "off") << "\ncomm_modify vel yes\n"
      << "read_data " << kData << "\n\n"
      << "pair_style gran/" << hooke(physics.stiffness, physics.restitution, mass / 2) << "\npair_coeff * *\n"
      << "neighbor " << options.skin * radius << " bin\nneigh_modify delay 0 every 1 check yes\n\n"
      << "fix gravity all gravity " << -physics.gravity.y << " vector 0 -1 0\n"
      << "fix floor all wall/gran " << wall << " yplane " << domain.min.y << " NULL\n"
      << "fix walls_x all wall/gran " << wall << " xplane " << domain.min.x << ' ' << domain.max.x << '\n'
      << "fix walls_z all wall/gran " << wall << " zplane " << domain.min.z << ' ' << domain.max.z << '\n'
      << "fix motion all nve" << (options.rotates ? "/sphere" : "") << '\n'
      << "timestep " << bed.dt << "\n\n"
      << "thermo_style custom step ke\nthermo_modify norm no lost error\n"
      << "run " << stretch.warmup << "\nrun " << stretch.steps << "\n\n"
      << "compute contact all contact/atom\ncompute contacts all reduce sum c_contact\n"
      << "thermo_style custom step ke c_contacts\nthermo_modify norm no\nrun 0\n"
      << "print \"kinetic_energy $(ke:%.12g)\"\nprint \"contacts $(c_contacts/2:%.0f)\"\n";
  return out.str();
}

/// What follows `key` in the last line of `text` that starts with it, as a number.
double number_after(const std::string& text, const std::string& key, const fs::path& log) {
  const size_t start = text.rfind("\n" + key);
  if (start == std::string::npos) throw RunError(log.string(), "no line \"" + key + "\"");
  return std::strtod(text.c_str() + start + 1 + key.size(), nullptr);
}

/// The line that tells what went wrong, or an empty string.
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

/// Runs a program in a folder and returns its exit status; its output is dropped.
int run_program(const std::string& path, std::vector<std::string> arguments, const fs::path& folder) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const int failure = posix_spawn(&process, path.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw RunError(path, std::string("cannot run: ") + std::strerror(failure));
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) throw RunError(path, std::string("cannot wait for it: ") + std::strerror(errno));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool is_program(const fs::path& path) { return fs::is_regular_file(path) && access(path.c_str(), X_OK) == 0; }

}  // namespace

std::optional<Lammps> Lammps::find(const std::string& program) {
  if (program.find('/') != std::string::npos) {
    if (!is_program(program)) return std::nullopt;
    return Lammps(fs::absolute(program).string());
  }
  const char* variable = std::getenv("PATH");
  std::istringstream folders(variable ? variable : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path path = fs::path(folder) / program;
    if (is_program(path)) return Lammps(fs::absolute(path).string());
  }
  return std::nullopt;
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
  const int status = run_program(path_, {path_, "-in", kInput, "-log", kLog, "-screen", "none", "-nocite"}, folder);
  const std::string text = fs::exists(log) ? read_file(log) : "";
  if (status != 0) {
    throw RunError(path_, "ended with status " + std::to_string(status) + ": " + error_line(text));
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
