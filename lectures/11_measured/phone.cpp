// What your own functions say about a recording of your own: a phone, or something with a phone on it, thrown into the
// air. The notes of lecture 11 tell how to record.
//
//   RECORDING=my_throws.csv ./checker/run try lectures/11_measured/phone.cpp
//
// Without RECORDING it reads the one beside this file. It needs euler_coefficients, mean_and_error, rigidity_defect and
// moment_ratios.
#include <rigid/measured.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace rigid;
namespace fs = std::filesystem;
using Eigen::Index;

namespace {

// What counts as a free flight.
constexpr double least_rate = 4;             // rad/s; the air and the hand win below it
constexpr double least_time = 0.25;          // s
constexpr double largest_push = 35;          // rad/s² that Euler's equations do not explain: hand, table, bounce
constexpr double noise = 0.05;               // rad/s of a sample
constexpr double least_way = 1;              // rad/s that each component must vary by
constexpr double largest_coefficient = 1.1;  // of a body it is 1
constexpr double largest_defect = 0.2;       // of a body it is 0

struct Recording {
  VectorXd t;
  Matrix3Xd omega;
};

/// A stretch of samples, from `begin` to `end` without it; why it is no flight, or "".
struct Stretch {
  Index begin, end;
  std::string reason;
};

// ---- Reading

std::vector<std::string> cells_of(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  for (std::string& cell : cells) {
    cell.erase(0, std::min(cell.find_first_not_of(" \t"), cell.size()));
    cell.erase(cell.find_last_not_of(" \t") + 1);
  }
  return cells;
}

/// Which column has a name like this. @throws std::runtime_error if none has, or several have
std::size_t column_of(const std::vector<std::string>& names, const char* like, const char* example) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!std::regex_search(names[k], std::regex(like, std::regex::icase))) continue;
    if (found) throw std::runtime_error(std::string("has two columns like \"") + example + "\"");
    found = k;
  }
  if (!found)
    throw std::runtime_error(std::string("has no column like \"") + example +
                             "\" in its first line; export the experiment \"Gyroscope\" of phyphox as CSV");
  return *found;
}

double number_in(std::string cell, char separator, std::size_t line) {
  if (separator != ',') std::replace(cell.begin(), cell.end(), ',', '.');
  char* end = nullptr;
  const double number = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0' || !std::isfinite(number))
    throw std::runtime_error("line " + std::to_string(line) + ": \"" + cell + "\" is no number");
  return number;
}

/// Columns are found by their names, in any order and any language that keeps the units: "… (s)", "… x (rad/s)".
Recording read(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) throw std::runtime_error("cannot be read, or is empty");
  const auto without_return = [](std::string& text) {
    while (!text.empty() && (text.back() == '\r' || text.back() == '\n')) text.pop_back();
  };
  without_return(line);
  if (line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);  // a mark that some programs write
  const char separator = line.find('\t') != std::string::npos ? '\t' : line.find(';') != std::string::npos ? ';' : ',';
  const std::vector<std::string> names = cells_of(line, separator);
  const std::size_t columns[4] = {column_of(names, R"(\(s\)$)", "Time (s)"),
                                  column_of(names, R"(\bx \(rad/s\)$)", "Gyroscope x (rad/s)"),
                                  column_of(names, R"(\by \(rad/s\)$)", "Gyroscope y (rad/s)"),
                                  column_of(names, R"(\bz \(rad/s\)$)", "Gyroscope z (rad/s)")};
  std::vector<double> numbers;
  for (std::size_t at = 2; std::getline(in, line); ++at) {
    without_return(line);
    if (line.empty()) continue;
    const std::vector<std::string> cells = cells_of(line, separator);
    if (cells.size() != names.size())
      throw std::runtime_error("line " + std::to_string(at) + " has " + std::to_string(cells.size()) +
                               " columns, and the first line " + std::to_string(names.size()));
    for (const std::size_t column : columns) numbers.push_back(number_in(cells[column], separator, at));
    const std::size_t count = numbers.size();
    if (count > 4 && numbers[count - 4] <= numbers[count - 8])
      throw std::runtime_error("line " + std::to_string(at) + ": the time does not go on");
  }
  const auto count = static_cast<Index>(numbers.size() / 4);
  if (count < 3) throw std::runtime_error("has fewer than three samples");
  const Eigen::Map<const Eigen::MatrixXd> rows(numbers.data(), 4, count);
  return {rows.row(0).transpose(), rows.bottomRows(3)};
}

// ---- Finding the flights

