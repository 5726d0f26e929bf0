// The program of lecture 11 that reads recordings, on the reference implementation, with files as phones write them and
// as they should not be.
#include <doctest/doctest.h>
#include "tests/support/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace workbook::testing;
using Row = std::vector<std::string>;

/// The recording of the lecture as cells.
std::vector<Row> recorded() {
  std::vector<Row> rows(1, Row(1));
  for (const char c : read(WORKBOOK_TEST_RECORDING)) {
    if (c == '\n') {
      rows.emplace_back(1);
    } else if (c == ',') {
      rows.back().emplace_back();
    } else if (c != '\r') {
      rows.back().back() += c;
    }
  }
  rows.pop_back();
  return rows;
}

std::string text_of(const std::vector<Row>& rows, const std::string& separator = ",", const std::string& end = "\n") {
  std::string text;
  for (const Row& row : rows) text += fmt::format("{}{}", fmt::join(row, separator), end);
  return text;
}

Outcome run_on(const std::string& text) {
  const fs::path folder = WORKBOOK_TEST_SCRATCH;
  fs::create_directories(folder);
  write(folder / "recording.csv", text);
  return run_command(fmt::format("RECORDING='{}' '{}'", (folder / "recording.csv").string(), WORKBOOK_TEST_PHONE),
                     folder);
}

std::string with_decimal_comma(std::string text) {
  for (char& c : text) c = c == '.' ? ',' : c;
  return text;
}

}  // namespace

TEST_CASE("two throws are found in the recording, and the hand is left out") {
  const Outcome whole = run_on(text_of(recorded()));
  CHECK(whole.status == 0);
  CHECK(has(whole.out, "0.86    1.65 s  -0.9921   0.9534   0.8602"));
  CHECK(has(whole.out, "6.71    7.55 s  -0.9924   0.9753   0.8591"));
  CHECK(has(whole.out, "left out: no flight of a quarter of a second: a hand, a table, a bounce"));
  CHECK(has(whole.out, "a         -0.9922 ± 0.0001"));
}

TEST_CASE("separators, decimal commas, other orders and languages of the columns change nothing") {
  std::vector<Row> rows = recorded();
  const std::string result = run_on(text_of(rows)).out;
  CHECK(run_on("\xEF\xBB\xBF" + text_of(rows, "\t")).out == result);
  std::vector<Row> commas = rows;
  for (std::size_t k = 1; k < commas.size(); ++k)
    for (std::string& cell : commas[k]) cell = with_decimal_comma(cell);
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

TEST_CASE("gaps, a sensor at its limit and steady rotations are left out with the reason") {
  const std::vector<Row> rows = recorded();
  std::vector<Row> gap = rows;
  gap.erase(gap.begin() + 120, gap.begin() + 130);
  CHECK(has(run_on(text_of(gap)).out, "left out: samples are missing"));
  std::vector<Row> limited = rows, steady = {rows[0]};
  for (std::size_t k = 1; k < limited.size(); ++k)
    for (std::size_t i = 1; i < 4; ++i)
      limited[k][i] = fmt::format("{}", std::min(15.0, std::max(-15.0, std::stod(limited[k][i]))));
  CHECK(has(run_on(text_of(limited)).out, "left out: the gyroscope is at its limit"));
  for (int k = 0; k < 200; ++k) steady.push_back({fmt::format("{}", 0.01 * k), "0.1", "0.05", "12", "12"});
  const std::string outcome = run_on(text_of(steady)).out;
  CHECK(has(outcome, "No free flight was found."));
}
