/// @file
/// Sketches of bodies and vectors, in the plane or in space, for figures that are no plots.
#pragma once

#include "lectures/support/figure.hpp"

#include <Eigen/Dense>

#include <array>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace workbook {

// What figures name often.
inline constexpr double pi = std::numbers::pi;
inline constexpr double degree = pi / 180;
inline const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
inline const Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX(), y_axis = Eigen::Vector3d::UnitY(),
                             z_axis = Eigen::Vector3d::UnitZ();
/// Of e₁, e₂ and e₃, as in live figures; ω is vermilion and L blue.
inline constexpr std::array<const char*, 3> axis_colors{colors::orange, colors::green, colors::purple};
inline constexpr const char* vertical_name = "{/:Bold e}@^0_3";
using PlaneCurve = std::vector<std::pair<double, double>>;
using SpaceCurve = std::vector<Eigen::Vector3d>;

/// Where a text stands at its place.
enum class Side { left, right, above, below, centre };

/// What is added first lies below; arrows, dots and texts lie above all lines and faces.
///
/// @code
/// Sketch sketch({1.0, -2.0, 0.8});                       // from where one looks; without it, the x–y plane
/// sketch.line(circle, colors::grey);
/// sketch.arrow(origin, tip, colors::blue, "{/:Bold L}");  // a vector is set in bold
/// sketch.draw(directory, "name", 560);
/// @endcode
class Sketch {
 public:
  explicit Sketch(const Eigen::Vector3d& towards = Eigen::Vector3d::UnitZ(),
                  const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ());

  /// @param style more words of gnuplot, such as "dt (4,4)"
  void line(const std::vector<Eigen::Vector3d>& points, const std::string& color, double width = 2,
            const std::string& style = "");
  /// A filled polygon; opacity from 0 to 1.
  void face(const std::vector<Eigen::Vector3d>& corners, const std::string& color, double opacity = 0.2);
  /// With a text at its tip. Arrows whose texts differ by the subscripts 1, 2 and 3 alone are the axes of a frame.
  /// @throws std::logic_error when they are left-handed.
  void arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const std::string& color,
             const std::string& text = "", Side side = Side::right, double width = 3);
  /// The edges of a box that starts at a corner, those that are hidden dashed; `edges` has the three edges as columns.
  void box(const Eigen::Vector3d& corner, const Eigen::Matrix3d& edges, bool shaded = false);
  /// An ellipsoid with its half axes as columns: its outline, and darker towards it, as if lit from above.
  void ellipsoid(const Eigen::Matrix3d& half_axes, const std::string& color,
                 const Eigen::Vector3d& center = Eigen::Vector3d::Zero());
  /// A line on it: the pieces that the reader sees, and those behind it thin and faint.
  void on_ellipsoid(const std::vector<Eigen::Vector3d>& points, const Eigen::Matrix3d& half_axes,
                    const std::string& color, double width, const Eigen::Vector3d& center = Eigen::Vector3d::Zero());
  /// A lit convex body of revolution that hides what was added before, between two points: its radii at these parts of
  /// the way, and discs where two parts are the same. Across the vector `wide`, if any, it is as much wider as that is long.
  void turned_body(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const PlaneCurve& profile,
                   const std::string& color, const Eigen::Vector3d& wide = Eigen::Vector3d::Zero());
  /// A lit box about a centre with the half edges as columns; each colour is that of the two faces across an edge.
  void lit_box(const Eigen::Vector3d& center, const Eigen::Matrix3d& half_edges,
               const std::array<const char*, 3>& face_colors);
  void dot(const Eigen::Vector3d& at, const std::string& color, double size = 0.8);
  void text(const Eigen::Vector3d& at, const std::string& text, const std::string& color = colors::black,
            Side side = Side::centre);

  const Eigen::Vector3d& towards() const { return towards_; }
  /// Does a surface with this outward normal face the reader?
  bool faces_reader(const Eigen::Vector3d& normal) const { return normal.dot(towards_) > 0; }

  /// Everything at the same scale in both directions; the height follows from the width in pixels.
  void draw(const std::filesystem::path& directory, const std::string& name, int width) const;
  /// The same as a part of something else, such as a frame of an animation; the scale follows from `half_width` in
  /// units of the sketch around its origin, so that frames do not jump.
  void send(gnuplotio::Gnuplot& gnuplot, FigureSize size, double half_width) const;

 private:
  using Point = std::pair<double, double>;

  Point project(const Eigen::Vector3d& point);
  /// Opaque, and the lighter, the more its outward normal points to the light: from above, from the left.
  void lit_face(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& normal, const std::string& color);
  void send(gnuplotio::Gnuplot& gnuplot, double x_min, double x_max, double y_min, double y_max) const;

  Eigen::Vector3d towards_, right_, up_;
  std::vector<std::pair<std::string, std::vector<Point>>> curves_;  ///< style and data of each
  struct Arrow {
    Point from, to;
    std::string style;
  };
  std::vector<Arrow> arrows_;
  std::map<std::string, std::map<int, Eigen::Vector3d>> frames_;  ///< axes so far, by text and subscript
  struct Text {
    Point at;
    std::string text, color;
    Side side;
  };
  std::vector<Text> texts_;
  std::string dots_;
  double x_min_ = 1e300, x_max_ = -1e300, y_min_ = 1e300, y_max_ = -1e300;
};

/// Points of a circle about `center` in the plane of two unit vectors; angles in radians.
std::vector<Eigen::Vector3d> arc(const Eigen::Vector3d& center, double radius, const Eigen::Vector3d& first,
                                 const Eigen::Vector3d& second, double from = 0, double to = 6.283185307179586);

}  // namespace workbook
