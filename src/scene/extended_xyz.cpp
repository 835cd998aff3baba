// SPDX-License-Identifier: MIT
#include "scene/extended_xyz.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "core/numbers.h"

namespace ballpit {

static constexpr size_t kFlushAt = 1 << 20;

ExtendedXyz::ExtendedXyz(const std::filesystem::path& path, const Domain& domain) : domain_(domain), file_(path) {}

ExtendedXyz::~ExtendedXyz() {
  try {
    finish();
  } catch (const RunError&) {
    // a destructor cannot report it
  }
}

void ExtendedXyz::append(double time, const Bodies& bodies, std::string_view note) {
  append_header(time, bodies, note);
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    const Vec3d &x = bodies.position[i], &v = bodies.velocity[i];
    buffer_ += "X ";  // ASE's name for something that is no chemical element; OVITO accepts any name
    append_numbers(buffer_, {x.x, x.y, x.z, bodies.radius[i], v.x, v.y, v.z, bodies.mass[i]});
    buffer_ += '\n';
    if (buffer_.size() >= kFlushAt) flush();
  }
  flush();
  whole_ = written_;
  ++frames_;
}

void ExtendedXyz::append_header(double time, const Bodies& bodies, std::string_view note) {
  const bool is_planar = domain_.dimensions == 2, is_periodic = domain_.boundary == Boundary::periodic;
  Vec3d origin = domain_.min, size = domain_.max - domain_.min;
  if (is_planar) {  // the thickness of the spheres: the readers refuse a cell without volume
    size.z = bodies.radius.empty() ? 1.0 : 2 * std::ranges::max(bodies.radius);
    origin.z = -0.5 * size.z;
  }
  buffer_ += fmt::format("{}\nLattice=\"", bodies.size());
  append_numbers(buffer_, {size.x, 0, 0, 0, size.y, 0, 0, 0, size.z});
  buffer_ += "\" Origin=\"";
  append_numbers(buffer_, {origin.x, origin.y, origin.z});
  buffer_ += "\" Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3:mass:R:1 Time=";
  append_number(buffer_, time);
  buffer_ += !is_periodic ? " pbc=\"F F F\"" : is_planar ? " pbc=\"T T F\"" : " pbc=\"T T T\"";
  buffer_ += note.empty() ? "\n" : fmt::format(" choice=\"{}\"\n", note);
}

void ExtendedXyz::flush() {
  file_->write(buffer_);
  written_ += static_cast<int64_t>(buffer_.size());
  buffer_.clear();
}

void ExtendedXyz::finish() {
  if (!file_) return;
  if (frames_ > 0) {
    file_->cut_to(whole_);  // a part of a frame that a full disk has left
    file_->commit();
  }
  file_.reset();
}

}  // namespace ballpit
