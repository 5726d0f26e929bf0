// The program of lecture 11 that reads recordings, on the reference implementation, with files as phones write them and
// as they should not be.
#include <doctest/doctest.h>
#include "checker/base/text.hpp"
#include "tests/support/files.hpp"

#include <rigid/measured.hpp>

#include <fmt/format.h>
#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace workbook::testing;
using Row = std::vector<std::string>;

/// The recording of the lecture as cells.
std::vector<Row> recorded() {
  std::vector<Row> rows;
  for (const std::string& line : workbook::lines_of(read(WORKBOOK_TEST_RECORDING)))
    boost::split(rows.emplace_back(), line, [](char c) { return c == ','; });
  return rows;
}

std::string text_of(const std::vector<Row>& rows, const std::string& separator = ",", const std::string& end = "\n") {
  std::string text;
  for (const Row& row : rows) text += fmt::format("{}{}", fmt::join(row, separator), end);
  return text;
}

Outcome run_on_file(const std::string& name) {
  const fs::path folder = WORKBOOK_TEST_SCRATCH;
  return run_command(fmt::format("RECORDING='{}' '{}'", (folder / name).string(), WORKBOOK_TEST_PHONE), folder);
}

Outcome run_on(const std::string& text) {
  fs::create_directories(WORKBOOK_TEST_SCRATCH);
  write(fs::path(WORKBOOK_TEST_SCRATCH) / "recording.csv", text);
  return run_on_file("recording.csv");
}

Outcome run_on_zip(const ZipEntries& entries) {
  fs::create_directories(WORKBOOK_TEST_SCRATCH);
  write_zip(fs::path(WORKBOOK_TEST_SCRATCH) / "recording.zip", entries);
  return run_on_file("recording.zip");
}

/// The twelve throws, times and ω.
std::vector<std::pair<rigid::VectorXd, rigid::Matrix3Xd>> throws_of_the_lecture() {
  std::istringstream lines(read(WORKBOOK_TEST_THROWS));
  std::string line;
  std::getline(lines, line);
  std::vector<std::vector<Eigen::Vector4d>> samples(12);
  while (std::getline(lines, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream numbers(line);
    std::size_t number = 0;
    Eigen::Vector4d sample;
    numbers >> number >> sample[0] >> sample[1] >> sample[2] >> sample[3];
    samples.at(number - 1).push_back(sample);
  }
  std::vector<std::pair<rigid::VectorXd, rigid::Matrix3Xd>> all;
  for (const std::vector<Eigen::Vector4d>& each : samples) {
    const Eigen::Map<const Eigen::MatrixXd> rows(each.front().data(), 4, std::ssize(each));
    all.emplace_back(rows.row(0).transpose(), rows.bottomRows(3));
  }
  return all;
}

/// What lies between two headings, or after the last.
std::vector<Row> rows_of(const std::string& out, const std::string& heading) {
  std::vector<Row> rows;
  std::istringstream lines(out.substr(out.find("\n" + heading + "\n") + heading.size() + 2));
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line) && !line.empty();) {
    std::istringstream words(line);
    rows.emplace_back();
    for (std::string word; words >> word;) rows.back().push_back(word);
  }
  return rows;
}

/// Of a coefficient: a dash, or this value.
bool is_untold_or(const std::string& cell, double value, double tolerance) {
  return cell == "-" || std::abs(std::stod(cell) - value) < tolerance;
}

/// A made-up recording of a body that is thrown, caught, laid on a table, dropped, and thrown again.
struct MadeUp {
  explicit MadeUp(unsigned seed) : generator(seed) {}

  std::mt19937 generator;
  std::vector<Row> rows{{"Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"}};
  std::vector<rigid::Vector2d> flights;
  rigid::Vector3d now = rigid::Vector3d::Zero();
  double time = 0;
  double range = 60;   // rad/s of the sensor
  double step = 0.01;  // s between samples
  double jitter = 0;   // of a step

  double uniform(double from, double to) { return std::uniform_real_distribution(from, to)(generator); }

