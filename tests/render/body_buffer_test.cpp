// SPDX-License-Identifier: MIT
#include "render/body_buffer.h"

#include <catch2/catch.hpp>

#include "render/gl_context.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

TEST_CASE("the position buffer holds the floats of the simulation unchanged") {
  const GlContext context;
  for (const int dimensions : {2, 3}) {
    BodySnapshot bodies;
    bodies.count = 3;
    bodies.dimensions = dimensions;
    for (int i = 0; i < 3 * dimensions; ++i) bodies.position.push_back(static_cast<float>(i));
    bodies.radius = {0.5f};
    BodyBuffer buffer;
    buffer.upload(bodies);
    std::vector<float> stored(bodies.position.size());
    glGetNamedBufferSubData(buffer.position_buffer(), 0, static_cast<GLsizeiptr>(stored.size() * 4), stored.data());
    CHECK(stored == bodies.position);
  }
  check_gl("reading a buffer");
}

TEST_CASE("buffers stay the same until they must grow or change shape") {
  const GlContext context;
  BodyBuffer buffer;
  buffer.resize({100, 3, true, 1});
  const int generation = buffer.generation();
  buffer.resize({50, 3, true, 1});
  buffer.resize({100, 3, true, 1});
  CHECK(buffer.generation() == generation);
  buffer.resize({101, 3, true, 1});
  CHECK(buffer.generation() > generation);
  check_gl("resizing");
}

TEST_CASE("bodies in a contact are marked, others are not") {
  CHECK(contact_marks(4, {{0, 2}}) == std::vector<Mark>{Mark::contact, Mark::none, Mark::contact, Mark::none});
}

TEST_CASE("one radius for all draws the same picture as equal radii for each") {
  const DomainBox domain;
  const Inspection each = inspect({{{0.3f, 0.3f, 0.5f}, 0.2f}, {{0.7f, 0.6f, 0.4f}, 0.2f}}, domain);
  Inspection equal = each;
  equal.bodies.radius.resize(1);
  CHECK(draw(view_of(each, domain, 2), 160, 80).pixels == draw(view_of(equal, domain, 2), 160, 80).pixels);
}