/// The change of ω in each step that the products make, without the coefficients.
Matrix3Xd steps_of_products(const VectorXd& t, const Matrix3Xd& omega) {
  Matrix3Xd steps(3, t.size() - 1);
  const auto products = [&](Index k) {
    const Vector3d w = omega.col(k);
    return Vector3d(w[1] * w[2], w[2] * w[0], w[0] * w[1]);
  };
  for (Index k = 0; k + 1 < t.size(); ++k) steps.col(k) = (t[k + 1] - t[k]) / 2 * (products(k) + products(k + 1));
  return steps;
}

/// How much of the change of ω in each step coefficients leave, beside what a free flight may leave; from the samples
/// of a part. Not your function: the search must not depend on it.
VectorXd pushes(const Recording& all, Index begin, Index end) {
  const Matrix3Xd products = steps_of_products(all.t, all.omega);
  Vector3d coefficients;
  for (int axis = 0; axis < 3; ++axis) {
    VectorXd sum = VectorXd::Zero(end - begin);
    for (Index k = 1; k < sum.size(); ++k) sum[k] = sum[k - 1] + products(axis, begin + k - 1);
    sum.array() -= sum.mean();
    const double square = sum.squaredNorm();
    coefficients[axis] = square > 0 ? all.omega.row(axis).segment(begin, end - begin).dot(sum) / square : 0.0;
  }
  VectorXd left(all.t.size() - 1);
  for (Index k = 0; k < left.size(); ++k) {
    const Vector3d change = all.omega.col(k + 1) - all.omega.col(k) - coefficients.cwiseProduct(products.col(k));
    left[k] = change.cwiseAbs().maxCoeff() / (noise + largest_push * (all.t[k + 1] - all.t[k]));
  }
  return left;
}

Recording part_of(const Recording& all, Index begin, Index end) {
  return {all.t.segment(begin, end - begin), all.omega.middleCols(begin, end - begin)};
}

/// The stretches between gaps and samples at the sensor's limit, and these.
std::vector<Stretch> usable_parts(const Recording& all, std::vector<Stretch>& left_out) {
  const Index count = all.t.size();
  VectorXd steps = all.t.tail(count - 1) - all.t.head(count - 1);
  std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
  const double usual = steps[steps.size() / 2];
  std::vector<bool> at_limit(static_cast<std::size_t>(count));
  for (int axis = 0; axis < 3; ++axis) {
    const double limit = all.omega.row(axis).cwiseAbs().maxCoeff();
    for (Index k = 2; k < count; ++k) {
      const auto is_at_limit = [&](Index at) { return std::abs(all.omega(axis, at)) > limit * (1 - 1e-4); };
      if (limit > least_rate && is_at_limit(k - 2) && is_at_limit(k - 1) && is_at_limit(k))
        for (Index at = k - 2; at <= k; ++at) at_limit[static_cast<std::size_t>(at)] = true;
    }
  }
  std::vector<Stretch> parts;
  Index begin = 0;
  for (Index k = 0; k <= count; ++k) {
    const bool limited = k < count && at_limit[static_cast<std::size_t>(k)];
    const bool gap = k > 0 && k < count && all.t[k] - all.t[k - 1] > 2.5 * usual;
    if (k < count && !limited && !gap) continue;
    if (k > begin) parts.push_back({begin, k, ""});
    begin = k;
    if (gap) left_out.push_back({k - 1, k + 1, "samples are missing"});
    if (!limited) continue;
    while (begin < count && at_limit[static_cast<std::size_t>(begin)]) ++begin;
    left_out.push_back({k, begin, "the gyroscope is at its limit"});
    k = begin;
  }
  return parts;
}

