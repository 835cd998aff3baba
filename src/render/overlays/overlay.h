// SPDX-License-Identifier: MIT
// Overlays show over the spheres what the simulation does. Each is a function that reads only the inspection, in a file
// of its own, and one entry of the table that command line, panel and tests use.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/painter.h"

namespace ballpit {

struct OverlayEntry {
  std::string_view name;                     ///< "grid", as typed
  std::string_view label;                    ///< "Grid cells", as the panel shows it
  void (*draw)(const FrameView&, Painter&);  ///< only a note if the inspection lacks the data
  Wanted wanted = {};                        ///< of the inspection, for drawing
  /// Part of the picture's height that it fills at the lower edge, with text of this scale.
  float (*room_below)(const Inspection&, float text_scale) = nullptr;
  std::string (*lacking)(const Inspection&) = nullptr;  ///< why the method gives it nothing to draw; "" if it does
  bool is_under_discs = false;                          ///< in planar scenes; all others are drawn after the bodies
  int notes = 0;                                        ///< lines that it writes at most, if they are wide

  std::string lack(const Inspection& inspection) const { return lacking ? lacking(inspection) : ""; }
};

/// All overlays, in the order in which they are drawn.
const std::vector<OverlayEntry>& overlay_table();

/// The part of the picture's height that these overlays fill together at the lower edge, for leave_room_below().
float room_below(const std::vector<std::string>& overlays, const Inspection& inspection, float text_scale = 1);

// The overlays; each file explains what it draws.
void draw_grid(const FrameView& view, Painter& painter);
bool draws_densest(const FrameView& view);  ///< whether the grid is drawn in its densest cells alone, with a note
void draw_pairs(const FrameView& view, Painter& painter);
void draw_velocities(const FrameView& view, Painter& painter);
void draw_swept(const FrameView& view, Painter& painter);
void draw_labels(const FrameView& view, Painter& painter);
void draw_lists(const FrameView& view, Painter& painter);
void draw_intervals(const FrameView& view, Painter& painter);
void draw_warps(const FrameView& view, Painter& painter);
void draw_ghost(const FrameView& view, Painter& painter);

/// Draws what the mouse is about to do, if it is.
void draw_aim(const FrameView& view, Painter& painter);

/// Marks the selected sphere and its cells, if there is one; a part of the grid.
void draw_selection(const FrameView& view, Painter& painter);

/// The parts of the picture's height that they fill.
float lists_room(const Inspection& inspection, float text_scale);
float intervals_room(const Inspection& inspection, float text_scale);
float warps_room(const Inspection& inspection, float text_scale);
float ghost_room(const Inspection& inspection, float text_scale);

/// The number of bodies in every cell: the length of its list.
std::vector<int> count_per_cell(const GridInspection& grid);

/// Entry k: the number of cells or buckets whose list or range has k bodies; entry `max` also counts longer ones.
std::vector<int> count_lengths(const GridInspection& grid, size_t max);

/// More candidates are only counted, not drawn.
inline constexpr size_t kMaxCandidates = 20000;

/// The candidates that are not contacts, each as often as it is tested.
std::vector<Pair> candidates_apart(const Inspection& inspection);

/// The index of a cell in the grid's `head`.
inline size_t index_of(const GridInspection& grid, const IVec3& cell) {
  return (static_cast<size_t>(cell.z) * static_cast<size_t>(grid.cells.y) + static_cast<size_t>(cell.y)) *
             static_cast<size_t>(grid.cells.x) +
         static_cast<size_t>(cell.x);
}

/// The cell that holds the body's centre.
IVec3 cell_of(const GridInspection& grid, const BodySnapshot& bodies, int64_t body);

/// Adds the edges of a box; none along an axis in which it is flat.
void add_box_edges(const Vec3& low, const Vec3& high, Rgba color, std::vector<Line>& lines);

/// A corner of cells. The last cells along an axis may extend beyond the domain; they are drawn up to its wall.
Vec3 lattice_point(const GridInspection& grid, const DomainBox& domain, const IVec3& corner);

/// A cell of a grid and its list.
struct ListedIn {
  IVec3 cell{0};
  int index = 0;                  ///< of the cell: head[index]
  bool is_sorted = false;         ///< a range of bodies sorted by cell, not a linked list
  std::vector<int32_t> bodies{};  ///< of the list, from its head on, or of the range
  size_t place = 0;               ///< index of the sphere in `bodies`
};

/// Empty if no grid lists the body.
std::optional<ListedIn> listed_in(const Inspection& inspection, int32_t body);

/// Cells from `low` (included) to `high` (excluded).
struct Block {
  IVec3 low, high;
};

/// The cells around the one that lists the body, without those outside of the grid; none if the grid does not list it.
std::optional<Block> block_around(const GridInspection& grid, const BodySnapshot& bodies, int64_t body);

/// [s] How long a sphere needs for the length of its velocity arrow; 0 if all are at rest.
float arrow_time(const FrameView& view);

/// The longest path until the next search for contacts, in diameters of its sphere: above 1, spheres may pass through
/// each other. 0 without velocities.
float longest_way(const FrameView& view);

/// A thread's walk along the sorted list: from a begin to the end of the same body.
struct Walk {
  int body = -1;
  size_t first = 0, last = 0;  ///< entries of the list
  std::vector<size_t> met;     ///< the begins between them, which the thread tests
};

/// The walk of the selected body; without a selection, the walk with the most tests. Its body is −1 if there is none.
Walk shown_walk(const std::vector<Endpoint>& endpoints, int64_t selected);

/// The other spheres of the pairs that contain the body, ascending.
std::vector<int32_t> partners_of(const std::vector<Pair>& pairs, int32_t body);

/// The spheres that touch the body, ascending; also those whose contact the method misses.
std::vector<int32_t> touching(const Inspection& inspection, int32_t body);

}  // namespace ballpit
