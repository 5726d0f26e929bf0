#include "lectures/support/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <stdexcept>

namespace workbook {

using Eigen::Vector3d;

namespace {

/// About: without the marks of gnuplot's enhanced text, and with what an offset adds.
double width_in_pixels(const std::string& text) {
  const std::string shown = std::regex_replace(text, std::regex(R"(\{/[^ ]* |[{}_^]|[\x80-\xBF])"), "");
  return 9.0 * static_cast<double>(shown.size()) + 14;
}

}  // namespace

Sketch::Sketch(const Vector3d& towards, const Vector3d& up) : towards_(towards.normalized()) {
  // Seen along the z axis, y points up.
  const Vector3d vertical = up.cross(towards_).norm() < 1e-9 ? Vector3d(Vector3d::UnitY()) : up;
  right_ = vertical.cross(towards_).normalized();
  up_ = towards_.cross(right_);
}

Sketch::Point Sketch::project(const Vector3d& point) {
  const Point seen{point.dot(right_), point.dot(up_)};
  x_min_ = std::min(x_min_, seen.first);
  x_max_ = std::max(x_max_, seen.first);
  y_min_ = std::min(y_min_, seen.second);
  y_max_ = std::max(y_max_, seen.second);
  return seen;
}

void Sketch::line(const std::vector<Vector3d>& points, const std::string& color, double width,
                  const std::string& style) {
  std::vector<Point> curve(points.size());
  std::ranges::transform(points, curve.begin(), [&](const Vector3d& point) { return project(point); });
  curves_.emplace_back(fmt::format("with lines lw {} lc rgb '{}' {}", width, color, style), curve);
}

void Sketch::face(const std::vector<Vector3d>& corners, const std::string& color, double opacity) {
  std::vector<Point> curve(corners.size());
  std::ranges::transform(corners, curve.begin(), [&](const Vector3d& corner) { return project(corner); });
  curve.push_back(curve.front());
  curves_.emplace_back(
      fmt::format("with filledcurves closed fs transparent solid {} noborder lc rgb '{}'", opacity, color), curve);
}

void Sketch::arrow(const Vector3d& from, const Vector3d& to, const std::string& color, const std::string& label,
                   Side side, double width) {
  arrows_.push_back({project(from), project(to), fmt::format("front lw {} lc rgb '{}'", width, color)});
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

void Sketch::box(const Vector3d& corner, const Eigen::Matrix3d& edges, bool shaded) {
  for (int axis = 0; shaded && axis < 3; ++axis) {
    const Vector3d one = edges.col((axis + 1) % 3), other = edges.col((axis + 2) % 3);
    const Vector3d start = faces_reader(edges.col(axis)) ? Vector3d(corner + edges.col(axis)) : corner;
    face({start, start + one, start + one + other, start + other}, colors::grey, 0.2 + 0.15 * axis);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d along = edges.col(axis), one = edges.col((axis + 1) % 3), other = edges.col((axis + 2) % 3);
    for (int i = 0; i < 4; ++i) {
      const Vector3d start = corner + (i & 1) * one + (i >> 1 & 1) * other;
      // An edge is hidden when both of its faces look away.
      const bool visible = faces_reader((i & 1 ? 1 : -1) * one) || faces_reader((i >> 1 & 1 ? 1 : -1) * other);
      line({start, start + along}, visible ? colors::black : colors::grey, visible ? 2 : 1, visible ? "" : "dt (4,4)");
    }
  }
}

void Sketch::ellipsoid(const Eigen::Matrix3d& half_axes, const std::string& color, const Vector3d& center) {
  // The image of the unit ball: its outline is that of the circle across the image of the sight.
  const Vector3d pole = (half_axes.inverse() * towards_).normalized(), across = pole.unitOrthogonal();
  Vector3d light = half_axes.inverse() * (up_ - 0.7 * right_);
  light = 0.4 * (light - light.dot(pole) * pole).normalized();
  const auto ellipse = [&](double size) {
    std::vector<Vector3d> points;
    for (int i = 0; i <= 48; ++i) {
      const double angle = i * pi / 24;
      const Vector3d on_circle = std::cos(angle) * across + std::sin(angle) * pole.cross(across);
      points.emplace_back(center + half_axes * (size * on_circle + (1 - size) * light));
    }
    return points;
  };
  constexpr int rings = 10;
  for (int ring = 0; ring < rings; ++ring) {
    const double size = 1 - ring / static_cast<double>(rings);
    std::vector<Vector3d> shape = ellipse(size), inner = ellipse(size - 1.0 / rings);
    shape.insert(shape.end(), inner.rbegin(), inner.rend());
    face(shape, color, 0.06 + 0.36 * size * size * size);
  }
  line(ellipse(1), colors::grey, 1.5);
}

void Sketch::on_ellipsoid(const std::vector<Vector3d>& points, const Eigen::Matrix3d& half_axes,
                          const std::string& color, double width, const Vector3d& center) {
  const Eigen::Matrix3d to_ball = half_axes.inverse();
  const auto is_seen = [&](const Vector3d& point) {
    return faces_reader(to_ball.transpose() * (to_ball * (point - center)));
  };
  for (const bool seen : {false, true}) {
    std::vector<Vector3d> piece;
    const auto end_piece = [&] {
      if (piece.size() > 1) line(piece, seen ? color : colors::pale, seen ? width : width / 2);
      piece.clear();
    };
    for (const Vector3d& point : points) {
      if (is_seen(point) == seen || (!piece.empty() && is_seen(piece.back()) == seen)) piece.push_back(point);
      if (is_seen(point) != seen) end_piece();
    }
    end_piece();
  }
}

void Sketch::lit_face(const std::vector<Vector3d>& corners, const Vector3d& normal, const std::string& color) {
  const Vector3d light = (towards_ + 1.2 * up_ - 0.7 * right_).normalized();
  const double brightness = 0.5 + 0.5 * normal.normalized().dot(light);
  // Bright faces tend to white; all are the same on a dark page, as those of a lit body are.
  std::string shade = "#";
  for (std::size_t i = 1; i < 7; i += 2) {
    const double part = std::stoi(color.substr(i, 2), nullptr, 16);
    const double lit =
        brightness < 0.55 ? part * (0.5 + 0.9 * brightness) : part + (255 - part) * (brightness - 0.55) * 1.5;
    shade += fmt::format("{:02X}", std::clamp(static_cast<int>(lit), 0, 255));
  }
  std::vector<Point> curve(corners.size());
  std::ranges::transform(corners, curve.begin(), [&](const Vector3d& corner) { return project(corner); });
  curve.push_back(curve.front());
  curves_.emplace_back(fmt::format("with filledcurves closed fc rgb '{0}' fs solid 1 border lc rgb '{0}'", shade), curve);
}

void Sketch::turned_body(const Vector3d& from, const Vector3d& to, const PlaneCurve& profile,
                         const std::string& color, const Vector3d& wide) {
  const Vector3d axis = to - from, first = wide.isZero() ? axis.unitOrthogonal() : wide,
                 second = axis.cross(first).normalized();
  constexpr int pieces = 36;
  const auto radial = [&](double k, double width = 1) -> Vector3d {
    return std::cos(2 * pi * k / pieces) / width * first + std::sin(2 * pi * k / pieces) * second;
  };
  const auto point = [&](const std::pair<double, double>& at, int k) -> Vector3d {
    return from + at.first * axis + at.second * radial(k);
  };
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const auto &start = profile[i], &end = profile[i + 1];
    if (start.first == end.first) {  // a disc
      const auto& rim = std::max(start, end);
      std::vector<Vector3d> disc;
      for (int k = 0; k < pieces; ++k) disc.push_back(point(rim, k));
      const Vector3d normal = (start.second - end.second) * axis;
      if (faces_reader(normal)) lit_face(disc, normal, color);
      continue;
    }
    const double rise = (end.second - start.second) / axis.norm() / (end.first - start.first);
    for (int k = 0; k < pieces; ++k) {
      const Vector3d normal = radial(k + 0.5, first.squaredNorm()) - rise * axis.normalized();
      if (faces_reader(normal))
        lit_face({point(start, k), point(start, k + 1), point(end, k + 1), point(end, k)}, normal, color);
    }
  }
}

void Sketch::lit_box(const Vector3d& center, const Eigen::Matrix3d& half_edges,
                     const std::array<const char*, 3>& face_colors) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d one = half_edges.col((axis + 1) % 3), other = half_edges.col((axis + 2) % 3);
    const Vector3d outward =
        faces_reader(half_edges.col(axis)) ? half_edges.col(axis) : Vector3d(-half_edges.col(axis));
    const Vector3d middle = center + outward;
    lit_face({middle + one + other, middle - one + other, middle - one - other, middle + one - other}, outward,
             face_colors[static_cast<std::size_t>(axis)]);
  }
}

