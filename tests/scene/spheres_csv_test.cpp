// SPDX-License-Identifier: MIT
#include "scene/spheres_csv.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "core/random.h"

using namespace ballpit;
namespace fs = std::filesystem;

namespace {

template <class Read>
std::string message_of(const Read& read) {
  try {
    read();
  } catch (const UserError& error) {
    return error.what();
  }
  return "no error";
}

std::string message_for(std::string_view text) {
  return message_of([&] { read_spheres_csv({text, "a.csv"}); });
}

/// A file that is removed at the end.
struct TemporaryFile {
  fs::path path = fs::temp_directory_path() / ("ballpit-csv-" + std::to_string(::getpid()));
  explicit TemporaryFile(std::string_view text) { write_file(path, text); }
  ~TemporaryFile() { fs::remove(path); }
};

/// Rows of many lengths, three megabytes.
std::string long_text() {
  Random random(5);
  std::string text = "\xEF\xBB\xBFz,radius,x,y,vx\r\n";
  while (text.size() < 3'000'000) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.uniform(-30.0, 30.0)));
    for (int k = 0; k < 4; ++k) text += std::to_string(k == 1 ? 1 + scale : scale * random.uniform(-1.0, 1.0)) + ",";
    text += random.uniform() < 0.5 ? "1\n" : " -2.5e-7 \r\n";
  }
  return text;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return std::bit_cast<uint64_t>(x) == std::bit_cast<uint64_t>(y); });
}

std::vector<double> flat(const std::vector<Vec3d>& vectors) {
  std::vector<double> values;
  for (const Vec3d& v : vectors) values.insert(values.end(), {v.x, v.y, v.z});
  return values;
}

}  // namespace

TEST_CASE("columns are found by name, in any order") {
  const Bodies bodies = read_spheres_csv({"radius,vz, z ,y,x,mass\n0.5,4,3,2,1,7\n+.25,-4,-3e0,2,1,8\n", "a.csv"});
  REQUIRE(bodies.size() == 2);
  CHECK(bodies.position[0] == Vec3d(1, 2, 3));
  CHECK(bodies.velocity[0] == Vec3d(0, 0, 4));
  CHECK(bodies.radius == std::vector<double>{0.5, 0.25});
  CHECK(bodies.mass == std::vector<double>{7, 8});
}

TEST_CASE("mass and velocity may be left out") {
  const Bodies bodies = read_spheres_csv({"x,y,z,radius\n1,2,3,0.1", "a.csv"}, 500.0);
  CHECK(bodies.velocity[0] == Vec3d(0, 0, 0));
  CHECK(bodies.mass[0] == Approx(500.0 * 4.0 / 3.0 * 3.14159265358979 * 0.001));
}

TEST_CASE("Windows line ends, a byte order mark, blanks and a missing last line end are read") {
  const Bodies bodies = read_spheres_csv({"\xEF\xBB\xBFx,y,z,radius\r\n 1 ,2,\t3,4\r\n5,6,7,8", "a.csv"});
  REQUIRE(bodies.size() == 2);
  CHECK(bodies.position[1] == Vec3d(5, 6, 7));
  CHECK(bodies.radius[1] == 8.0);
}

TEST_CASE("a file with only a header has no spheres") {
  CHECK(read_spheres_csv({"x,y,z,radius", "a.csv"}).size() == 0);
  CHECK(read_spheres_csv({"x,y,z,radius\n", "a.csv"}).size() == 0);
}

namespace {

/// Two spheres: one at the origin, one 0.9 along x and −2 along z; radii 0.5.
struct Dialect {
  std::string text;
  std::string note{};  ///< behind the file's name
};

void check_dialects(const std::vector<Dialect>& table) {
  for (const Dialect& dialect : table) {
    CAPTURE(dialect.text);
    SphereLines source;
    Bodies bodies;
    CHECK_NOTHROW(bodies = read_spheres_csv({dialect.text, "a.csv"}, 1000.0, &source));
    REQUIRE(bodies.size() == 2);
    CHECK(bodies.position[0] == Vec3d(0, 0, 0));
    CHECK(bodies.position[1] == Vec3d(0.9, 0, -2));
    CHECK(bodies.radius == std::vector<double>{0.5, 0.5});
    CHECK(source.note == (dialect.note.empty() ? "" : "a.csv:" + dialect.note));
    REQUIRE(source.line.size() == 2);
    CHECK(read_resting_spheres({dialect.text, "a.csv"}).note == source.note);
  }
}

}  // namespace

