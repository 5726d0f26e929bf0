#include "lectures/support/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <regex>
#include <stdexcept>

namespace workbook {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// About: without the marks of gnuplot's enhanced text, and with what an offset adds.
double width_in_pixels(const std::string& text) {
  const std::string shown = std::regex_replace(text, std::regex(R"(\{/[^ ]* |[{}_^]|[\x80-\xBF])"), "");
  return 9.0 * static_cast<double>(shown.size()) + 14;
}

/// Of "#RRGGBB", and as much whiter.
Vector3d rgb_of(const std::string& color, double whiteness) {
  Vector3d rgb;
  for (int i = 0; i < 3; ++i)
    rgb[i] = std::stoi(color.substr(2 * static_cast<std::size_t>(i) + 1, 2), nullptr, 16) / 255.0;
  return (1 - whiteness) * rgb + Vector3d::Constant(whiteness);
}

/// A part of a line of which nothing is hidden, or all.
struct Piece {
  SpaceCurve points;
  bool is_hidden;
};

/// As JSON, with so many decimal places.
std::string json(const Vector3d& vector, int places) {
  return fmt::format("[{:.{}f},{:.{}f},{:.{}f}]", vector.x(), places, vector.y(), places, vector.z(), places);
}

/// A description has whole numbers: so many over the shorter side of a picture, about a third of a pixel.
constexpr int units_of_description = 1000;

/// As gnuplot names it: what is hidden shows three tenths of its colour.
std::string shown_color(const std::string& color, bool is_hidden) {
  return is_hidden ? "#B3" + color.substr(1) : color;
}

}  // namespace

// ---- Light and depth.

/// What one sees of bodies, in samples of which 2 × 2 make a pixel of the picture; the light is that of
/// live/scene.frag.
class Sketch::Picture {
 public:
  Picture(const Sketch& sketch, const Range& range, int width)
      : corner_(range.min()), step_(range.sizes().x() / (3.0 * width)), tolerance_(0.006 * range.sizes().x()) {
    std::vector<Facet> all = sketch.bodies_;
    if (all.empty()) return;
    for (const Mark& face : sketch.lines_) {
      if (!face.is_face) continue;
      const auto& at = face.points;
      const SpaceCurve normals(at.size(), (at[1] - at[0]).cross(at[at.size() / 2] - at[0]));
      all.push_back({at, normals, rgb_of(face.color, 0), face.size, face.size == 1});
    }
    columns_ = 3 * width;
    rows_ = 2 * static_cast<int>(std::lround(range.sizes().y() / step_ / 2));
    samples_.resize(static_cast<std::size_t>(columns_ * rows_));
    // What one sees through comes last, from behind to the front.
    std::ranges::stable_sort(all, {}, [](const Facet& one) { return one.opacity < 1 ? one.corners[0].z() : -1e300; });
    for (const Facet& one : all)
      for (std::size_t i = 1; i + 1 < one.corners.size(); ++i) paint(one, {0, i, i + 1}, sketch.light_);
  }

  bool is_empty() const { return samples_.empty(); }

