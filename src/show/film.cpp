// SPDX-License-Identifier: MIT
#include "show/film.h"

namespace ballpit {

bool Film::advance(const std::function<bool()>& stop) {
  Session& session = demo_.session;
  const double time = plan_.from + next() * plan_.interval;
  while (plan_.keeps_timeline && session.steps_until(time) > 0 && !stop()) demo_.timeline->step();
  session.advance_to(time, stop);
  return session.steps_until(time) == 0;
}

bool Film::is_overtaken() const { return demo_.session.steps_until(plan_.from + next() * plan_.interval) < 0; }

}  // namespace ballpit