TEST_CASE("files of R, numpy, pandas and spreadsheets are read") {
  const std::string ignored = " what these columns hold is ignored: ";
  check_dialects({
      // R: write.csv, with and without the names of rows; write.csv2; write.table
      {"\"x\",\"y\",\"z\",\"radius\"\n0,0,0,0.5\n0.9,0,-2,0.5\n"},
      {"\"\",\"x\",\"y\",\"z\",\"radius\"\n\"1\",0,0,0,0.5\n\"2\",0.9,0,-2,0.5\n",
       "1:" + ignored + "column 1 without a name"},
      {"\"\";\"x\";\"y\";\"z\";\"radius\"\n\"1\";0;0;0;0,5\n\"2\";0,9;0;-2;0,5\n",
       "1:" + ignored + "column 1 without a name"},
      {"\"x\" \"y\" \"z\" \"radius\"\n\"1\" 0 0 0 0.5\n\"2\" 0.9 0 -2 0.5\n",
       "1:" + ignored + "column 1 without a name"},
      // numpy: savetxt
      {"# x,y,z,radius\n0.000000000000000000e+00,0.000000000000000000e+00,0.000000000000000000e+00,5.0e-01\n"
       "9.000000000000000222e-01,0.000000000000000000e+00,-2.000000000000000000e+00,5.000000000000000000e-01\n"},
      {"# x y z radius\n0.0e+00 0.0e+00 0.0e+00 5.0e-01\n9.000000000000000222e-01 0 -2.0e+00 5.0e-01\n"},
      // pandas: to_csv
      {",x,y,z,radius\n0,0,0,0,0.5\n1,0.9,0,-2,0.5\n", "1:" + ignored + "column 1 without a name"},
      {"id,x,y,z,radius,name\n0,0,0,0,0.5,\"a, \"\"b\"\"\"\n1,0.9,0,-2,0.5,#7\n", "1:" + ignored + "\"id\", \"name\""},
      // spreadsheets
      {"\xEF\xBB\xBFx;y;z;radius\r\n0;0;0;0,5\r\n0,9;0;-2;0,5\r\n;;;\r\n"},
      {"sep=;\nx;y;z;radius\n0;0;0;0.5\n0.9;0;-2;0.5\n"},
      {"x\ty\tz\tradius\n0\t0\t0\t0.5\n0.9\t0\t-2\t0.5\n"},
      {"x\ty\tz\tradius\t\n0\t0\t0\t0,5\t\n0,9\t0\t-2\t0,5\t\n"},
      {"\"x\",\"y\",\"z\",\"radius\"\n0,0,0,\"0,5\"\n\"0,9\",0,-2,\"0,5\"\n"},
      {"x,y,z,radius\r0,0,0,0.5\r0.9,0,-2,0.5\r"},
  });
}

TEST_CASE("files written by hand are read: blank lines, comments, blanks, trailing separators, names in any case") {
  check_dialects({
      {"\n\nx,y,z,radius\n\n0,0,0,0.5\n  \n0.9,0,-2,0.5\n\n\n"},
      {"# two spheres\n#\nx,y,z,radius\n# the first\n0,0,0,0.5 # at the origin, of course\n0.9,0,-2,0.5"},
      {"# x, y, z, radius\nx,y,z,radius\n0,0,0,0.5\n0.9,0,-2,0.5\n"},
      {" X, Y, Z, Radius \n 0 , 0 ,0, 0.5 \n\t.9, 0,-2 ,+0.5\t\n"},
      {"x,y,z,radius,\n0,0,0,0.5,\n0.9,0,-2,0.5,\n"},
      {"x,y,z,radius\n0,0,0,0.5,\n0.9,0,-2,0.5\n"},
      {"x  y   z  radius\n  0 0 0 0.5\n0.9   0\t-2 0.5  \n"},
      {"x,y,z,r\n0,0,0,0.5\n0.9,0,-2,0.5\n"},
      {"D,x,y,z\n1,0,0,0\n1,0.9,0,-2\n"},
      {"x,y,z,Diameter\n1e-400,-1e-400,0,1\n0.9,0,-2,1\n"},
  });
}

