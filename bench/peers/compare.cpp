// SPDX-License-Identifier: MIT
#include "compare.h"

#include <algorithm>
#include <cstdlib>

#include <time.h>

#include "core/random.h"
#include "measure/exact_pairs.h"
#include "measure/statistics.h"

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

PeerTiming timing_of(const std::vector<double>& milliseconds) {
  const Spread spread = spread_of(milliseconds);
  return {spread.median, spread.upper - spread.lower};
}

PairSet pair_set(const std::vector<Pair>& pairs) {
  PairSet set{static_cast<int64_t>(pairs.size()), 0};
  for (const Pair& pair : pairs) {
    const auto low = static_cast<uint64_t>(std::min(pair.i, pair.j));
    const auto high = static_cast<uint64_t>(std::max(pair.i, pair.j));
    set.hash += Random(low << 32 | high).bits();
  }
  return set;
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

/// Makes malloc merge the small blocks that the last search has freed. Otherwise the next search pays for it (after
/// Bullet, 20 ms).
void settle() {
  for (int k = 0; k < 64; ++k) {
    void* volatile block = std::malloc(1 << 20);
    std::free(block);
  }
}

/// Time from bare arrays to pairs; clears `equal` if the pairs are wrong.
double time_cold(const Case& spheres, Peer& peer, Clock clock, bool& equal) {
  peer.forget();
  settle();
  const double time = milliseconds(clock, [&] { peer.find(spheres.start); });
  equal = equal && pair_set(peer.pairs()) == pair_set(spheres.start_pairs);
  return time;
}

/// The mean time of an update, ours and theirs, over a drift that both follow step by step. The first step is not
/// counted: only then does Bullet widen all its boxes at once.
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
    moving.position = state.position;  // in the same memory, as moving spheres would be
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
  spheres.start_pairs = exact_pairs(arrays_of(spheres.start));
  if (steps == 0) return spheres;
  for (int64_t k = 1; k <= steps + 1; ++k) spheres.drift.push_back(drifted(spheres.start, k, seed));
  spheres.last_set = pair_set(exact_pairs(arrays_of(spheres.drift.back())));
  return spheres;
}

Row compare_cold(const Case& spheres, const PeerInfo& peer, const PeerOptions& options, const Protocol& protocol) {
  Row row = row_of(spheres, peer, options, "cold");
  std::vector<double> our_times;
  std::vector<double> their_times;
  const std::unique_ptr<Peer> ours_made = ours().make(options), theirs_made = peer.make(options);
  for (int k = -1; k < protocol.cold; ++k) {  // the first turn warms up caches and memory
    const double our_time = time_cold(spheres, *ours_made, protocol.clock, row.equal);
    const double their_time = time_cold(spheres, *theirs_made, protocol.clock, row.equal);
    if (k < 0) continue;
    our_times.push_back(our_time);
    their_times.push_back(their_time);
  }
  row.equal = row.equal && ours_made->pairs() == spheres.start_pairs;  // ours must be in order
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
