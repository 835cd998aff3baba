// SPDX-License-Identifier: MIT
#include "compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <time.h>

namespace ballpit {

namespace {

double now_in_seconds(Clock clock) {
  timespec time{};
  clock_gettime(clock == Clock::wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Work>
double milliseconds(Clock clock, Work work) {
  const double start = now_in_seconds(clock);
  work();
  return 1e3 * (now_in_seconds(clock) - start);
}

/// Between two values, linearly.
double quantile(const std::vector<double>& sorted, double q) {
  const double place = q * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

Row row_of(const Case& spheres, const PeerInfo& peer, const PeerOptions& options, const char* mode) {
  Row row;
  row.family = spheres.family;
  row.count = spheres.start.count();
  row.threads = options.threads;
  row.peer = peer.name;
  row.mode = mode;
  row.pairs = static_cast<int64_t>(spheres.start_pairs.size());
  row.equal = true;
  return row;
}

/// Memory that the last search has freed in many small blocks is merged now: malloc would do so at the next one's
/// expense (after Bullet, 20 ms of it).
void settle() {
  for (int k = 0; k < 64; ++k) {
    void* volatile block = std::malloc(1 << 20);
    std::free(block);
  }
}

/// Time from bare arrays to pairs; `equal` is cleared where they are not those expected.
double time_cold(const Case& spheres, Peer& peer, Clock clock, bool& equal) {
  peer.forget();
  settle();
  const double time = milliseconds(clock, [&] { peer.find(spheres.start); });
  equal = equal && pair_set(peer.pairs()) == pair_set(spheres.start_pairs);
  return time;
}

/// The mean time of an update, ours and theirs, over a drift that both follow step by step. The first step is not
/// counted: in it, Bullet widens all its boxes, and never again all at once.
struct DriftTimes {
  double ours = 0;
  double theirs = 0;
};

DriftTimes time_drift(const Case& spheres, const PeerInfo& info, const PeerOptions& options, Clock clock, bool& equal) {
  const std::unique_ptr<Peer> our_search = ours().make(options);
  const std::unique_ptr<Peer> their_search = info.make(options);
  our_search->find(spheres.start);
  their_search->find(spheres.start);
  DriftTimes times;
  PairSet set;
  Spheres moving = spheres.start;
  for (const Spheres& state : spheres.drift) {
    moving.position = state.position;  // in the same place, as spheres that someone moves would be
    const double our_time = milliseconds(clock, [&] { our_search->update(moving); });
    const double their_time = milliseconds(clock, [&] { their_search->update(moving); });
    set = pair_set(our_search->pairs());
    equal = equal && set == pair_set(their_search->pairs());
    if (&state == &spheres.drift.front()) continue;
    times.ours += our_time;
    times.theirs += their_time;
  }
  equal = equal && set == spheres.last_set;
  const auto steps = static_cast<double>(spheres.drift.size() - 1);
  return {times.ours / steps, times.theirs / steps};
}

}  // namespace

Case make_case(const std::string& family, int64_t count, uint64_t seed, int64_t steps) {
  Case spheres{family, make_family(family, count, seed), {}, {}, {}};
  spheres.start_pairs = reference_pairs(spheres.start);
  if (steps == 0) return spheres;
  for (int64_t k = 1; k <= steps + 1; ++k) spheres.drift.push_back(drifted(spheres.start, k, seed));
  spheres.last_set = pair_set(reference_pairs(spheres.drift.back()));
  return spheres;
}

Timing timing_of(std::vector<double> milliseconds) {
  std::sort(milliseconds.begin(), milliseconds.end());
  return {quantile(milliseconds, 0.5), quantile(milliseconds, 0.75) - quantile(milliseconds, 0.25)};
}

Row compare_cold(const Case& spheres, const PeerInfo& peer, const PeerOptions& options, const Protocol& protocol) {
  Row row = row_of(spheres, peer, options, "cold");
  std::vector<double> our_times;
  std::vector<double> their_times;
  const std::unique_ptr<Peer> ours_made = ours().make(options), theirs_made = peer.make(options);
  for (int k = -1; k < protocol.cold; ++k) {  // the first of each warms caches and memory up
    const double our_time = time_cold(spheres, *ours_made, protocol.clock, row.equal);
    const double their_time = time_cold(spheres, *theirs_made, protocol.clock, row.equal);
    if (k < 0) continue;
    our_times.push_back(our_time);
    their_times.push_back(their_time);
  }
  row.equal = row.equal && ours_made->pairs() == spheres.start_pairs;  // ours are promised in order
  row.ours = timing_of(our_times);
  row.theirs = timing_of(their_times);
  return row;
}

Row compare_updates(const Case& spheres, const PeerInfo& peer, const PeerOptions& options, const Protocol& protocol) {
  Row row = row_of(spheres, peer, options, "update");
  std::vector<double> our_times;
  std::vector<double> their_times;
  for (int k = 0; k < protocol.drifts; ++k) {
    const DriftTimes times = time_drift(spheres, peer, options, protocol.clock, row.equal);
    our_times.push_back(times.ours);
    their_times.push_back(times.theirs);
  }
  row.ours = timing_of(our_times);
  row.theirs = timing_of(their_times);
  return row;
}

}  // namespace ballpit