  void sample(const rigid::Vector3d& omega) {
    std::normal_distribution<double> noise(0, 0.01);
    rows.push_back({fmt::format("{}", time)});
    for (const double component : omega)
      rows.back().push_back(fmt::format("{}", std::clamp(component + noise(generator), -range, range)));
    now = omega;
    time += step * (1 + jitter * uniform(-1, 1));
  }
  /// From what was last to another ω: the torques of a hand, which shakes.
  void hand(const rigid::Vector3d& end, double seconds) {
    const rigid::Vector3d begin = now, shake(uniform(2, 5), uniform(2, 5), uniform(2, 5));
    const double rate = uniform(18, 30);
    for (double t = 0; t < seconds; t += step) {
      const double part = t / seconds;
      sample((1 - part) * begin + part * end + std::sin(rate * t) * shake);
    }
    now = end;
  }
  void table(double seconds) {
    for (double t = 0; t < seconds; t += step) sample(rigid::Vector3d::Zero());
  }
  void flight(const rigid::Vector3d& I, double seconds) {
    const rigid::Vector3d start = now;
    const double begin = time;
    while (time - begin < seconds) sample(rigid::damped_rotation(I, start, 0.2, time - begin));
    if (seconds >= 0.5) flights.emplace_back(begin, time - step);
  }
  /// What a gyroscope has recorded in the air, on axes of another phone, with samples in between where these are more.
  void replay(const rigid::VectorXd& t, const rigid::Matrix3Xd& omega) {
    const double begin = time, seconds = t[t.size() - 1] - t[0];
    for (Eigen::Index k = 0; time - begin < seconds; sample(between(t, omega, k, t[0] + time - begin)))
      while (t[k + 1] - t[0] < time - begin) ++k;
    flights.emplace_back(begin, time - step);
  }
  /// The cubic polynomial through the samples around t[k] and t[k + 1].
  static rigid::Vector3d between(const rigid::VectorXd& t, const rigid::Matrix3Xd& omega, Eigen::Index k, double at) {
    const Eigen::Index first = std::clamp<Eigen::Index>(k - 1, 0, t.size() - 4);
    rigid::Vector3d sum = rigid::Vector3d::Zero();
    for (Eigen::Index i = first; i < first + 4; ++i) {
      double weight = 1;
      for (Eigen::Index j = first; j < first + 4; ++j)
        if (j != i) weight *= (at - t[j]) / (t[i] - t[j]);
      sum += weight * omega.col(i);
    }
    return sum;
  }
  /// Short flights between hits.
  void bounces(const rigid::Vector3d& I) {
    for (int k = 0; k < 4; ++k) {
      now = rigid::Vector3d(uniform(-9, 9), uniform(-9, 9), uniform(-9, 9));
      flight(I, uniform(0.05, 0.12));
    }
  }
};

}  // namespace

TEST_CASE("two throws are found in the recording, and the hand is left out") {
  const Outcome whole = run_on(text_of(recorded()));
  CHECK(whole.status == 0);
  CHECK(rows_of(whole.out, "Flights") ==
        std::vector<Row>{{"0.86", "1.65", "-0.9921", "0.9534", "0.8602", "0.0788", "1.0709"},
                         {"6.71", "7.55", "-0.9924", "0.9753", "0.8591", "0.0793", "1.0717"}});
  for (const Row& row : rows_of(whole.out, "Left out"))
    CHECK(fmt::format("{}", fmt::join(row, " "))
              .ends_with("no flight of a quarter of a second: a hand, a table, a bounce"));
  CHECK(rows_of(whole.out, "Results")[0] == Row{"a", "-0.9922", "±", "0.0001"});
  // Between the zeros of ω_x, which lie at 0.98, 1.30 and 1.64 s.
  const std::vector<Row> periods = rows_of(whole.out, "Half of the period, measured and exact");
  REQUIRE(periods.size() == 5);
  CHECK(periods[0][1] == "0.320");
  for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(std::stod(periods[k][3]) - 0.98) < 0.01);
}

TEST_CASE("the page shows every sample of every flight, on its curve and on its lines") {
  const Outcome whole = run_on(text_of(recorded()));
  const std::string marker = "Pictures: ",
                    page = read(whole.out.substr(whole.out.find(marker) + marker.size(),
                                                 whole.out.rfind('\n') - whole.out.find(marker) - marker.size()));
  const auto count = [&](const char* what) { return workbook::search_all(page, what).size(); };
  CHECK(count("<svg") == 8);
  CHECK(count("<circle class='[xyz]'") == 3 * (80 + 85));
  CHECK(count("<circle class='samples'") == 3 * (80 + 85));
  CHECK(count("<polyline class='[xyz]'") == 6);
  CHECK(count("<polyline class='line'") == 6);
  // The samples lie on the curve of damped_rotation: the points of one in a polyline, of the other in circles, in
  // pixels.
  std::string points = workbook::search(page, "<polyline class='x' points='([^']*)'")[1];
  std::ranges::replace(points, ',', ' ');
  std::istringstream numbers(points);
  const auto samples = workbook::search_all(page, "<circle class='x' cx='([^']*)' cy='([^']*)'");
  std::size_t seen = 0;
  for (double x = 0, y = 0; numbers >> x >> y; ++seen) {
    CHECK(std::abs(std::stod(samples.at(seen)[1]) - x) < 0.01);
    CHECK(std::abs(std::stod(samples.at(seen)[2]) - y) < 5);
  }
  CHECK(seen == 80);
  CHECK(has(page, "left over 0.15 rad/s"));
}

