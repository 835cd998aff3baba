// SPDX-License-Identifier: MIT
#include "lab/experiments/accuracy.h"

#include "lab/experiments/accuracy_parts.h"

namespace ballpit {

const std::vector<Task>& tasks() {
  static const std::vector<Task> table = [] {
    std::vector<Task> all = contact_tasks();
    for (const auto& part : {rest_tasks(), gas_tasks()}) all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return table;
}

}  // namespace ballpit
