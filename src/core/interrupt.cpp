// SPDX-License-Identifier: MIT
#include "core/interrupt.h"

#include <csignal>

namespace ballpit {

namespace {

volatile std::sig_atomic_t interrupted = 0;  // a signal handler has no other access

void note_interrupt(int) { interrupted = 1; }

void catch_signal(int signal, int flags) {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  action.sa_flags = flags;
  ::sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void catch_interrupts() {
  const int once = static_cast<int>(SA_RESETHAND);
  catch_signal(SIGINT, once);
  catch_signal(SIGTERM, once);
  if (!is_ignored(SIGHUP)) catch_signal(SIGHUP, 0);
}

bool was_interrupted() { return interrupted != 0; }

void stop_if_interrupted() {
  if (was_interrupted()) throw Interrupted();
}

}  // namespace ballpit