TEST_CASE("one throw has error bars from its noise") {
  std::vector<Row> rows = recorded();
  rows.resize(300);
  const std::string out = run_on(text_of(rows)).out;
  CHECK(rows_of(out, "Flights").size() == 1);
  CHECK(has(out, "One throw: these are the errors that the noise of its samples makes."));
  const Row a = rows_of(out, "Results")[0];
  CHECK(std::abs(std::stod(a[1]) + 0.992) < 0.003);
  CHECK(std::stod(a[3]) > 0);
}

TEST_CASE("a zip file as phyphox shares it is read like its table") {
  const std::string table = text_of(recorded()), plain = run_on(table).out;
  const std::pair<std::string, std::optional<std::string>> device{"meta/device.csv",
                                                                  "\"property\",\"value\"\nversion,1\n"};
  CHECK(run_on_zip({{"Raw Data.csv", table}, device}).out == plain);
  const auto refused = [](const ZipEntries& entries, const std::string& why) {
    const Outcome outcome = run_on_zip(entries);
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    CHECK(has(outcome.err, why));
  };
  refused({device}, "holds no table of a gyroscope.");
  refused({{"Accelerometer.csv", "\"Time (s)\",\"Acceleration x (m/s^2)\"\n0,1\n"}},
          "Accelerometer.csv: has no column like \"Gyroscope x (rad/s)\"");
  refused({{"one.csv", table}, {"two.csv", table}}, "holds two recordings, one.csv and two.csv");
  const std::string file = read(fs::path(WORKBOOK_TEST_SCRATCH) / "recording.zip");
  CHECK(has(run_on("PK\3\4" + file.substr(40, 200)).err, "is a damaged zip file"));
  CHECK(has(run_on(file.substr(0, file.size() / 3)).err, "zip file"));
  CHECK(has(run_on(std::string("\xD0\xCF\x11\xE0\0\0", 6)).err, "is no text; export"));
}

TEST_CASE("of made-up recordings every flight is found and none is invented") {
  int wanted = 0, used = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    MadeUp made(seed);
    const double I_y = made.uniform(0.3, 0.7);
    const rigid::Vector3d I(1, I_y, 1 + I_y * made.uniform(0.6, 1));  // a book, a board
    made.table(0.5);
    for (int number = 0; number < 4; ++number) {
      made.hand({made.uniform(9, 14), made.uniform(2, 5), made.uniform(-5, -2)}, 0.3);
      made.flight(I, made.uniform(0.5, 0.9));
      made.bounces(I);
      made.hand({0, 0, 0}, made.uniform(0.2, 0.5));
      made.table(0.5);
      if (number == 1) made.time += 0.4;  // samples are missing
    }
    const std::string out = run_on(text_of(made.rows)).out;
    const std::vector<Row> found = rows_of(out, "Flights");
    wanted += static_cast<int>(made.flights.size());
    for (const Row& row : found) {  // each is one of those that were made
      CHECK(std::ranges::any_of(made.flights, [&](const rigid::Vector2d& flight) {
        return std::stod(row[0]) > flight[0] - 0.04 && std::stod(row[1]) < flight[1] + 0.04;
      }));
      CHECK(is_untold_or(row[2], I[1] - I[2], 0.15));
    }
    // Too steady ones are found too, and left out with this reason.
    const std::vector<Row> left_out = rows_of(out, "Left out");
    const auto holds = [](const std::vector<Row>& rows, const rigid::Vector2d& flight, const std::string& reason) {
      return std::ranges::any_of(rows, [&](const Row& row) {
        return std::stod(row[0]) < flight[0] + 0.1 && std::stod(row[1]) > flight[1] - 0.1 &&
               has(fmt::format("{}", fmt::join(row, " ")), reason);
      });
    };
    for (const rigid::Vector2d& flight : made.flights) {
      used += holds(found, flight, "");
      CHECK((holds(found, flight, "") || holds(left_out, flight, "turn it so that it tumbles")));
    }
  }
  CHECK(wanted == 48);
  CHECK(used >= 43);
}

