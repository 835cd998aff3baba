// SPDX-License-Identifier: MIT
// The contacts that the narrow phase passes to a response.
#pragma once

#include "bodies/pair.h"
#include "core/bounded.h"
#include "core/math.h"
#include "core/span.h"

namespace ballpit {

/// The geometry of a contact (i, j), as the narrow phase measures it.
template <class V>
struct ContactGeometry {
  V normal;              ///< unit vector from i to j
  Scalar<V> overlap;     ///< r_i + r_j − |x_j − x_i| ≥ 0 [m]
  Scalar<V> separation;  ///< speed at which the spheres part along the normal; negative while they approach [m/s]
};

/// An entry of the contact list of a contact's second body.
struct IncomingContact {
  int contact;
  int body;  ///< the first body of that contact; stored here to save one jump in memory
};

/// Contacts in canonical order (by i, then j), and the contact list of each body. Contacts with i = body are
/// [first[body], first[body + 1]); those with j = body are incoming[incoming_first[body]] …
/// incoming[incoming_first[body + 1] − 1], ascending.
template <class V>
struct ContactsView {
  Span<const Pair> pairs;
  Span<const ContactGeometry<V>> geometry;
  Span<const int> first;
  Span<const int> incoming_first;
  Span<const IncomingContact> incoming;

  /// How many contacts there are.
  Bounded count() const { return {pairs.size(), first.empty() ? nullptr : first.data() + first.size() - 1}; }

  HOST_DEVICE int count_of(int body) const {
    return first[body + 1] - first[body] + incoming_first[body + 1] - incoming_first[body];
  }

  /// Calls visit(contact, other body, side) in the order of contacts. Side is +1 if the normal points away from `body`,
  /// −1 if it points towards it.
  template <class Visit>
  HOST_DEVICE void for_each_of(int body, Visit&& visit) const {
    for (int k = incoming_first[body]; k < incoming_first[body + 1]; ++k) {
      visit(incoming[k].contact, incoming[k].body, -1);
    }
    for (int c = first[body]; c < first[body + 1]; ++c) visit(c, pairs[c].j, 1);
  }
};

}  // namespace ballpit