void Sketch::dot(const Vector3d& at, const std::string& color, double size) {
  const auto [x, y] = project(at);
  dots_ += fmt::format("set label '' at {:.5f},{:.5f} point pt 7 ps {} lc rgb '{}' front\n", x, y, size, color);
}

void Sketch::text(const Vector3d& at, const std::string& text, const std::string& color, Side side) {
  texts_.push_back({project(at), text, color, side});
}

void Sketch::draw(const std::filesystem::path& directory, const std::string& name, int width) const {
  double x_min = x_min_, x_max = x_max_, y_min = y_min_, y_max = y_max_, scale = 0;
  // Texts keep their size in pixels: how much room they take in units of the sketch follows step by step.
  for (int step = 0; step < 8; ++step) {
    scale = (x_max - x_min) / (width - 16.0);
    for (const Text& text : texts_) {
      const double reach = scale * width_in_pixels(text.text);
      const double left = text.side == Side::left ? reach : text.side == Side::right ? 0 : reach / 2;
      x_min = std::min(x_min, text.at.first - left);
      x_max = std::max(x_max, text.at.first + reach - left);
      y_min = std::min(y_min, text.at.second - scale * (text.side == Side::below ? 22 : 10));
      y_max = std::max(y_max, text.at.second + scale * (text.side == Side::above ? 22 : 10));
    }
  }
  const double margin = 8 * scale;
  const FigureSize size{width, static_cast<int>(std::lround((y_max - y_min) / scale)) + 16};
  draw_figure(directory, name, size, [&](gnuplotio::Gnuplot& gnuplot) {
    send(gnuplot, x_min - margin, x_max + margin, y_min - margin, y_max + margin);
  });
}

