// Numbers that this project did not make, against what the pages print. `ctest -R outside_cases -V` shows the table.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Values = std::vector<double>;
using Place = std::pair<std::string, std::string>;  ///< the worked example, and the name of its result

struct Case {
  std::string lecture;
  Place place;
  Values expected;
  double tolerance = 0;  ///< of the largest expected value
  std::string source;
};

const std::vector<Case> cases{
    {"03_inertia_tensor", {"cube", "(I_1, I_2, I_3)"}, {1 / 6.0, 11 / 12.0, 11 / 12.0}, 1e-13, "Taylor, example 10.2"},
    {"03_inertia_tensor",
     {"station", "(I_1, I_2, I_3)"},
     {293.95245163, 447.74525937, 622.30228900},
     1e-10,
     "Space Dynamics Workbook, worked example 10"},
    {"03_inertia_tensor",
     {"validity", "(I_1, I_2, I_3)"},
     {2 - 0.8 * std::sqrt(2.0), 2, 2 + 0.8 * std::sqrt(2.0)},
     1e-13,
     "tests of Drake, rotational inertia: refused"},
    {"02_rotating_frames", {"reich", "d"}, {27.5}, 0.01, "F. Reich 1832: the theory that he printed"},
    {"02_rotating_frames", {"reich", "d"}, {28.4}, 0.05, "F. Reich 1832: the mean of 106 drops"},
    {"02_rotating_frames", {"foucault", R"(24\,\mathrm h\cdot360^\circ/P)"}, {272}, 0.005, "Irish Times"},
    {"02_rotating_frames", {"foucault", R"(2\pi/\omega_0)"}, {16}, 0.03, "GFD Dennou Club, Kyoto"},
    {"02_rotating_frames", {"gun", "d"}, {804.672}, 1, "Scientific American: about half a mile"},
    {"05_euler_equations",
     {"standard", "(y_1, y_2, y_3)"},
     {-0.9396570798729192, -0.3421177754000779, 0.7414126596199957},
     1e-9,
     "Enright and Pryce, DETEST, problem B5"},
    {"05_euler_equations",
     {"standard", R"((\mathrm{sn}, \mathrm{cn}, \mathrm{dn}))"},
     {-0.9396570798729192, -0.3421177754000779, 0.7414126596199957},
     1e-12,
     "Enright and Pryce, DETEST, problem B5"},
    {"06_free_tops", {"oblate", R"(-\Omega)"}, {-14 / 9.0}, 1e-13, "tests of Principia"},
    {"06_free_tops",
     {"plate", R"(\dot\phi/(\dot\phi + \dot\psi))"},
     {1.97007},
     5e-6,
     "Tuleja and others on Feynman's wobbling plate"},
    {"06_free_tops", {"earth", R"(2\pi/\Omega)"}, {305}, 0.005, "Euler's period of the pole"},
    {"08_kinetic_energy", {"quaternion", "T"}, {(8 * 2.1 + 2 * 2.9) / 225}, 1e-14, "tests of Emmy"},
    {"09_heavy_top",
     {"steady", R"((\dot\phi_{\text{slow}},\ \dot\phi_{\text{fast}}))"},
     {3.758542593804, 42.711113219019},
     1e-12,
     "top of Sussman and Wisdom, roots to fifty digits"},
    {"09_heavy_top", {"planets", R"(\dot\phi_{\text{Mars}})"}, {-7.594}, 0.015, "A. S. Konopliv and others"},
    {"09_heavy_top", {"planets", R"(\dot\phi_{\text{Earth}})"}, {-50.407}, 5e-3, "N. Capitaine and others"},
};

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(line);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

/// All results of a lecture, with all their digits: lines "value", example, name, numbers, with tabs between.
std::map<Place, Values> results_of(const std::string& lecture) {
  std::map<Place, Values> results;
  std::ifstream in(std::filesystem::path(WORKBOOK_PRINTED_DIRECTORY) / (lecture + ".txt"));
  for (std::string line; std::getline(in, line);) {
    const std::vector<std::string> parts = split(line, '\t');
    if (parts.size() < 4 || parts[0] != "value") continue;
    Values& values = results[{parts[1], parts[2]}];
    for (std::size_t i = 3; i < parts.size(); ++i) values.push_back(std::stod(parts[i]));
  }
  return results;
}

}  // namespace

TEST_CASE("the pages print what outside sources say") {
  fmt::print("lecture | example | expected | ours | tolerance | source\n");
  for (const Case& outside : cases) {
    CAPTURE(outside.lecture);
    CAPTURE(outside.place.first);
    const auto results = results_of(outside.lecture);
    const auto ours = results.find(outside.place);
    REQUIRE_MESSAGE(ours != results.end(), outside.place.second);
    fmt::print("{} | {} | {} | {} | {:g} | {}\n", outside.lecture, outside.place.first, outside.expected, ours->second,
               outside.tolerance, outside.source);
    REQUIRE(ours->second.size() == outside.expected.size());
    double scale = 0;
    for (const double value : outside.expected) scale = std::max(scale, std::abs(value));
    for (std::size_t i = 0; i < outside.expected.size(); ++i) {
      const double difference = std::abs(ours->second[i] - outside.expected[i]);
      CHECK_MESSAGE(difference <= outside.tolerance * scale,
                    fmt::format("{:.17g} against {:.17g}", ours->second[i], outside.expected[i]));
    }
  }
}
