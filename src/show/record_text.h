// SPDX-License-Identifier: MIT
// The operations of a record in words, and the lines of the kernel that perform them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bodies/body_snapshot.h"
#include "lecture/recorded_run.h"

namespace ballpit {

/// A value as its array shows it: "b1" in the list of sort and sweep, else a number.
std::string value_text(const lecture::RecordedRun& run, int value);

/// What operation k does: "thread 2: atomicExch(&head[4], 2) returns 6".
std::string text_of(const lecture::RecordedRun& run, size_t k);

/// The lines of a function, without their common indentation.
struct CodeExcerpt {
  int first = 1;  ///< the number of the first one in its file
  std::vector<std::string> lines;
};

/// The function of a kernel that contains line `line` of its source, with the comment above it.
CodeExcerpt function_at(std::string_view source, int line);

}  // namespace ballpit
