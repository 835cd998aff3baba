// SPDX-License-Identifier: MIT
// What a demonstration shows of the present moment: the inspection that the view wants, and the caption.
#include <cmath>

#include "core/numbers.h"
#include "core/phrase.h"
#include "render/notes_room.h"
#include "render/overlays/overlay.h"
#include "render/painter.h"
#include "show/demo.h"

namespace ballpit {

namespace {

constexpr int64_t kMaxListedCandidates = 2'000'000;  // listed for an overlay
constexpr int64_t kMaxForPicked = 100'000;           // candidates, and spheres, to search for the picked sphere
constexpr double kSmallestOccluded = 6;              // [pixel] radius of the largest spheres
constexpr int64_t kMaxForOracle = 20'000;            // spheres among which brute force searches for missed contacts

/// [m/s] After a fall through the domain, or at the start if that is faster.
float typical_speed(const Scene& scene) {
  const Vec3d size = scene.domain.max - scene.domain.min;
  double squared = 2 * length(scene.physics.gravity) * std::max({size.x, size.y, size.z});
  for (const Vec3d& velocity : scene.bodies.velocity) squared = std::max(squared, dot(velocity, velocity));
  return static_cast<float>(std::sqrt(squared));
}

}  // namespace

/// The parts of an inspection that the view shows.
Wanted Demo::wanted() {
  if (view.selected >= session.world().shape().count) view.selected = -1;  // it was dropped in later
  Wanted result = coloring_named(view.coloring).wanted;
  result.state |= view.selected >= 0;
  for (const OverlayEntry& overlay : overlay_table()) {
    if (view.shows(overlay.name)) result = result | overlay.wanted;
  }
  if (view.selected >= 0 && report().count <= kMaxForPicked) {
    result.candidates |= candidates_to_list() <= kMaxForPicked;
    result.endpoints = true;
  }
  return result;
}

/// An estimate. 0 for event-driven motion, whose report counts all forecasts so far; it lists few pairs.
int64_t Demo::candidates_to_list() {
  return session.settings().response == Response::event_driven ? 0 : report().candidates;
}

/// The wanted parts that would take too long for a picture.
Wanted Demo::too_much(const Wanted& wanted) {
  Wanted result;
  result.candidates = wanted.candidates && candidates_to_list() > kMaxListedCandidates;
  result.missed = wanted.missed && report().count > kMaxForOracle;
  return result;
}

bool Demo::shows_occlusion(int height) const {
  const Domain& domain = session.scene().domain;
  const Vec3d size = domain.max - domain.min;
  const double pixels = session.world().shape().radius * view.zoom * height / std::max({size.x, size.y, size.z});
  return view.occlusion && domain.dimensions == 3 && pixels >= kSmallestOccluded;
}

DomainBox Demo::box() const {
  const Domain& domain = session.scene().domain;
  DomainBox box{Vec3(domain.min), Vec3(domain.max), domain.dimensions, domain.boundary == Boundary::open_top,
                domain.boundary == Boundary::periodic};
  if (const std::optional<Extent>& framed = session.scene().view) box.framed = {Vec3(framed->min), Vec3(framed->max)};
  return box;
}

FrameView Demo::frame_view(float aspect, bool is_written, bool with_occluders, float share) {
  Wanted wanted = this->wanted();
  wanted.state |= !is_written;
  wanted.occluders |= with_occluders && !is_written;
  const Inspection& seen = inspect(wanted);
  const DomainBox box = this->box();
  const float below = room_below(view.overlays, seen, view.text_scale) / share;
  const View turned = view.turned(session.time());
  const bool has_page = view.has_caption || compared_;
  Room room;
  if (has_page) {
    caption_ = compared_ ? compared() : captioned();
    room = room_of(caption_, view.text_scale, aspect, share);
  }
  room.below += below;
  const auto camera = [&](const View& seen_from) {
    return has_page ? camera_of(seen_from, box, room, aspect)
                    : leave_room_below(camera_of(seen_from, box, aspect), below);
  };
  View whole = turned;
  whole.zoom = 1;
  const auto step = static_cast<float>(session.settings().dt / session.settings().substeps);
  FrameView shown{seen,
                  box,
                  camera(whole),
                  view.overlays,
                  view.selected,
                  view.coloring,
                  step,
                  left_out_,
                  is_written,
                  has_page ? &caption_ : nullptr,
                  view.shows("velocity") ? typical_speed(session.scene()) : 0,
                  aim ? &*aim : nullptr};
  shown.notes = notes_room(shown, view.text_scale / share, room.above);
  room.above += shown.notes.above;
  if (compared_) {  // beside a method that has cells, it needs no words that another one has none, but the same room
    std::erase_if(shown.overlays,
                  [&](const auto& name) { return !entry_named(overlay_table(), name, "").lack(seen).empty(); });
  }
  shown.camera = shown.notes.above > 0 ? camera_of(turned, box, room, aspect) : camera(turned);
  return shown;
}

std::string Demo::title() const {
  const Scene& scene = session.scene();
  const std::string& title = language() == Language::german ? scene.title_de : scene.title;
  return title.empty() ? scene.name : title;
}

PageView Demo::captioned() {
  PageView page;
  page.title = title();
  page.is_still = false;
  const Report& last = report();
  const int64_t n = last.count;
  const std::string spheres = counted(n, "sphere"), contacts = counted(last.contacts, "contact");
  if (session.settings().response == Response::event_driven) {
    const int64_t collisions = last.tally.collisions + last.tally.wall_hits;
    page.caption =
        phrase("{}: {}, {} so far", spheres, counted(collisions, "collision"), counted(last.events, "event"));
  } else if (last.candidates == 0) {
    page.caption = phrase("{}, {}", spheres, contacts);
  } else {
    page.caption = phrase("{}: {} in place of {}, {}", spheres, counted(last.candidates, "test"),
                          grouped(n * (n - 1) / 2), contacts);
  }
  return page;
}

std::string Demo::lack_of(const OverlayEntry& overlay) {
  if (!view.shows(overlay.name)) return "";
  const std::string lack = overlay.lack(inspection());
  for (const auto& other : beside_) {
    if (overlay.lack(other->inspection()).empty()) return "";
  }
  return lack;
}

const Inspection& Demo::inspect(Wanted wanted) {
  if (inspected_ == version()) {
    wanted = wanted | requested_;
    if (wanted == requested_) return inspection_;
  }
  requested_ = wanted;
  left_out_ = too_much(wanted);
  wanted.candidates &= !left_out_.candidates;
  wanted.missed &= !left_out_.missed;
  inspection_ = session.world().inspect(wanted);
  if (wanted.ghost) {
    follow();
    const bool is_exact = session.settings().response == Response::event_driven;
    inspection_.ghost = ghost_->inspect(session.world(), session.time(), session.settings().dt, is_exact);
  }
  inspected_ = version();
  return inspection_;
}

}  // namespace ballpit
