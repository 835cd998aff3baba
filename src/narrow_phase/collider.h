// SPDX-License-Identifier: MIT
// Finds contacts: the broad phase, the candidate list where there is a skin, and the narrow phase. A world and a pair
// search each have one.
//
//     bodies ──▶ candidate list fresh? ──yes──▶ test the list ─────────────────────────┐
//                    │ no, or no skin                                                   ├──▶ contacts in canonical order
//                    └──▶ broad phase ──▶ test its candidates (lists or ranges) ───────┘
//
// Contacts and their order do not depend on the path.
//
// The collider alone knows what is up to date. What it found holds until moved(), for one margin; the candidate list
// holds as long as no body has left its skin (candidate_list.h). So asking for a stage again costs nothing.
#pragma once

#include <stdexcept>
#include <utility>
#include <variant>

#include "broad_phase/brute_force.h"
#include "broad_phase/linked_cell.h"
#include "broad_phase/sort_and_sweep.h"
#include "broad_phase/sorted_grid.h"
#include "lecture/methods.h"
#include "narrow_phase/contact_list.h"
#include "narrow_phase/vector_search.h"

namespace ballpit {

/// Which pairs a response asks for. All are in canonical order.
enum class ContactKind {
  touching,      ///< in contact; measured, and listed by body
  near,          ///< all contacts and perhaps others, not measured: the candidate list as it is
  near_by_body,  ///< the same, listed by body
};

template <class V, class Exec>
class Collider {
  using Real = Scalar<V>;

 public:
  using AnyBroadPhase = std::variant<BruteForce<V, Exec>, SortAndSweep<V, Exec>, LinkedCell<V, Exec>,
                                     SortedGrid<V, Exec>, lecture::BruteForceMethod<V, Exec>,
                                     lecture::SortAndSweepMethod<V, Exec>, lecture::LinkedCellMethod<V, Exec>>;

  struct Searches {
    int64_t count = 0;         ///< so far
    bool has_present = false;  ///< the last one was at the present positions
  };

  Collider() = default;  ///< call plan() before use

  /// Detects as the settings say; `parameters` describe the bodies with their margin and without skins.
  Collider(const Settings& settings, const BroadPhaseParameters<V>& parameters) {
    plan(choose_broad_phase(settings, parameters), parameters, skin_of(settings));
  }

  /// Starts anew, in the memory held. `choice` names a broad phase; `skin` is a fraction of each radius.
  void plan(BroadPhaseChoice choice, BroadPhaseParameters<V> parameters, double skin);

  /// Call after changing positions.
  void moved() {
    source_ = Source::none;
    is_counted_ = false;
    list_.moved();
  }

  /// Call after exchanging bodies, or sorting them in memory.
  void discard() {
    moved();
    list_.discard();
    linked_search_ = -1;
  }

  /// The same, after going back to where so many searches had been made.
  void discard(const Searches& searches) {
    discard();
    searches_ = searches.count;
    is_counted_ = searches.has_present;
  }

  /// Stage 1, broad phase: finds candidates, unless the candidate list is fresh. Spheres within `margin` [m] of each
  /// other count as touching.
  void find_candidates(Exec& exec, const BodiesView<V>& bodies, Real margin = 0) {
    if (source_ != Source::none && margin_ == margin) return;
    margin_ = margin;
    bodies_ = margin > 0 ? grow_radii(exec, bodies, Real(1), margin, grown_) : bodies;
    is_tested_ = false;
    source_ = has_fresh_list(exec) ? Source::list : Source::broad_phase;
    if (source_ == Source::broad_phase) prepare(exec, bodies_);
  }

  /// Stage 2, narrow phase: the pairs of this kind, after find_candidates() with the same margin.
  ContactsView<V> find_contacts(Exec& exec, const BodiesView<V>& bodies, ContactKind kind) {
    const bool is_list = kind != ContactKind::touching && source_ == Source::list;
    if (!is_list) test_candidates(exec);
    ContactRows<Exec>& rows = is_list ? list_.rows() : rows_;
    if (kind == ContactKind::touching) {
      contacts_.build(exec, rows, bodies, box());
      return contacts_.view();
    }
    if (kind == ContactKind::near) {
      rows.sort(exec);
      return {rows.pairs(), {}, rows.first(), {}, {}};
    }
    if (linked_search_ != searches_) {
      rows.sort(exec);
      near_.link(exec, rows);
      linked_search_ = searches_;
    }
    return near_.view();
  }