  std::vector<Piece> pieces(const SpaceCurve& line) const {
    std::vector<Piece> pieces{{{line.front()}, !is_empty() && hides(line.front())}};
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vector3d way = line[i + 1] - line[i];
      const int parts = is_empty() ? 0 : static_cast<int>(way.head<2>().norm() / step_ / 2) + 1;
      for (int k = 0; k < parts; ++k) {
        const Vector3d from = line[i] + way * k / parts;
        if (const bool is_hidden = hides(from + way * 0.5 / parts); is_hidden != pieces.back().is_hidden) {
          pieces.back().points.push_back(from);
          pieces.push_back({{from}, is_hidden});
        }
      }
      pieces.back().points.push_back(line[i + 1]);
    }
    // Near the rim of a body rounding may decide, so that what is short there counts as what is before it.
    std::vector<Piece> joined;
    for (const Piece& piece : pieces) {
      const bool is_short = (piece.points.back() - piece.points.front()).head<2>().norm() < 20 * step_;
      if (!joined.empty() && (is_short || piece.is_hidden == joined.back().is_hidden))
        joined.back().points.insert(joined.back().points.end(), piece.points.begin(), piece.points.end());
      else
        joined.push_back(piece);
    }
    return joined;
  }

  bool hides(const Vector3d& point) const {
    const Vector2d place = (point.head<2>() - corner_) / step_;
    const int column = static_cast<int>(std::floor(place.x())), row = static_cast<int>(std::floor(place.y()));
    return column >= 0 && row >= 0 && column < columns_ && row < rows_ &&
           samples_[static_cast<std::size_t>(row * columns_ + column)].nearest > point.z() + tolerance_;
  }

  /// An element of a plot command with data behind it, and these data.
  std::string plot() const {
    return fmt::format(
        ", '-' binary array=({},{}) origin=({:.6f},{:.6f}) dx={:.8f} dy={:.8f} "
        "format='%uchar%uchar%uchar%uchar' using 1:2:3:4 with rgbalpha",
        columns_ / 2, rows_ / 2, corner_.x() + step_, corner_.y() + step_, 2 * step_, 2 * step_);
  }
  std::string data() const {
    std::string bytes;
    for (int row = 0; row + 1 < rows_; row += 2) {
      for (int column = 0; column + 1 < columns_; column += 2) {
        std::array<double, 4> sum{};
        for (const int place : {0, 1, columns_, columns_ + 1}) {
          const Sample& sample = samples_[static_cast<std::size_t>(row * columns_ + column + place)];
          for (std::size_t i = 0; i < 4; ++i) sum.at(i) += sample.color.at(i);
        }
        for (std::size_t i = 0; i < 3; ++i)
          bytes += static_cast<char>(std::lround(255 * sum.at(i) / std::max(sum[3], 1e-9)));
        bytes += static_cast<char>(std::lround(255 * sum[3] / 4));
      }
    }
    return bytes;
  }

 private:
  struct Sample {
    double opaque = -1e300, nearest = -1e300;  ///< how near: what one does not see through, and all bodies
    std::array<double, 4> color{};             ///< times its opacity, and this
  };

  void paint(const Facet& one, const std::array<std::size_t, 3>& corners, const Vector3d& light) {
    const Vector3d mirror = (light + Vector3d::UnitZ()).normalized();
    Matrix3d places, normals;
    std::array<Vector2d, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      places.col(static_cast<Eigen::Index>(i)) = one.corners[corners.at(i)];
      normals.col(static_cast<Eigen::Index>(i)) = one.normals[corners.at(i)];
      at.at(i) = (one.corners[corners.at(i)].head<2>() - corner_) / step_;
    }
    const auto across = [](const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
    const double area = across(at[1] - at[0], at[2] - at[0]);
    if (area == 0) return;
    const auto bounds = [&](int axis, int end) {
      const auto [least, most] = std::minmax({at[0][axis], at[1][axis], at[2][axis]});
      return std::pair(std::max(0, static_cast<int>(least - 0.5)),
                       std::min(end, static_cast<int>(std::lround(most)) + 1));
    };
    const auto [left, right] = bounds(0, columns_);
    const auto [below, above] = bounds(1, rows_);
    for (int row = below; row < above; ++row) {
      for (int column = left; column < right; ++column) {
        const Vector2d here(column + 0.5, row + 0.5);
        const double u = across(here - at[0], at[2] - at[0]) / area, v = across(at[1] - at[0], here - at[0]) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        Sample& sample = samples_[static_cast<std::size_t>(row * columns_ + column)];
        const Vector3d parts(1 - u - v, u, v);
        const double z = places.row(2).dot(parts);
        if (one.hides_lines) sample.nearest = std::max(sample.nearest, z);
        if (z < sample.opaque) continue;
        if (one.opacity == 1) sample.opaque = z;
        Vector3d normal = normals * parts;
        normal *= (normal.z() < 0 ? -1 : 1) / normal.norm();
        const double shade = 0.5 + 0.5 * normal.dot(light), glint = std::pow(std::max(0.0, normal.dot(mirror)), 32);
        // In steps that the eye does not see, so that the picture takes a tenth of the room.
        const double brightness = std::round(48 * (0.53 + 0.42 * shade * shade + 0.07 * normal.z())) / 48;
        for (int i = 0; i < 3; ++i) {
          const double lit = one.rgb[i] * brightness + std::round(8 * glint) / 48;
          auto& part = sample.color.at(static_cast<std::size_t>(i));
          part = one.opacity * std::min(1.0, lit) + (1 - one.opacity) * part;
        }
        sample.color[3] = one.opacity + (1 - one.opacity) * sample.color[3];
      }
    }
  }

  Vector2d corner_;
  double step_, tolerance_;  ///< of a sample, and how far a line may lie below the surface on which it is drawn
  int columns_ = 0, rows_ = 0;
  std::vector<Sample> samples_;
};