TEST_CASE("each of the twelve throws of the lecture is found, and as long as it is") {
  for (const auto& [t, omega] : throws_of_the_lecture()) {
    std::vector<Row> rows = MadeUp(1).rows;
    for (Eigen::Index k = 0; k < t.size(); ++k)
      rows.push_back({fmt::format("{}", t[k]), fmt::format("{}", omega(0, k)), fmt::format("{}", omega(1, k)),
                      fmt::format("{}", omega(2, k))});
    const std::vector<Row> found = rows_of(run_on(text_of(rows)).out, "Flights");
    REQUIRE(found.size() == 1);
    CHECK(std::stod(found[0][1]) - std::stod(found[0][0]) > 0.95 * (t[t.size() - 1] - t[0]));
  }
}

TEST_CASE("the throws of the lecture are found between hands, tables and bounces, at every rate and on all axes") {
  const auto throws = throws_of_the_lecture();
  int wanted = 0, found_of_them = 0, invented = 0;
  for (const double rate : {50.0, 100.0, 200.0, 400.0}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      MadeUp made(100 * seed + static_cast<unsigned>(rate));
      made.step = 1 / rate;
      made.jitter = seed == 2 ? 0.2 : 0;
      // The phone lies on another side: its axes are those of the racket in another order, right-handed.
      rigid::Matrix3d axes = rigid::Matrix3d::Identity();
      if (seed > 1) axes = (rigid::Matrix3d() << 0, 0, -1, 1, 0, 0, 0, -1, 0).finished();
      const rigid::Vector3d I(1, 0.0802, 1.0747), on_phone = (axes * I).cwiseAbs();
      made.table(0.5);
      rigid::Vector3d mean = rigid::Vector3d::Zero();
      for (std::size_t k = seed - 1; k < throws.size() - 1; k += 3) {  // the last one begins in the hand
        const rigid::Matrix3Xd omega = axes * throws[k].second;
        made.hand(omega.col(0), made.uniform(0.25, 0.5));
        made.replay(throws[k].first, omega);
        mean += rigid::euler_coefficients(throws[k].first, omega) / (seed < 3 ? 4 : 3);
        made.bounces(on_phone);
        made.hand({0, 0, 0}, made.uniform(0.2, 0.5));
        made.table(0.4);
      }
      const std::string out = run_on(text_of(made.rows)).out;
      CAPTURE(rate);
      CAPTURE(seed);
      CAPTURE(out);
      const std::vector<Row> found = rows_of(out, "Flights");
      rigid::Vector3d sum = rigid::Vector3d::Zero(), told = rigid::Vector3d::Zero();
      for (const Row& row : found) {
        const bool is_one = std::ranges::any_of(made.flights, [&](const rigid::Vector2d& flight) {
          return std::stod(row[0]) > flight[0] - 0.06 && std::stod(row[1]) < flight[1] + 0.06;
        });
        invented += !is_one;
        for (std::size_t i = 0; i < 3; ++i) {
          if (row[2 + i] == "-") continue;
          sum[static_cast<int>(i)] += std::stod(row[2 + i]);
          told[static_cast<int>(i)] += 1;
        }
      }
      for (const rigid::Vector2d& flight : made.flights)
        found_of_them += std::ranges::any_of(found, [&](const Row& row) {
          return std::stod(row[0]) < flight[0] + 0.1 && std::stod(row[1]) > flight[1] - 0.1;
        });
      wanted += static_cast<int>(made.flights.size());
      // Each coefficient in the mean within 3 % of what the throws themselves give.
      for (int i = 0; i < 3; ++i) CHECK(std::abs(sum[i] / told[i] / mean[i] - 1) < 0.03);
    }
  }
  CHECK(wanted == 44);
  CHECK(found_of_them >= 40);
  CHECK(invented == 0);
}