  /// Both stages: the pairs in contact.
  Span<const Pair> pairs(Exec& exec, const BodiesView<V>& bodies) {
    find_candidates(exec, bodies);
    test_candidates(exec);
    rows_.sort(exec);
    return rows_.pairs();
  }

  /// Both stages: pairs that include all contacts.
  Span<const Pair> near_pairs(Exec& exec, const BodiesView<V>& bodies) {
    find_candidates(exec, bodies);
    return find_contacts(exec, bodies, ContactKind::near).pairs;
  }

  /// The pairs in contact that were found last, by rows.
  Span<const Pair> pairs() const { return rows_.pairs(); }
  ContactRows<Exec>& rows() { return rows_; }

  /// Whether the candidate list shows that all bodies are finite and inside the domain.
  bool shows_all_inside(Exec& exec, const BodiesView<V>& bodies) { return list_.shows_all_inside(exec, bodies, box()); }

  /// Pairs tested to find the contacts, without those tested for the candidate list.
  int64_t tests(Exec& exec) const;

  int64_t searches() const { return searches_; }  ///< by the broad phase since plan()
  Searches searches_so_far() const { return {searches_, source_ == Source::broad_phase}; }
  const BroadPhaseChoice& choice() const { return choice_; }
  const BroadPhaseParameters<V>& parameters() const { return parameters_; }
  const Box<V>& box() const { return parameters_.box; }

  /// The broad phase, prepared for these positions also where the candidate list made that unnecessary.
  AnyBroadPhase& prepared(Exec& exec, const BodiesView<V>& bodies);

  /// The broad phase as the last search has left it, and what each of its list-walking threads has tested.
  const AnyBroadPhase& broad_phase() const { return broad_phase_; }
  Span<const int> tested() const { return search_.tested(); }

  int64_t bytes() const;

 private:
  /// Where the candidates of the present positions are.
  enum class Source { none, list, broad_phase };

  template <class Method>
  void use() {
    if (auto* const same = std::get_if<Method>(&broad_phase_)) {
      same->plan(planned_);
    } else {
      broad_phase_.template emplace<Method>(planned_);
    }
  }

  /// Whether the candidate list holds all contacts of bodies_. Makes a new list where that is due.
  bool has_fresh_list(Exec& exec) {
    const ListState state = list_.state(exec, bodies_, box(), margin_);
    if (state == ListState::due) {
      const BodiesView<V> grown = list_.grown(exec, bodies_);
      prepare(exec, grown);
      test_broad_phase(exec, grown, list_.rows());
      list_.rows().sort(exec);
      list_.start(exec, bodies_, box(), margin_);
    }
    return state != ListState::off;
  }

  void prepare(Exec& exec, const BodiesView<V>& bodies);

  void test_candidates(Exec& exec) {
    if (is_tested_) return;
    is_tested_ = true;
    if (source_ == Source::list) {
      list_filter_.find(exec, list_.candidates(), bodies_, box(), rows_);
    } else {
      test_broad_phase(exec, bodies_, rows_);
    }
  }

  void test_broad_phase(Exec& exec, const BodiesView<V>& bodies, ContactRows<Exec>& rows);

  BroadPhaseChoice choice_;
  BroadPhaseParameters<V> parameters_, planned_;  // without and with skins
  AnyBroadPhase broad_phase_{BruteForce<V, Exec>(BroadPhaseParameters<V>{})};
  CandidateList<V, Exec> list_;
  Search<V, Exec> search_, list_filter_;  // in the candidates of the broad phase, and in the list
  ContactRows<Exec> rows_;                // pairs in contact
  ContactList<V, Exec> contacts_, near_;  // listed by body
  typename Exec::template Buffer<Real> grown_;