// ---- What is drawn.

Sketch::Sketch(const Vector3d& towards, const Vector3d& up) {
  // Seen along the z axis, y points up.
  const Vector3d vertical = up.cross(towards).norm() < 1e-9 ? Vector3d::UnitY() : up;
  view_.row(2) = towards.normalized();
  view_.row(0) = vertical.cross(towards).normalized();
  view_.row(1) = this->towards().cross(right());
  upright_.row(2) = up;
  upright_.row(1) = up.cross(towards).normalized();  // zero where one looks from above
  upright_.row(0) = upright_.row(1).cross(upright_.row(2));
  // The light comes from above, from the left, and from behind the reader.
  light_ = (Vector3d(-0.35, 0.2, 0.55) + 0.9 * view_ * up).normalized();
}

Vector3d Sketch::seen(const Vector3d& point) {
  const Vector3d place = view_ * point;
  range_.extend(Vector2d(place.head<2>()));
  return place + forward_ * Vector3d::UnitZ();
}

SpaceCurve Sketch::seen(SpaceCurve points) {
  for (Vector3d& point : points) point = seen(point);
  return points;
}

void Sketch::line(const SpaceCurve& points, const std::string& color, double width, const std::string& style) {
  lines_.push_back({seen(points), color, width, style});
  static const std::regex lengths(R"(\(([\d.]+,[\d.]+)\))");
  std::smatch dash;
  std::regex_search(style, dash, lengths);
  describe("\"line\",[", points,
           fmt::format("],\"{}\",{:.3g},{{{}\"dash\":[{}]}}", name_of_color(color), width,
                       forward_ > 0 ? "\"layer\":\"front\"," : "", dash.empty() ? "0,0" : dash.str(1)));
}

void Sketch::face(const SpaceCurve& corners, const std::string& color, double opacity) {
  lines_.push_back({seen(corners), color, opacity, "", true});
  describe("\"face\",[", corners, fmt::format("],\"{}\",{:.3g}", name_of_color(color), opacity));
}

void Sketch::arrow(const Vector3d& from, const Vector3d& to, const std::string& color, const std::string& label,
                   Side side, double width) {
  arrows_.push_back({{seen(from), seen(to)}, color, width, ""});
  describe("\"arrow\",", {from, to}, fmt::format(",\"{}\",\"\",{{\"width\":{:.3g}}}", name_of_color(color), width));
  if (label.empty()) return;
  text(to, label, color, side);
  std::smatch parts;
  if (!std::regex_search(label, parts, std::regex("^(.*)_([123])((?:′)?)"))) return;
  auto& frame = frames_[parts[1].str() + parts[3].str()];
  frame[std::stoi(parts[2])] = to - from;
  if (frame.size() < 3) return;
  // Axes that are drawn within a plane have no sense.
  if (frame[1].normalized().dot(frame[2].normalized().cross(frame[3].normalized())) < -1e-9)
    throw std::logic_error(fmt::format("the axes {}_1, 2, 3 are left-handed", parts[1].str()));
  frame.clear();
}

void Sketch::box(const Vector3d& corner, const Matrix3d& edges) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d along = edges.col(axis), one = edges.col((axis + 1) % 3), other = edges.col((axis + 2) % 3);
    for (int i = 0; i < 4; ++i) {
      const Vector3d start = corner + (i & 1) * one + (i >> 1 & 1) * other;
      // An edge is at the back when both of its faces look away.
      const bool at_back =
          (i & 1 ? -1 : 1) * one.dot(towards()) > 0 && (i >> 1 & 1 ? -1 : 1) * other.dot(towards()) > 0;
      const SpaceCurve edge{start, start + along};
      lines_.push_back(
          {seen(edge), at_back ? colors::grey : colors::black, at_back ? 1.0 : 2.0, at_back ? "dt (4,4)" : ""});
      describe("\"line\",[", edge, "],\"ink\",1.5");
    }
  }
}

