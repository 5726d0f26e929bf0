// What your own functions say about a recording of your own: a phone, or something with a phone on it, thrown into the
// air. The notes of lecture 11 tell how to record.
//
//   RECORDING=my_throws.csv ./checker/run try lectures/11_measured/phone.cpp
//
// Without RECORDING it reads the one beside this file. It needs euler_coefficients, rigidity_defect and moment_ratios;
// with tumbling_period and damped_rotation it compares periods and draws ω.
#include "throws.hpp"

#include <rigid/free_tops.hpp>

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <numeric>
#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace rigid;
using namespace measured;
namespace fs = std::filesystem;
using Eigen::Index;

namespace {

// What counts as a free flight.
constexpr double least_rate = 4;            // rad/s; the air and the hand win below it
constexpr double least_time = 0.25;         // s
constexpr double largest_push = 35;         // rad/s² that Euler's equations do not explain: hand, table, bounce
constexpr double largest_steady_push = 15;  // rad/s² of this over some hundredths of a second: the hand lets go slowly
constexpr double noise = 0.05;              // rad/s of a sample
constexpr double least_way = 1;             // rad/s that a component must vary by to tell its coefficient
constexpr double largest_coefficient = 1.1;  // of a body it is 1
constexpr double largest_defect = 0.2;       // of a body it is 0
constexpr double largest_drag = 1;           // 1/s; of a racket a quarter
constexpr double largest_change = 0.08;      // of a coefficient by the air
constexpr double largest_rest = 0.08;        // of ω that neither coefficients nor the air explain

using Recording = Flight;  // all of it, or a part

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

/// A table of text. Columns are found by their names, in any order and any language that keeps the units: "… (s)",
/// "… x (rad/s)".
Recording read_table(const std::string& table) {
  std::istringstream in(table);
  std::string line;
  if (!std::getline(in, line)) throw std::runtime_error("cannot be read, or is empty");
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

/// The tables of a zip file by their names, without those on the phone itself.
std::vector<std::pair<std::string, std::string>> tables_in(const std::string& bytes) {
  constexpr std::size_t largest = std::size_t{1} << 28;
  const std::unique_ptr<archive, decltype(&archive_read_free)> opened(archive_read_new(), archive_read_free);
  archive_read_support_format_zip(opened.get());
  if (archive_read_open_memory(opened.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
    throw std::runtime_error("is a damaged zip file");
  std::vector<std::pair<std::string, std::string>> tables;
  archive_entry* entry = nullptr;
  for (int status = 0; (status = archive_read_next_header(opened.get(), &entry)) != ARCHIVE_EOF;) {
    if (status < ARCHIVE_WARN) throw std::runtime_error("is a damaged zip file");
    const char* const path = archive_entry_pathname(entry);
    const std::string name = path == nullptr ? "" : path;
    if (!std::regex_search(name, std::regex(R"(\.csv$)", std::regex::icase)) ||
        std::regex_search(name, std::regex("(^|/)(meta|__MACOSX)/")))
      continue;
    std::string text;
    std::array<char, 1 << 16> block{};
    la_ssize_t got = 0;
    while ((got = archive_read_data(opened.get(), block.data(), block.size())) > 0 && text.size() <= largest)
      text.append(block.data(), static_cast<std::size_t>(got));
    if (got < 0) throw std::runtime_error("is a damaged or encrypted zip file");
    if (text.size() > largest) throw std::runtime_error("holds a file of more than 256 MiB");
    tables.emplace_back(name, text);
  }
  return tables;
}

/// A table, or the one table of a gyroscope in a zip file.
Recording read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  if (!in || bytes.empty()) throw std::runtime_error("cannot be read, or is empty");
  if (bytes.rfind("PK", 0) != 0) {
    if (bytes.find('\0') != std::string::npos)
      throw std::runtime_error("is no text; export the experiment \"Gyroscope\" of phyphox as CSV");
    return read_table(bytes);
  }
  std::optional<Recording> found;
  std::string reasons, name_of_found;
  for (const auto& [name, text] : tables_in(bytes)) {
    try {
      const Recording recording = read_table(text);
      if (found) throw std::logic_error("holds two recordings, " + name_of_found + " and " + name);
      found = recording;
      name_of_found = name;
    } catch (const std::runtime_error& reason) {
      reasons += "; " + name + ": " + reason.what();
    }
  }
  if (!found) throw std::runtime_error("holds no table of a gyroscope" + reasons);
  return *found;
}

// ---- Finding the flights

/// How much of the change of ω in each step coefficients leave, beside what a free flight may leave; from the samples
/// of a part. Not your function: the search must not depend on it.
VectorXd pushes(const Recording& all, Index begin, Index end) {
  const Matrix3Xd sums = product_integrals(all),
                  products = sums.rightCols(sums.cols() - 1) - sums.leftCols(sums.cols() - 1);
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

/// Euler's equations in air, fitted to a flight: without the air, slow flights would seem to be those of no body.
struct Fit {
  Vector3d abc;
  double gamma;  // of a torque −γ L
  double rest;   // share of ω that coefficients and air leave
  Vector3d way;  // by which the tumbling changes each component, rad/s
};

Fit fit_in_air(const Recording& flight) {
  const Index count = flight.t.size();
  const Matrix3Xd products = product_integrals(flight);
  Matrix3Xd losses = Matrix3Xd::Zero(3, count);
  for (Index k = 1; k < count; ++k)
    losses.col(k) =
        losses.col(k - 1) - (flight.t[k] - flight.t[k - 1]) / 2 * (flight.omega.col(k - 1) + flight.omega.col(k));
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(3 * count, 4);
  VectorXd samples(3 * count);
  const auto centred = [](const auto& row) -> VectorXd { return (row.array() - row.mean()).matrix().transpose(); };
  for (int axis = 0; axis < 3; ++axis) {
    system.col(axis).segment(axis * count, count) = centred(products.row(axis));
    system.col(3).segment(axis * count, count) = centred(losses.row(axis));
    samples.segment(axis * count, count) = centred(flight.omega.row(axis));
  }
  const VectorXd found = system.colPivHouseholderQr().solve(samples);
  const Vector3d abc = found.head<3>(), ranges = products.rowwise().maxCoeff() - products.rowwise().minCoeff();
  return {abc, found[3], (samples - system * found).norm() / flight.omega.norm(), abc.cwiseAbs().cwiseProduct(ranges)};
}

/// A flight without the ends at which a hand still acts, or acts again.
Stretch without_hands(const Recording& part, const Stretch& flight) {
  constexpr double window = 0.04;  // s
  const Index count = flight.end - flight.begin;
  const Recording all = part_of(part, flight.begin, flight.end);
  const Fit fit = fit_in_air(all);
  const Matrix3Xd products = product_integrals(all);
  Matrix3Xd left = Matrix3Xd::Zero(3, count);  // what coefficients and air leave of ω
  for (Index k = 1; k < count; ++k)
    left.col(k) = left.col(k - 1) + all.omega.col(k) - all.omega.col(k - 1) -
                  fit.abc.cwiseProduct(products.col(k) - products.col(k - 1)) +
                  fit.gamma * (all.t[k] - all.t[k - 1]) / 2 * (all.omega.col(k - 1) + all.omega.col(k));
  Index first = 0, last = count;
  for (Index begin = 0, end = 0; begin < count; ++begin) {
    while (end < count && all.t[end] - all.t[begin] < window) ++end;
    if (end == count) break;
    const double push = (left.col(end) - left.col(begin)).cwiseAbs().maxCoeff() / (all.t[end] - all.t[begin]);
    if (push < largest_steady_push) continue;
    if (begin < count / 3) first = (begin + end) / 2;
    if (end >= count - count / 3) last = std::min(last, (begin + end) / 2);
  }
  return {flight.begin + first, flight.begin + last, ""};
}

/// Which of the coefficients a flight tells: those of components that the tumbling changes enough, and the air little.
std::array<bool, 3> told_by(const Recording& flight, const Fit& fit) {
  const Vector3d changes = (euler_coefficients(flight.t, flight.omega) - fit.abc).cwiseAbs();
  const auto told = [&](int axis) { return fit.way[axis] >= least_way && changes[axis] <= largest_change; };
  return {told(0), told(1), told(2)};
}

/// Why a stretch is no throw of a body, or "".
std::string reason_against(const Recording& flight) {
  const Fit fit = fit_in_air(flight);
  Index least = 0;
  fit.way.minCoeff(&least);
  if ((fit.way.array() >= least_way).count() < 2)
    return std::string("ω_") + "xyz"[least] + " hardly changes, nor does another component: turn it so that it tumbles";
  const std::array<bool, 3> told = told_by(flight, fit);
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (told.at(axis)) largest = std::max(largest, std::abs(fit.abc[static_cast<Index>(axis)]));
  const Index count = std::count(told.begin(), told.end(), true);
  if (largest > largest_coefficient || (count == 3 && std::abs(fit.abc.sum() + fit.abc.prod()) > largest_defect) ||
      std::abs(fit.gamma) > largest_drag || fit.rest > largest_rest)
    return "no rigid body has the coefficients of this motion";
  return count < 2 ? "the air changes it more than its tumbling does: turn it so that it tumbles" : "";
}

/// The flights of a recording, and what is left out, with reasons.
std::pair<std::vector<Recording>, std::vector<Stretch>> search(const Recording& all) {
  std::vector<Stretch> left_out;
  std::vector<Recording> flights;
  for (const Stretch& part : usable_parts(all, left_out)) {
    const Recording samples = part_of(all, part.begin, part.end);
    std::vector<Stretch> found = flights_in(samples);
    std::sort(found.begin(), found.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
    for (Stretch each : found) {
      for (int round = 0; round < 2; ++round) each = without_hands(samples, each);
      const Recording flight = part_of(samples, each.begin, each.end);
      if (flight.t.size() < 8 || flight.t[flight.t.size() - 1] - flight.t[0] < least_time) continue;  // told below
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
  return {flights, left_out};
}

// ---- What the functions say

/// Intervals between zeros of the component about the intermediate axis, beside half of the exact period, s.
std::vector<Vector2d> half_periods(const Recording& flight, const Vector3d& I) {
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int i, int j) { return I[i] < I[j]; });
  std::vector<std::pair<double, Index>> zeros;
  for (Index k = 1; k < flight.t.size(); ++k) {
    const double before = flight.omega(order[1], k - 1), now = flight.omega(order[1], k);
    if (before * now < 0)
      zeros.emplace_back(flight.t[k - 1] + (flight.t[k] - flight.t[k - 1]) * before / (before - now), k);
  }
  std::vector<Vector2d> all;
  for (std::size_t k = 1; k < zeros.size(); ++k) {
    const Vector3d half_way = flight.omega.col((zeros[k - 1].second + zeros[k].second) / 2);
    all.emplace_back(zeros[k].first - zeros[k - 1].first, tumbling_period(I(order), half_way(order)) / 2);
  }
  return all;
}

/// The motion in air that fits a flight, and how far the samples lie from it.
struct InAir {
  double gamma;
  Matrix3Xd curve;
  double deviation;
};

InAir motion_of(const Recording& flight, const Vector3d& I) {
  const double gamma = std::max(0.0, -log_slope(flight.t, sizes_of_L(flight, I)));
  const Vector3d start =
      fitted_start(flight, [&](const Vector3d& from) { return motion_in_air(I, flight.t, from, gamma); });
  Matrix3Xd curve(3, flight.t.size());
  for (Index k = 0; k < curve.cols(); ++k) curve.col(k) = damped_rotation(I, start, gamma, flight.t[k] - flight.t[0]);
  return {gamma, curve, root_mean_square(curve - flight.omega)};
}

// ---- Showing

std::string shown(const char* format, double number, double other = 0) {
  char text[120];
  std::snprintf(text, sizeof text, format, number, other);
  return text;
}

/// Points and lines of one colour, in a frame with numbers at its sides.
struct Series {
  VectorXd x, y;
  const char* color;
  bool is_line;
};

std::string picture(const std::vector<Series>& all, const std::string& title, const std::string& x_name,
                    const std::string& about) {
  constexpr double width = 460, height = 280, left = 44, right = 8, top = 28, bottom = 42;
  double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
  for (const Series& each : all) {
    x0 = std::min(x0, each.x.minCoeff());
    x1 = std::max(x1, each.x.maxCoeff());
    y0 = std::min(y0, each.y.minCoeff());
    y1 = std::max(y1, each.y.maxCoeff());
  }
  const auto x = [&](double at) { return left + (width - left - right) * (at - x0) / (x1 - x0); };
  const auto y = [&](double at) { return height - bottom - (height - top - bottom) * (at - y0) / (y1 - y0); };
  std::ostringstream svg;
  svg << "<figure><svg viewBox='0 0 " << width << " " << height << "' role='img' aria-label='" << about << "'>";
  const auto numbers = [](double from, double to) {
    double step = std::pow(10, std::floor(std::log10((to - from) / 3)));
    for (const double larger : {2.0, 2.5})
      if ((to - from) / step > 6) step *= larger;
    std::vector<double> all_numbers;
    for (double at = std::ceil(from / step) * step; at <= to; at += step)
      all_numbers.push_back(std::abs(at) < step / 2 ? 0 : at);
    return all_numbers;
  };
  for (const double at : numbers(x0, x1))
    svg << "<path class='grid' d='M" << x(at) << " " << top << "V" << height - bottom
        << "'/><text text-anchor='middle' x='" << x(at) << "' y='" << height - bottom + 18 << "'>" << shown("%g", at)
        << "</text>";
  for (const double at : numbers(y0, y1))
    svg << "<path class='grid' d='M" << left << " " << y(at) << "H" << width - right << "'/><text text-anchor='end' x='"
        << left - 6 << "' y='" << y(at) + 5 << "'>" << shown("%g", at) << "</text>";
  for (const Series& each : all) {
    if (each.is_line) svg << "<polyline class='" << each.color << "' points='";
    for (Index k = 0; k < each.x.size(); ++k) {
      if (each.is_line)
        svg << x(each.x[k]) << "," << y(each.y[k]) << " ";
      else
        svg << "<circle class='" << each.color << "' cx='" << x(each.x[k]) << "' cy='" << y(each.y[k]) << "' r='2.4'/>";
    }
    if (each.is_line) svg << "'/>";
  }
  svg << "<text x='" << left << "' y='18'>" << title << "</text><text text-anchor='middle' x='"
      << (left + width - right) / 2 << "' y='" << height - 6 << "'>" << x_name << "</text></svg></figure>\n";
  return svg.str();
}

/// The samples of one axis over the integral of the product of the two others, with the line of your slope.
std::string picture_of_line(const Recording& flight, int axis, double slope) {
  const VectorXd sum = product_integrals(flight).row(axis).transpose(), omega = flight.omega.row(axis).transpose();
  const Vector2d ends(sum.minCoeff(), sum.maxCoeff());
  const std::string name = std::string("ω_") + "xyz"[axis];
  return picture({{sum, omega, "samples", false},
                  {ends, (omega.mean() + slope * (ends.array() - sum.mean())).matrix(), "line", true}},
                 name + " (rad/s), slope " + shown("%.4f", slope),
                 std::string("∫ ω_") + "xyz"[(axis + 1) % 3] + " ω_" + "xyz"[(axis + 2) % 3] + " dt (rad²/s)",
                 name + " over the integral of the product of the two others, samples and line");
}

std::string picture_in_air(const Recording& flight, const InAir& motion) {
  const VectorXd t = flight.t.array() - flight.t[0];
  std::vector<Series> all;
  for (int axis = 0; axis < 3; ++axis) {
    const char* const color = std::array{"x", "y", "z"}.at(static_cast<std::size_t>(axis));
    all.push_back({t, motion.curve.row(axis).transpose(), color, true});
    all.push_back({t, flight.omega.row(axis).transpose(), color, false});
  }
  return picture(all,
                 "ω (rad/s): <tspan class='x'>x</tspan> <tspan class='y'>y</tspan> <tspan class='z'>z</tspan>, γ = " +
                     shown("%.2f 1/s, left over %.2f rad/s", motion.gamma, motion.deviation),
                 "time (s)", "the components of omega over time, samples and the motion in air");
}

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Throws</title>
<style>
:root { color-scheme: light dark; --ground: #ffffff; --line: #d5d9de; --text: #1c2126; --quiet: #56616b;
  --x: #b84300; --y: #00734d; --z: #0068a8; }
@media (prefers-color-scheme: dark) { :root { --ground: #17191c; --line: #3a4047; --text: #e4e7ea; --quiet: #a5afb8;
  --x: #ff9a60; --y: #5fd0a0; --z: #7cbcf0; } }
body { margin: 0 auto; max-width: 60rem; padding: 1.5rem 1.25rem 3rem; background: var(--ground); color: var(--text);
  font: 1rem/1.55 system-ui, "Helvetica Neue", Arial, sans-serif; overflow-wrap: anywhere; }
h1 { margin: 0.1rem 0 0.3rem; font-size: 1.9rem; }
h2 { margin: 2.2rem 0 0.6rem; font-size: 1.35rem; }
.quiet { color: var(--quiet); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; overflow-wrap: normal; }
th, td { padding: 0.2rem 0.8rem 0.2rem 0; border-bottom: 1px solid var(--line); text-align: left; white-space: nowrap; }
td:last-child { white-space: normal; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); gap: 0.6rem 1.2rem; }
figure { margin: 0; }
svg { display: block; width: 100%; height: auto; font: 14px "Helvetica Neue", Arial, sans-serif; fill: var(--text); }
.grid { stroke: var(--line); }
polyline { fill: none; stroke-width: 1.8; }
.samples { fill: var(--z); } .line { stroke: var(--x); }
circle.x, tspan.x { fill: var(--x); } circle.y, tspan.y { fill: var(--y); } circle.z, tspan.z { fill: var(--z); }
polyline.x { stroke: var(--x); } polyline.y { stroke: var(--y); } polyline.z { stroke: var(--z); }
</style>
</head>
<body>
<h1>Throws</h1>
)";

/// What is printed, and the page.
class Report {
 public:
  /// Begins a table; in a terminal its columns have this width.
  void heading(const std::string& title, const std::vector<std::string>& names, std::size_t width) {
    width_ = width;
    std::cout << "\n" << title << "\n";
    page << "<h2>" << title << "</h2>\n<div class='wide'><table>\n";
    row(names, "th");
  }
  void row(const std::vector<std::string>& cells, const char* tag = "td") {
    page << "<tr>";
    for (const std::string& cell : cells) {
      std::cout << cell << (&cell == &cells.back() ? "\n" : std::string(width_ - cell.size(), ' '));
      page << "<" << tag << ">" << cell << "</" << tag << ">";
    }
    page << "</tr>\n";
  }
  void end() { page << "</table></div>\n"; }
  void line(const std::string& text) {
    std::cout << text << "\n";
    page << "<p>" << text << "</p>\n";
  }

  std::ostringstream page;

 private:
  std::size_t width_ = 0;
};

/// a, b, c, the ratios of the moments, and D.
VectorXd all_of(const Vector3d& abc) {
  VectorXd all(6);
  all << abc, moment_ratios(abc[0], abc[2]), rigidity_defect(abc, Vector3d::Zero())[0];
  return all;
}

/// The same of a flight, not a number where the flight does not tell it.
VectorXd told_of(const Recording& flight) {
  VectorXd all = all_of(euler_coefficients(flight.t, flight.omega));
  const auto [a, b, c] = told_by(flight, fit_in_air(flight));
  const bool is_told[] = {a, b, c, a && c, a && c, a && b && c};
  for (Index i = 0; i < 6; ++i)
    if (!is_told[i]) all[i] = std::nan("");
  return all;
}

/// Each of these with its error: from the scatter of several flights, or from the noise of the only one that tells it.
Eigen::MatrixXd with_errors(const std::vector<Recording>& flights, const Eigen::MatrixXd& results) {
  Eigen::MatrixXd both = Eigen::MatrixXd::Constant(6, 2, std::nan(""));
  for (Index i = 0; i < 6; ++i) {
    std::vector<double> values;
    std::size_t last = 0;
    for (std::size_t k = 0; k < flights.size(); ++k) {
      if (std::isnan(results(i, static_cast<Index>(k)))) continue;
      values.push_back(results(i, static_cast<Index>(k)));
      last = k;
    }
    if (values.size() > 1) {
      both.row(i) = mean_and_error(VectorXd::Map(values.data(), static_cast<Index>(values.size()))).transpose();
    } else if (values.size() == 1) {
      const Vector3d abc = coefficients_without_steps(flights[last]);
      const Matrix3Xd changes = changes_by_noise(flights[last]);
      double squares = 0;
      for (const auto& change : changes.colwise()) squares += std::pow(all_of(abc + change)[i] - all_of(abc)[i], 2);
      both.row(i) << all_of(abc)[i], std::sqrt(squares);
    }
  }
  return both;
}

/// In a table "-" stands for what was not measured.
std::string number_or_dash(double value) { return std::isnan(value) ? "-" : shown("%.4f", value); }
std::string with_error(double value, double error) {
  return std::isnan(value) ? "-" : shown("%.4f ± %.4f", value, error);
}

void report_periods(Report& report, const std::vector<Recording>& flights, const Vector3d& I) {
  report.heading("Half of the period, measured and exact", {"from (s)", "measured (s)", "exact (s)", "ratio"}, 14);
  std::vector<double> ratios;
  for (const Recording& flight : flights) {
    for (const Vector2d& each : half_periods(flight, I)) {
      ratios.push_back(each[0] / each[1]);
      report.row(
          {shown("%.2f", flight.t[0]), shown("%.3f", each[0]), shown("%.3f", each[1]), shown("%.3f", ratios.back())});
    }
  }
  report.end();
  if (ratios.size() > 1) {
    const Vector2d mean = mean_and_error(VectorXd::Map(ratios.data(), static_cast<Index>(ratios.size())));
    report.line("ratio " + with_error(mean[0], mean[1]));
  } else if (ratios.empty()) {
    report.line("No flight lasts from one zero of the component about the intermediate axis to the next.");
  }
}

void report(const Recording& all) {
  const auto [flights, left_out] = search(all);
  Report report;
  Eigen::MatrixXd results(6, flights.size());
  report.heading("Flights", {"from (s)", "to (s)", "a", "b", "c", "I_y/I_x", "I_z/I_x"}, 11);
  for (std::size_t k = 0; k < flights.size(); ++k) {
    const Recording& flight = flights[k];
    results.col(static_cast<Index>(k)) = told_of(flight);
    std::vector<std::string> cells = {shown("%.2f", flight.t[0]), shown("%.2f", flight.t[flight.t.size() - 1])};
    for (Index i = 0; i < 5; ++i) cells.push_back(number_or_dash(results(i, static_cast<Index>(k))));
    report.row(cells);
  }
  report.end();
  if (flights.empty()) report.line("No free flight was found.");
  if (!left_out.empty()) {
    report.heading("Left out", {"from (s)", "to (s)", "because"}, 11);
    for (const Stretch& each : left_out)
      report.row({shown("%.2f", all.t[each.begin]), shown("%.2f", all.t[each.end - 1]), each.reason});
    report.end();
  }
  if (!flights.empty()) {
    const Eigen::MatrixXd both = with_errors(flights, results);
    report.heading("Results", {"", "with standard error"}, 14);
    const char* const names[] = {"a", "b", "c", "I_y/I_x", "I_z/I_x", "D"};
    for (Index i = 0; i < 6; ++i) report.row({names[i], with_error(both(i, 0), both(i, 1))});
    report.end();
    if (flights.size() > 1 && both.topRows<3>().allFinite()) {
      const Vector2d D = rigidity_defect(both.col(0).head<3>(), both.col(1).head<3>());
      report.line("D from the means and their errors: " + with_error(D[0], D[1]));
    } else if (flights.size() == 1) {
      report.line("One throw: these are the errors that the noise of its samples makes. Throw again for all others.");
    }
    const Vector3d I(1, both(3, 0), both(4, 0));
    const bool is_body = (I.array() > 0).all() && I.allFinite();
    if (!is_body)
      report.line(I.allFinite() ? "With these ratios of the moments there is no body to compute periods and motions of."
                                : "No flight tells both a and c, so no ratio of moments, no period and no motion.");
    std::vector<std::string> motions(flights.size());
    const auto unless_not_started = [&](const auto& action) {
      try {
        if (is_body) action();
      } catch (const NotStarted& missing) {
        report.line(std::string(missing.function) + " is not started; what needs it is left out.");
      }
    };
    unless_not_started([&] { report_periods(report, flights, I); });
    unless_not_started([&] {
      for (std::size_t k = 0; k < flights.size(); ++k)
        motions[k] = picture_in_air(flights[k], motion_of(flights[k], I));
    });
    for (std::size_t k = 0; k < flights.size(); ++k) {
      const Recording& flight = flights[k];
      report.page << "<h2>" << shown("%.2f s to %.2f s", flight.t[0], flight.t[flight.t.size() - 1])
                  << "</h2>\n<div class='pictures'>" << motions[k];
      const Vector3d abc = results.col(static_cast<Index>(k)).head<3>();
      for (int axis = 0; axis < 3; ++axis)
        if (!std::isnan(abc[axis])) report.page << picture_of_line(flight, axis, abc[axis]);
      report.page << "</div>\n";
    }
  }
  const fs::path folder = fs::path(__FILE__).parent_path() / "../../.workbook", html = folder / "phone.html";
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  if (std::ofstream(html) << head << report.page.str() << "</body>\n</html>\n")
    std::cout << "\nPictures: " << fs::weakly_canonical(html, ignored).string() << "\n";
  else
    std::cout << "\nThe page of pictures cannot be written.\n";
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