void Sketch::send(gnuplotio::Gnuplot& gnuplot, FigureSize size, double half_width) const {
  const double half_height = half_width * size.height / size.width;
  send(gnuplot, -half_width, half_width, -half_height, half_height);
}

void Sketch::send(gnuplotio::Gnuplot& gnuplot, double x_min, double x_max, double y_min, double y_max) const {
  gnuplot << "unset key; unset border; unset tics; unset grid\n"
             "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\n"
          << fmt::format("set xrange [{:.6f}:{:.6f}]; set yrange [{:.6f}:{:.6f}]\n", x_min, x_max, y_min, y_max)
          << dots_;
  for (const Text& text : texts_) {
    const char* place = text.side == Side::left    ? "right offset -0.8,0"
                        : text.side == Side::right ? "left offset 0.8,0"
                        : text.side == Side::above ? "center offset 0,0.7"
                        : text.side == Side::below ? "center offset 0,-0.7"
                                                   : "center";
    gnuplot << fmt::format("set label \"{}\" at {:.5f},{:.5f} {} front tc rgb '{}'\n", text.text, text.at.first,
                           text.at.second, place, text.color);
  }
  for (const Arrow& arrow : arrows_) {
    gnuplot << fmt::format("set arrow from {:.5f},{:.5f} to {:.5f},{:.5f} head filled size {:.5f},18 {}\n",
                           arrow.from.first, arrow.from.second, arrow.to.first, arrow.to.second,
                           0.026 * (x_max - x_min), arrow.style);
  }
  std::string plot = "plot NaN notitle";
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const std::string name = fmt::format("$sketch{}", k);
    send_block(gnuplot, name, curves_[k].second);
    plot += fmt::format(", {} {}", name, curves_[k].first);
  }
  gnuplot << plot << "\n";
}

std::vector<Vector3d> arc(const Vector3d& center, double radius, const Vector3d& first, const Vector3d& second,
                          double from, double to) {
  constexpr int pieces = 72;
  std::vector<Vector3d> points;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = from + (to - from) * i / pieces;
    points.emplace_back(center + radius * (std::cos(angle) * first + std::sin(angle) * second));
  }
  return points;
}

}  // namespace workbook