void Sketch::piece(const SpaceCurve& corners, const SpaceCurve& normals, const Vector3d& rgb, double opacity) {
  bodies_.push_back({seen(corners), {}, rgb, opacity});
  for (const Vector3d& normal : normals) bodies_.back().normals.emplace_back(view_ * normal);
}

void Sketch::solid_box(const Vector3d& center, const Matrix3d& half_edges,
                       const std::array<const char*, 3>& face_colors) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d one = half_edges.col((axis + 1) % 3), other = half_edges.col((axis + 2) % 3);
    for (const double side : {1.0, -1.0}) {
      const Vector3d outward = side * half_edges.col(axis), middle = center + outward;
      SpaceCurve corners{middle + one + other, middle - one + other, middle - one - other, middle + one - other};
      piece(corners, SpaceCurve(4, outward), rgb_of(face_colors.at(static_cast<std::size_t>(axis)), 0.3), 1);
      describe("\"face\",[", corners,
               fmt::format("],\"{}\",1,1,0.3", name_of_color(face_colors.at(static_cast<std::size_t>(axis)))));
      if (outward.dot(towards()) < 0) continue;
      corners.push_back(corners.front());
      lines_.push_back({seen(corners), colors::black, 1, ""});
    }
  }
}

void Sketch::turned(const PlaneCurve& profile, const Matrix3d& axes, const Vector3d& center, const std::string& color,
                    double whiteness, double opacity) {
  const Vector3d rgb = rgb_of(color, whiteness);
  constexpr int pieces = 60;
  const Matrix3d turn_normal = axes.inverse().transpose();
  const double length = axes.col(2).norm();
  const auto slope = [&](std::size_t i) {  // across a piece of the profile, outwards: along, and from the axis
    return Vector2d(profile[i].second - profile[i + 1].second, length * (profile[i + 1].first - profile[i].first))
        .normalized();
  };
  const auto around = [](int k, double radius, double along) -> Vector3d {
    return {radius * std::cos(2 * pi * k / pieces), radius * std::sin(2 * pi * k / pieces), along};
  };
  std::string described;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    std::array<Vector2d, 2> across{slope(i), slope(i)};
    // Round, unless there is an edge.
    if (i > 0 && slope(i - 1).dot(slope(i)) > 0.8) across[0] += slope(i - 1);
    if (i + 2 < profile.size() && slope(i + 1).dot(slope(i)) > 0.8) across[1] += slope(i + 1);
    for (const std::size_t end : {0U, 1U})
      described +=
          fmt::format("{}[[{:.4g},{:.4g}],[{:.3g},{:.3g}]]", described.empty() ? "" : ",", profile[i + end].second,
                      profile[i + end].first, across.at(end).y(), length * across.at(end).x());
    for (int k = 0; k < pieces; ++k) {
      SpaceCurve corners, normals;
      for (const auto& [end, turn] : {std::pair(0U, k), {1U, k}, {1U, k + 1}, {0U, k + 1}}) {
        const auto& [along, radius] = profile[i + end];
        corners.emplace_back(center + axes * around(turn, radius, along));
        normals.emplace_back(turn_normal * around(turn, across.at(end).y(), length * across.at(end).x()));
      }
      piece(corners, normals, rgb, opacity);
    }
  }
  describe("\"solid\",\"ball\",", {center},
           fmt::format(",\"{}\",{{\"profile\":[{}],\"whiteness\":{},\"opacity\":{}}}", name_of_color(color), described,
                       whiteness, opacity));
  calls_.back().axes = upright_ * axes;
}

void Sketch::ellipsoid(const Matrix3d& half_axes, const std::string& color, const Vector3d& center, double opacity) {
  PlaneCurve profile;
  for (int i = -15; i <= 15; ++i) profile.emplace_back(std::sin(i * pi / 30), std::cos(i * pi / 30));
  turned(profile, half_axes, center, color, 0.5, opacity);
}