  Source source_ = Source::none;
  Real margin_ = 0;             // [m] of source_
  BodiesView<V> bodies_;        // at these positions, with the margin
  bool is_tested_ = false;      // rows_ hold their contacts
  int64_t linked_search_ = -1;  // the search whose pairs near_ lists
  int64_t searches_ = 0;
  bool is_counted_ = false;  // the next search is one that was counted
};

// What visits the broad phase is defined outside of the class. Within it, each file that uses a Collider would compile
// every search again, in order to inline it.

template <class V, class Exec>
void Collider<V, Exec>::plan(BroadPhaseChoice choice, BroadPhaseParameters<V> parameters, double skin) {
  choice_ = std::move(choice);
  planned_ = parameters_ = std::move(parameters);
  list_.plan(skin, 2 * rounding_guard(box()));
  for (SizeClass<V>& spheres : planned_.classes) spheres.largest *= list_.factor();
  switch (choice_.method) {
    case BroadPhase::brute_force:
      use<BruteForce<V, Exec>>();
      break;
    case BroadPhase::sort_and_sweep:
      use<SortAndSweep<V, Exec>>();
      break;
    case BroadPhase::linked_cell:
      use<LinkedCell<V, Exec>>();
      break;
    case BroadPhase::sorted_grid:
      use<SortedGrid<V, Exec>>();
      break;
    case BroadPhase::lecture_brute_force:
      use<lecture::BruteForceMethod<V, Exec>>();
      break;
    case BroadPhase::lecture_sort_and_sweep:
      use<lecture::SortAndSweepMethod<V, Exec>>();
      break;
    case BroadPhase::lecture_linked_cell:
      use<lecture::LinkedCellMethod<V, Exec>>();
      break;
    case BroadPhase::automatic:
      throw std::logic_error("a broad phase is chosen before");
  }
  source_ = Source::none;
  linked_search_ = -1;
  searches_ = 0;
}

template <class V, class Exec>
int64_t Collider<V, Exec>::tests(Exec& exec) const {
  if (source_ == Source::list) {
    const Span<const int> first = list_.candidates().first;
    return first.empty() ? 0 : exec.download(Span<const int>(first.end() - 1, 1))[0];
  }
  return std::visit(
      [&](auto& method) {
        if constexpr (lecture::FindsPairs<decltype(method)>) {
          return method.tests(exec);
        } else {
          return search_.template tests<decltype(method.candidates())>(exec);
        }
      },
      broad_phase_);
}

template <class V, class Exec>
auto Collider<V, Exec>::prepared(Exec& exec, const BodiesView<V>& bodies) -> AnyBroadPhase& {
  if (list_.is_used()) {
    if (source_ == Source::broad_phase) test_candidates(exec);  // before its structure changes
    std::visit([&](auto& method) { method.prepare(exec, list_.grown(exec, bodies)); }, broad_phase_);
  }
  return broad_phase_;
}

template <class V, class Exec>
int64_t Collider<V, Exec>::bytes() const {
  return std::visit([](auto& method) { return method.bytes(); }, broad_phase_) + search_.bytes() +
         list_filter_.bytes() + rows_.bytes() + list_.bytes();
}

template <class V, class Exec>
void Collider<V, Exec>::prepare(Exec& exec, const BodiesView<V>& bodies) {
  searches_ += !std::exchange(is_counted_, false);
  std::visit([&](auto& method) { method.prepare(exec, bodies); }, broad_phase_);
}

template <class V, class Exec>
void Collider<V, Exec>::test_broad_phase(Exec& exec, const BodiesView<V>& bodies, ContactRows<Exec>& rows) {
  std::visit(
      [&](auto& method) {
        if constexpr (lecture::FindsPairs<decltype(method)>) {
          put_into_rows(exec, method.find(exec, bodies), bodies.size(), rows);
        } else {
          search_.find(exec, method.candidates(), bodies, box(), rows);
        }
      },
      broad_phase_);
}

}  // namespace ballpit
