// SPDX-License-Identifier: MIT
#include "app/interrupt.h"

#include <csignal>

namespace ballpit {

namespace {

volatile std::sig_atomic_t interrupted = 0;  // a signal handler can reach nothing else

void note_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
}

bool was_interrupted() { return interrupted != 0; }

}  // namespace ballpit