void Sketch::turned_body(const Vector3d& from, const Vector3d& to, const PlaneCurve& profile, const std::string& color,
                         const Vector3d& wide, double opacity) {
  Matrix3d axes;
  axes.col(2) = to - from;
  axes.col(0) = wide.isZero() ? axes.col(2).unitOrthogonal() : wide;
  axes.col(1) = axes.col(2).cross(axes.col(0)).normalized();
  turned(profile, axes, from, color, 0.35, opacity);
}

void Sketch::ring(const Vector3d& center, const Vector3d& axis, double radius, double thickness,
                  const std::string& color) {
  PlaneCurve profile;
  for (int i = 0; i <= 12; ++i)
    profile.emplace_back(thickness * std::sin(i * pi / 6), radius - thickness * std::cos(i * pi / 6));
  turned_body(center, center + axis.normalized(), profile, color);
}

void Sketch::dot(const Vector3d& at, const std::string& color, double size) {
  dots_.push_back({{seen(at)}, color, size, ""});
  describe("\"dot\",", {at}, fmt::format(",\"{}\",{:.3g}", name_of_color(color), 5 * size));
}

void Sketch::text(const Vector3d& at, const std::string& text, const std::string& color, Side side,
                  const Vector2d& away) {
  const Vector3d place = at + away.x() * right() + away.y() * up();
  texts_.push_back({seen(place), text, color, side});
  places_of_texts_.emplace_back(upright_ * place);
  if (away.isZero()) return;
  const double forward = forward_;
  in_front(true);
  line({at, place}, color, 0.8);
  forward_ = forward;
}

void Sketch::describe(const std::string& before, const SpaceCurve& points, const std::string& after) {
  calls_.push_back({before, {}, Matrix3d::Zero(), after});
  for (const Vector3d& point : points) calls_.back().points.emplace_back(upright_ * point);
}

std::string Sketch::description(const Range& range) const {
  // It turns about the middle of the picture and of its depth.
  Eigen::AlignedBox3d box;
  for (const Call& call : calls_)
    for (const Vector3d& point : call.points) box.extend(point);
  const Matrix3d to_view = view_ * upright_.transpose();
  const Vector3d depth = to_view * box.center(),
                 middle = to_view.transpose() * Vector3d(range.center().x(), range.center().y(), depth.z());
  const double scale = units_of_description / range.sizes().minCoeff();
  const auto list = [&](const SpaceCurve& points) {
    std::string text;
    for (const Vector3d& point : points) text += (text.empty() ? "" : ",") + json(scale * (point - middle), 0);
    return text;
  };
  std::string calls;
  for (const auto& [before, points, axes, after] : calls_) {
    calls += (calls.empty() ? "[" : ",[") + before + list(points);
    if (!axes.isZero())
      calls += fmt::format(",[{},{},{}]", json(scale * axes.col(0), 1), json(scale * axes.col(1), 1),
                           json(scale * axes.col(2), 1));
    calls += after + "]";
  }
  return fmt::format("{{\"half\":{},\"towards\":{},\"calls\":[{}],\"texts\":[{}]}}", units_of_description / 2,
                     json(to_view.row(2), 4), calls, list(places_of_texts_));
}

// ---- The drawing.

void Sketch::draw(const std::filesystem::path& directory, const std::string& name, int width, bool turns) const {
  Range range = range_;
  double scale = 0;
  // Texts keep their size in pixels: how much room they take in units of the sketch follows step by step.
  for (int step = 0; step < 8; ++step) {
    scale = range.sizes().x() / (width - 16.0);
    for (const Text& text : texts_) {
      const double reach = scale * width_in_pixels(text.text);
      const double left = text.side == Side::left ? reach : text.side == Side::right ? 0 : reach / 2;
      const double below = text.side == Side::below ? 22 : 10, above = text.side == Side::above ? 22 : 10;
      range.extend(Vector2d(text.at.x() - left, text.at.y() - scale * below));
      range.extend(Vector2d(text.at.x() + reach - left, text.at.y() + scale * above));
    }
  }
  const FigureSize size{width, static_cast<int>(std::lround(range.sizes().y() / scale)) + 16};
  const Vector2d margin = Vector2d::Constant(8 * scale);
  const Range all(range.min() - margin, range.max() + margin);
  const Picture picture(*this, all, width);
  draw_figure(
      directory, name, size, [&](gnuplotio::Gnuplot& gnuplot) { send(gnuplot, all, picture); },
      turns && !upright_.row(1).isZero() ? description(all) : "");
}