TEST_CASE("errors name lines of the file, blank ones and comments counted") {
  SphereLines source;
  read_spheres_csv({"# a\n\nx,y,z,r\n# b\n1,2,3,4\n\n5,6,7,8\n", "a.csv"}, 1000.0, &source);
  CHECK(source.line == std::vector<int>{5, 7});
}

TEST_CASE("a wrong CSV file is refused with file, line, column, what was found and what is allowed") {
  const std::string columns = ", allowed columns x, y, z, radius and optionally vx, vy, vz, mass";
  const std::string any = "a number, -1e+15 to 1e+15";
  const std::string length = "a number, 1e-12 to 1e+15";
  const std::string header = "x,y,z,radius\n";
  using namespace std::string_literals;
  const std::vector<std::pair<std::string, std::string>> table = {
      {"", "1: header: found an empty file" + columns},
      {"\xEF\xBB\xBF", "1: header: found an empty file" + columns},
      {"\n", "1: header: found an empty file" + columns},
      {"# by me\n", "1: header: found comments alone" + columns},
      {"x,y,z\n1,2,3", "1: header: found no column \"radius\"" + columns},
      {"x,y,radius\n1,2,3", "1: header: found no column \"z\"" + columns},
      {"x;y;z\n1;2;3", "1: header: found no column \"radius\"" + columns},
      {"x,y,z,rad\n1,2,3,4", "1: header: found no column \"radius\"" + columns},
      {"x,y,z,radius,d\n1,2,3,4,8", "1: header: found \"radius\" and \"d\", allowed one of radius, r, diameter, d"},
      {"x,y,z,r,Radius\n1,2,3,4,4", "1: header: found \"r\" and \"Radius\", allowed one of radius, r, diameter, d"},
      {"X,y,z,r,x\n", "1: header: found \"x\" twice" + columns},
      {"x,y,z,radius,x\n", "1: header: found \"x\" twice" + columns},
      {"1,2,3,4\n", "1: header: found \"1,2,3,4\", no column \"x\"" + columns},
      {"\xFF\xFEx\0,\0"s, "1: header: found text in UTF-16, allowed text in UTF-8"},
      {header + "1,2,3\n", "2: row: found 3 fields, allowed 4, as in the header"},
      {header + "1,2,3,4,5\n",
       "2: row: found 5 fields, allowed 4, as in the header, separated by commas: numbers with decimal commas need "
       "semicolons or tabs between them"},
      {header + "0,5,0,0,1\n",
       "2: row: found 5 fields, allowed 4, as in the header, separated by commas: numbers with decimal commas need "
       "semicolons or tabs between them"},
      {header + "1;2;3;4\n", "2: row: found 1 field, allowed 4, as in the header, separated by commas"},
      {header + "1;2;3;4,5\n", "2: row: found 2 fields, allowed 4, as in the header, separated by commas"},
      {"x;y;z;radius\n1,2,3,4\n", "2: row: found 1 field, allowed 4, as in the header, separated by semicolons"},
      {header + "\n1,2\n", "3: row: found 2 fields, allowed 4, as in the header"},
      {header + "1,\"2,3,4\n", "2: y: found a quote that is not closed, allowed quotes around whole fields"},
      {header + "1,\"2\"5,3,4\n", "2: y: found text behind a closing quote, allowed quotes around whole fields"},
      {header + "1,2,3,\"1,234\"\n",
       "2: radius: found \"1,234\", allowed a number without separators between thousands"},
      {"x;y;z;radius\n1.234,5;2;3;4\n", "2: x: found \"1.234,5\", allowed " + any},
      {"x;y;z;radius\n1.5;2;3;4\n1,234;2;3;4\n",
       "3: x: found \"1,234\", allowed a number with a decimal point, as above"},
      {"x;y;z;radius\n1,5;2;3;4\n1.234;2;3;4\n",
       "3: x: found \"1.234\", allowed a number with a decimal comma, as above"},
      {header + "1,2,3,1e-400\n", "2: radius: found \"1e-400\", allowed " + length},
      {"x,y,z,diameter\n1,2,3,0\n", "2: diameter: found \"0\", allowed a number, 2e-12 to 2e+15"},
      {header + "1,2,3,4\n1,two,3,4\n", "3: y: found \"two\", allowed " + any},
      {header + "1,2,,4\n", "2: z: found \"\", allowed " + any},
      {header + "1,2,0x3,4\n", "2: z: found \"0x3\", allowed " + any},
      {header + "1,2,3m,4\n", "2: z: found \"3m\", allowed " + any},
      {header + "1,2,+-3,4\n", "2: z: found \"+-3\", allowed " + any},
      {header + "nan,2,3,4\n", "2: x: found \"nan\", allowed " + any},
      {header + "1,-inf,3,4\n", "2: y: found \"-inf\", allowed " + any},
      {header + "1,1e999,3,4\n", "2: y: found \"1e999\", allowed " + any},
      {header + "1,2,3,-1\n", "2: radius: found \"-1\", allowed " + length},
      {header + "1,2,3,0\n", "2: radius: found \"0\", allowed " + length},
      {header + "1,2,3,1e12\n",
       "2: radius: found 1e+12, which makes a mass of 4.188790204786391e+39 kg, allowed 1e-30 to 1e+30 kg"},
      {"x,y,z,radius,mass\n1,2,3,1,0\n", "2: mass: found \"0\", allowed a number, 1e-30 to 1e+30"},
      {"x,y,z,radius,vx\n1,2,3,1,inf\n", "2: vx: found \"inf\", allowed " + any},
      {header + "\x01\xFF\0,2,3,4\n"s, "2: x: found \"\\x01\\xFF\\x00\", allowed " + any},
      {"\x7F"
       "ELF\x02\x01"s,
       "1: header: found \"\\x7FELF\\x02\\x01\", no column \"x\"" + columns},
  };
  for (const auto& [text, message] : table) {
    CAPTURE(text);
    CHECK(message_for(text) == "a.csv:" + message);
  }
  CHECK(message_for(std::string(10'000, 'x')).size() < 300);
}

TEST_CASE("spheres at rest are refused for the same reasons, but not for their mass") {
  const auto message_at_rest = [](std::string_view text) {
    return message_of([&] { read_resting_spheres({text, "a.csv"}); });
  };
  const std::string header = "x,y,z,radius,vx\n";
  for (const std::string& text : {std::string(), std::string("x,y,z\n"), header + "1,2,3\n", header + "1,2,3,0,5\n",
                                  header + "1,2,3,4,five\n", header + "nan,2,3,4,5\n"}) {
    CAPTURE(text);
    CHECK(message_at_rest(text) == message_for(text));
    CHECK(message_at_rest(text) != "no error");
  }
  CHECK(message_at_rest(header + "1,2,3,1e15,0\n") == "no error");
}

TEST_CASE("spheres at rest equal the bodies, rounded to single precision") {
  const std::string text = long_text();
  const Bodies bodies = read_spheres_csv({text, "a.csv"}, 1e-6);
  const RestingSpheres spheres = read_resting_spheres({text, "a.csv"});
  REQUIRE(spheres.size() == bodies.size());
  REQUIRE(spheres.radius.size() == bodies.radius.size());
  int64_t different = 0;
  for (int64_t i = 0; i < bodies.size(); ++i) {
    different += spheres.position[i] != narrow<Vec3>(bodies.position[i]);
    different += spheres.radius[i] != static_cast<float>(bodies.radius[i]);
  }
  CHECK(different == 0);
}

TEST_CASE("a file longer than the buffer is read like its text") {
  const std::string text = long_text();
  for (const std::string& variant : {text, text.substr(0, text.size() - 1)}) {
    const TemporaryFile file(variant);
    const Bodies expected = read_spheres_csv({text, "a.csv"}, 1e-6), read = read_spheres_csv(file.path, 1e-6);
    CHECK(read.size() > 50'000);
    CHECK(same_bits(flat(expected.position), flat(read.position)));
    CHECK(same_bits(flat(expected.velocity), flat(read.velocity)));
    CHECK(same_bits(expected.radius, read.radius));
  }
}

TEST_CASE("an error far into a file names the line") {
  std::string text = long_text();
  const auto lines = std::count(text.begin(), text.end(), '\n');
  const TemporaryFile file(text + "1,2,3,oops,5\n");
  const auto read = [&] { read_resting_spheres(file.path); };
  CHECK(message_of(read) == file.path.string() + ":" + std::to_string(lines + 1) +
                                ": y: found \"oops\", allowed a number, -1e+15 to 1e+15");
}

TEST_CASE("a line larger than the buffer is refused with its number") {
  const TemporaryFile file("x,y,z,radius\n1,2,3,4\n" + std::string(2'000'000, '1'));
  const auto read = [&] { read_resting_spheres(file.path); };
  CHECK(message_of(read) ==
        file.path.string() + ":3: line: found more than 1048576 bytes, allowed lines of at most so many");
}

TEST_CASE("a folder is refused as a CSV file") {
  const auto read = [] { read_resting_spheres(fs::temp_directory_path()); };
  CHECK(message_of(read) == fs::temp_directory_path().string() + ": found a folder, allowed a file");
}

TEST_CASE("a round trip through a file keeps every bit") {
  Random random(3);
  Bodies bodies;
  for (int i = 0; i < 1000; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.uniform(-30.0, 30.0)));
    bodies.position.push_back(random.uniform(Vec3d(-scale), Vec3d(scale)));
    bodies.velocity.push_back(random.uniform(Vec3d(-scale), Vec3d(scale)));
    bodies.radius.push_back(random.uniform(0.1, 1.0) * scale);
    bodies.mass.push_back(random.uniform(0.1, 1.0) / scale);
  }
  bodies.position[0] = {-0.0, 5e-324, 1e15};
  bodies.radius[0] = 0.1;
  const fs::path path = fs::temp_directory_path() / "ballpit-round-trip.csv";
  write_spheres_csv(path, bodies);
  const Bodies read = read_spheres_csv(path);
  CHECK(same_bits(flat(bodies.position), flat(read.position)));
  CHECK(same_bits(flat(bodies.velocity), flat(read.velocity)));
  CHECK(same_bits(bodies.radius, read.radius));
  CHECK(same_bits(bodies.mass, read.mass));
  fs::remove(path);
}

TEST_CASE("numbers are written as short as possible") {
  Bodies bodies;
  bodies.resize(1);
  bodies.position[0] = {0.1, 1.0 / 3.0, -2.0};
  bodies.radius[0] = 0.5;
  bodies.mass[0] = 1e-9;
  const fs::path path = fs::temp_directory_path() / "ballpit-short.csv";
  write_spheres_csv(path, bodies);
  CHECK(read_file(path) == "x,y,z,radius,vx,vy,vz,mass\n0.1,0.3333333333333333,-2,0.5,0,0,0,1e-09\n");
  fs::remove(path);
}

TEST_CASE("a missing CSV file is a UserError") {
  CHECK_THROWS_AS(read_spheres_csv(LineReader("/nonexistent/a.csv")), UserError);
  CHECK_THROWS_AS(read_resting_spheres(LineReader("/nonexistent/a.csv")), UserError);
}
