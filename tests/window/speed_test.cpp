// SPDX-License-Identifier: MIT
// How long a lecture takes to answer to a key: in time of processors, which other programs do not lengthen.
#include <algorithm>
#include <ctime>
#include <vector>

#include <catch2/catch.hpp>

#include "render/gl_context.h"
#include "render/renderer.h"
#include "show/presenter.h"

using namespace ballpit;

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE(
    "a page of up to 500 spheres is drawn within 200 ms, and a step of its cursor costs no more than its picture") {
  constexpr int kWidth = 1280, kHeight = 720;
  constexpr float kAspect = float(kWidth) / float(kHeight);
  const GlContext context;
  Renderer renderer(kWidth, kHeight, {.theme = themes().front(), .text_scale = Presenter::kTextScale});
  Presenter presenter(built_in_lecture());
  const auto spent = [&](const auto& act) {  // [s] by two processors at most
    const std::clock_t start = std::clock();
    act();
    renderer.draw(presenter.frame_view(kAspect));
    renderer.read_pixels();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
  };
  for (int number = 1; number <= presenter.count(); ++number) {
    double opening = spent([&] { presenter.go_to(number); });
    if (presenter.demo().report().count > 500) continue;
    CAPTURE(presenter.page().id);
    // All twice, and the lesser times: other tests run beside this one, and take turns at the caches.
    std::vector<double> steps(10, 1e9);
    size_t count = 0;
    for (int turn = 0; turn < 2; ++turn) {
      if (turn > 0) {
        presenter.go_to(number % presenter.count() + 1);
        opening = std::min(opening, spent([&] { presenter.go_to(number); }));
      }
      count = 0;
      while (count < steps.size() && presenter.run()) {
        steps[count] = std::min(steps[count], spent([&] { presenter.step(1); }));
        ++count;
      }
    }
    const double longest = count > 0 ? *std::max_element(steps.begin(), steps.begin() + std::ptrdiff_t(count)) : 0;
    const double picture = std::min(spent([] {}), spent([] {}));
    CHECK(opening < 0.2);
    CHECK(longest < 1.5 * picture + 0.005);  // 5 ms: small pictures vary more
  }
}
#endif