/// The flights in a part: seeds that Euler's equations explain step by step, the best first, and as far as they do so
/// on both sides.
std::vector<Stretch> flights_in(const Recording& part) {
  constexpr Index seen = 300;  // samples on each side, at once
  const Index count = part.t.size();
  std::vector<bool> taken(static_cast<std::size_t>(count));
  const auto open = [&](Index k) {
    return !taken[static_cast<std::size_t>(k)] && part.omega.col(k).norm() > least_rate;
  };
  std::vector<std::pair<double, Stretch>> seeds;
  for (Index begin = 0, end = 0, slow = -1; begin < count; ++begin) {  // `slow` is the last sample below the least rate
    while (end < count && (end <= begin + 2 || part.t[end - 1] - part.t[begin] < least_time)) {
      if (!open(end)) slow = end;
      ++end;
    }
    if (slow >= begin || end - begin < 8 || part.t[end - 1] - part.t[begin] < least_time) continue;
    const double largest = pushes(part_of(part, begin, end), 0, end - begin).maxCoeff();
    if (largest < 1) seeds.push_back({largest, {begin, end, ""}});
  }
  std::stable_sort(seeds.begin(), seeds.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Stretch> flights;
  for (auto& [push, best] : seeds) {
    if (std::find(taken.begin() + best.begin, taken.begin() + best.end, true) != taken.begin() + best.end) continue;
    for (int round = 0; round < 8; ++round) {  // more samples, better coefficients
      const Index first = std::max<Index>(0, best.begin - seen), last = std::min(count, best.end + seen);
      const VectorXd left = pushes(part_of(part, first, last), best.begin - first, best.end - first);
      const Stretch before = best;
      while (best.begin > first && left[best.begin - 1 - first] < 1 && open(best.begin - 1)) --best.begin;
      while (best.end < last && left[best.end - 1 - first] < 1 && open(best.end)) ++best.end;
      if (best.begin == before.begin && best.end == before.end) break;
    }
    for (Index k = best.begin; k < best.end; ++k) taken[static_cast<std::size_t>(k)] = true;
    flights.push_back(best);
  }
  return flights;
}

/// Why a stretch is no throw of a body, or "".
std::string reason_against(const Recording& flight) {
  for (int axis = 0; axis < 3; ++axis)
    if (flight.omega.row(axis).maxCoeff() - flight.omega.row(axis).minCoeff() < least_way)
      return std::string("ω_") + "xyz"[axis] + " hardly changes: turn it so that it tumbles";
  const Vector3d abc = euler_coefficients(flight.t, flight.omega);
  if (abc.cwiseAbs().maxCoeff() > largest_coefficient ||
      std::abs(rigidity_defect(abc, Vector3d::Zero())[0]) > largest_defect)
    return "no rigid body has the coefficients of this motion";
  return "";
}

// ---- Showing

std::string shown(const char* format, double number, double other = 0) {
  char text[120];
  std::snprintf(text, sizeof text, format, number, other);
  return text;
}

std::string with_error(const VectorXd& values) {
  if (values.size() < 2) return shown("%8.4f", values[0]);
  const Vector2d both = mean_and_error(values);
  return shown("%8.4f ± %.4f", both[0], both[1]);
}

/// The samples of one axis over the integral of the product of the two others, with the line of your slope.
std::string picture(const Recording& flight, int axis, double slope) {
  constexpr double width = 340, height = 200, margin = 25;
  const Matrix3Xd steps = steps_of_products(flight.t, flight.omega);
  VectorXd sum = VectorXd::Zero(flight.t.size());
  for (Index k = 1; k < sum.size(); ++k) sum[k] = sum[k - 1] + steps(axis, k - 1);
  const VectorXd omega = flight.omega.row(axis).transpose();
  const double left = sum.minCoeff(), right = sum.maxCoeff(), low = omega.minCoeff(), high = omega.maxCoeff();
  const auto x = [&](double at) { return margin + (width - 2 * margin) * (at - left) / (right - left); };
  const auto y = [&](double at) { return height - margin - (height - 2 * margin) * (at - low) / (high - low); };
  std::ostringstream svg;
  svg << "<svg width='" << width << "' height='" << height << "' role='img' aria-label='omega "
      << "xyz"[axis] << " over the integral of the product of the two others'><g fill='#0068A8'>";
  for (Index k = 0; k < sum.size(); ++k) svg << "<circle cx='" << x(sum[k]) << "' cy='" << y(omega[k]) << "' r='2'/>";
  svg << "</g><line stroke='#B84300' x1='" << x(left) << "' x2='" << x(right) << "' y1='"
      << y(omega.mean() + slope * (left - sum.mean())) << "' y2='" << y(omega.mean() + slope * (right - sum.mean()))
      << "'/><text x='" << margin << "' y='18'>ω_"
      << "xyz"[axis] << ": " << shown("%.1f to %.1f", low, high) << " rad/s, slope " << shown("%.4f", slope)
      << "</text></svg>\n";
  return svg.str();
}

void report(const Recording& all) {
  std::vector<Stretch> left_out;
  std::vector<Recording> flights;
  std::ostringstream page;
  page << "<!doctype html><meta charset='utf-8'><title>Throws</title><style>body{font:16px sans-serif}"
          "text{font:14px sans-serif}</style><h1>Throws</h1>\n";
  for (const Stretch& part : usable_parts(all, left_out)) {
    const Recording samples = part_of(all, part.begin, part.end);
    std::vector<Stretch> found = flights_in(samples);
    std::sort(found.begin(), found.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
    for (Stretch each : found) {
      const Recording flight = part_of(samples, each.begin, each.end);
      each = {part.begin + each.begin, part.begin + each.end, reason_against(flight)};
      if (each.reason.empty())
        flights.push_back(flight);
      else
        left_out.push_back(each);
    }
  }
  // What else turns fast was held, or hit something, or is too short.
  const auto is_listed = [&](Index k) {
    const auto holds = [&](const Stretch& each) { return each.begin <= k && k < each.end; };
    const auto flies = [&](const Recording& each) {
      return each.t[0] <= all.t[k] && all.t[k] <= each.t[each.t.size() - 1];
    };
    return std::any_of(left_out.begin(), left_out.end(), holds) || std::any_of(flights.begin(), flights.end(), flies);
  };
  for (Index k = 0; k < all.t.size(); ++k) {
    const Index begin = k;
    while (k < all.t.size() && all.omega.col(k).norm() > least_rate && !is_listed(k)) ++k;
    if (k > begin + 2) left_out.push_back({begin, k, "no flight of a quarter of a second: a hand, a table, a bounce"});
  }
  std::sort(left_out.begin(), left_out.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
  for (std::size_t k = 1; k < left_out.size();) {  // one line for one reason, up to the next flight
    Stretch& before = left_out[k - 1];
    const double end = all.t[before.end - 1], begin = all.t[left_out[k].begin];
    const bool flies_between = std::any_of(
        flights.begin(), flights.end(), [&](const Recording& each) { return end <= each.t[0] && each.t[0] <= begin; });
    if (before.reason == left_out[k].reason && begin - end < 0.5 && !flies_between) {
      before.end = left_out[k].end;
      left_out.erase(left_out.begin() + static_cast<std::ptrdiff_t>(k));
    } else {
      ++k;
    }
  }

  if (!flights.empty()) std::cout << "   from      to        a        b        c   I_y/I_x  I_z/I_x\n";
  Eigen::MatrixXd results(5, flights.size());
  for (std::size_t k = 0; k < flights.size(); ++k) {
    const Recording& flight = flights[k];
    const Vector3d abc = euler_coefficients(flight.t, flight.omega);
    const auto column = static_cast<Index>(k);
    const Vector2d ratios = moment_ratios(abc[0], abc[2]);
    results.col(column) << abc, ratios;
    const double from = flight.t[0], to = flight.t[flight.t.size() - 1];
    std::cout << shown("%7.2f %7.2f s", from, to);
    for (Index i = 0; i < 5; ++i) std::cout << shown("%9.4f", results(i, column));
    std::cout << "\n";
    page << "<h2>" << shown("%.2f s to %.2f s", from, to) << "</h2>\n";
    for (int axis = 0; axis < 3; ++axis) page << picture(flight, axis, abc[axis]);
  }
  for (const Stretch& each : left_out)
    std::cout << shown("%7.2f %7.2f s", all.t[each.begin], all.t[each.end - 1]) << "  left out: " << each.reason
              << "\n";
  if (flights.empty()) {
    std::cout << "No free flight was found.\n";
    return;
  }
  const char* const names[] = {"a      ", "b      ", "c      ", "I_y/I_x", "I_z/I_x"};
  std::cout << "\n";
  for (Index i = 0; i < 5; ++i) std::cout << names[i] << "  " << with_error(results.row(i).transpose()) << "\n";
  VectorXd defects(results.cols());
  for (Index k = 0; k < results.cols(); ++k)
    defects[k] = rigidity_defect(results.col(k).head<3>(), Vector3d::Zero())[0];
  std::cout << "D        " << with_error(defects) << ", throw by throw\n";
  if (flights.size() > 1) {
    Vector3d means, errors;
    for (int i = 0; i < 3; ++i) {
      const Vector2d both = mean_and_error(results.row(i).transpose());
      means[i] = both[0];
      errors[i] = both[1];
    }
    const Vector2d D = rigidity_defect(means, errors);
    std::cout << "D        " << shown("%8.4f ± %.4f", D[0], D[1]) << ", from the means and their errors\n";
  } else {
    std::cout << "One throw has no error bar: throw again.\n";
  }
  const fs::path folder = fs::path(__FILE__).parent_path() / "../../.workbook", html = folder / "phone.html";
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  if (std::ofstream(html) << page.str())
    std::cout << "Pictures: " << fs::weakly_canonical(html, ignored).string() << "\n";
  else
    std::cout << "The page of pictures cannot be written.\n";
}

}  // namespace

int main() {
  const char* const own = std::getenv("RECORDING");
  const fs::path file = own ? fs::path(own) : fs::path(__FILE__).parent_path() / "racket_recording.csv";
  std::optional<Recording> recording;
  try {
    recording = read(file);
  } catch (const std::exception& reason) {
    std::cerr << file.string() << ": " << reason.what() << ".\n";
    return 1;
  }
  report(*recording);
}