TEST_CASE("throws about every axis are found, also long ones, and a coefficient that one does not tell is left out") {
  const rigid::Vector3d I(1, 0.0802, 1.0747);
  for (unsigned seed = 1; seed <= 4; ++seed) {
    MadeUp made(seed);
    for (const rigid::Vector3d& start :
         {rigid::Vector3d(13, 2, -1), rigid::Vector3d(2, 14, 1.5), rigid::Vector3d(1.5, 3, 12)}) {
      made.table(0.5);
      made.hand(start, 0.4);
      made.flight(I, made.uniform(0.6, 1.6));
      made.bounces(I);
      made.hand({0, 0, 0}, 0.3);
    }
    made.table(0.3);
    const std::string out = run_on(text_of(made.rows)).out;
    CAPTURE(out);
    const std::vector<Row> found = rows_of(out, "Flights");
    REQUIRE(found.size() == 3);
    const double right[] = {I[1] - I[2], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]};
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(std::abs(std::stod(found[k][0]) - made.flights[k][0]) < 0.06);
      CHECK(std::abs(std::stod(found[k][1]) - made.flights[k][1]) < 0.06);
      for (std::size_t i = 0; i < 3; ++i) CHECK(is_untold_or(found[k][2 + i], right[i], 0.05));
    }
    CHECK(found[1][3] == "-");  // about the handle ω_y hardly changes
    CHECK(found[1][2] != "-");
  }
}

TEST_CASE("flights at the sensor's limit or with missing samples are never used whole") {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    for (const bool is_limited : {true, false}) {
      MadeUp made(seed);
      if (is_limited) made.range = 8;
      made.table(0.5);
      made.hand({made.uniform(12, 15), made.uniform(1, 4), made.uniform(-4, -1)}, 0.3);
      made.flight({1, 0.4, 1.3}, 0.4);
      if (!is_limited) made.time += 0.1;
      made.flight({1, 0.4, 1.3}, 0.2);
      made.hand({0, 0, 0}, 0.2);
      made.table(0.5);
      const std::string out = run_on(text_of(made.rows)).out;
      CHECK(has(out, is_limited ? "the gyroscope is at its limit" : "samples are missing"));
      if (has(out, "No free flight was found.")) continue;
      for (const Row& row : rows_of(out, "Flights")) {
        CHECK(std::stod(row[1]) - std::stod(row[0]) < 0.45);
        CHECK(is_untold_or(row[2], -0.9, 0.15));
      }
    }
  }
}

TEST_CASE("separators, decimal commas, other orders and languages of the columns change nothing") {
  std::vector<Row> rows = recorded();
  const std::string result = run_on(text_of(rows)).out;
  CHECK(run_on("\xEF\xBB\xBF" + text_of(rows, "\t")).out == result);
  std::vector<Row> commas = rows;
  for (std::size_t k = 1; k < commas.size(); ++k)
    for (std::string& cell : commas[k]) std::ranges::replace(cell, '.', ',');
  CHECK(run_on(text_of(commas, ";", "\r\n")).out == result);
  CHECK(run_on(text_of(commas, "\t")).out == result);
  rows[0] = {"\"Zeit (s)\"", "\"Gyroskop x (rad/s)\"", "\"Gyroskop y (rad/s)\"", "\"Gyroskop z (rad/s)\"",
             "\"Absolut (rad/s)\""};
  for (Row& row : rows) std::swap(row[0], row[3]);
  CHECK(run_on(text_of(rows)).out == result);
}

TEST_CASE("what is no recording of a gyroscope is refused in one sentence with the place") {
  const auto refused = [](const std::string& text, const std::string& why) {
    const Outcome outcome = run_on(text);
    CAPTURE(why);
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    CHECK(has(outcome.err, why));
  };
  std::vector<Row> rows = recorded();
  refused("", "cannot be read, or is empty");
  refused("\"Time (s)\",\"Acceleration x (m/s^2)\"\n0,1\n", "has no column like \"Gyroscope x (rad/s)\"");
  refused(text_of({rows[0], rows[1], rows[2]}), "has fewer than three samples");
  rows.resize(20);
  rows[9][2] = "north";
  refused(text_of(rows), "line 10: \"north\" is no number");
  rows[9].pop_back();
  refused(text_of(rows), "line 10 has 4 columns, and the first line 5");
  rows[9] = rows[7];
  refused(text_of(rows), "line 10: the time does not go on");
  rows[0][2] = rows[0][1];
  refused(text_of(rows), "has two columns like \"Gyroscope x (rad/s)\"");
}

TEST_CASE("a recording of steady rotations has no flight") {
  std::vector<Row> steady(1, recorded()[0]);
  for (int k = 0; k < 200; ++k) steady.push_back({fmt::format("{}", 0.01 * k), "0.1", "0.05", "12", "12"});
  CHECK(has(run_on(text_of(steady)).out, "No free flight was found."));
}