void Sketch::send(gnuplotio::Gnuplot& gnuplot, FigureSize size, double half_width) const {
  const Vector2d corner(half_width, half_width * size.height / size.width);
  const Range range(-corner, corner);
  send(gnuplot, range, Picture(*this, range, size.width));
}

void Sketch::send(gnuplotio::Gnuplot& gnuplot, const Range& range, const Picture& picture) const {
  gnuplot << "unset key; unset border; unset tics; unset grid\n"
             "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\n"
          << fmt::format("set xrange [{:.6f}:{:.6f}]; set yrange [{:.6f}:{:.6f}]\n", range.min().x(), range.max().x(),
                         range.min().y(), range.max().y());
  for (const Mark& dot : dots_) {
    const Vector3d& at = dot.points.front();
    gnuplot << fmt::format("set label '' at {:.5f},{:.5f} point pt 7 ps {} lc rgb '{}' front\n", at.x(), at.y(),
                           dot.size, shown_color(dot.color, !picture.is_empty() && picture.hides(at)));
  }
  for (const Text& text : texts_) {
    const char* place = text.side == Side::left    ? "right offset -0.8,0"
                        : text.side == Side::right ? "left offset 0.8,0"
                        : text.side == Side::above ? "center offset 0,0.7"
                        : text.side == Side::below ? "center offset 0,-0.7"
                                                   : "center";
    gnuplot << fmt::format("set label \"{}\" at {:.5f},{:.5f} {} front tc rgb '{}'\n", text.text, text.at.x(),
                           text.at.y(), place, text.color);
  }
  for (const Mark& arrow : arrows_) {
    const auto pieces = picture.pieces(arrow.points);
    for (const Piece& piece : pieces) {
      const Vector3d &from = piece.points.front(), &to = piece.points.back();
      const std::string head =
          &piece != &pieces.back() ? "nohead" : fmt::format("head filled size {:.5f},18", 0.026 * range.sizes().x());
      gnuplot << fmt::format("set arrow from {:.5f},{:.5f} to {:.5f},{:.5f} {} front lw {} lc rgb '{}'\n", from.x(),
                             from.y(), to.x(), to.y(), head, arrow.size, shown_color(arrow.color, piece.is_hidden));
    }
  }
  std::string plot = "plot NaN notitle";
  if (!picture.is_empty()) plot += picture.plot();
  int blocks = 0;
  for (const bool hidden : {true, false}) {
    for (const Mark& line : lines_) {
      if (line.is_face && (hidden || !picture.is_empty())) continue;
      std::string points;
      for (const Piece& piece : line.is_face ? std::vector<Piece>{{line.points, false}} : picture.pieces(line.points)) {
        if (piece.is_hidden != hidden) continue;
        for (const Vector3d& point : piece.points) points += fmt::format("{:.5f} {:.5f}\n", point.x(), point.y());
        points += "\n";
      }
      if (points.empty()) continue;
      gnuplot << "$sketch" << blocks << " << e\n" << points << "e\n";
      const std::string color = shown_color(line.color, hidden);
      plot += fmt::format(", $sketch{} ", blocks++);
      plot += line.is_face ? fmt::format("with filledcurves closed fs transparent solid {} noborder lc rgb '{}'",
                                         line.size, color)
                           : fmt::format("with lines lw {} lc rgb '{}' {}", line.size, color, line.style);
    }
  }
  gnuplot << plot << "\n";
  if (!picture.is_empty()) gnuplot << picture.data();
}

SpaceCurve arc(const Vector3d& center, double radius, const Vector3d& first, const Vector3d& second, double from,
               double to) {
  constexpr int pieces = 72;
  SpaceCurve points;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = from + (to - from) * i / pieces;
    points.emplace_back(center + radius * (std::cos(angle) * first + std::sin(angle) * second));
  }
  return points;
}

}  // namespace workbook
