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

/// Bodies have light, shade and depth, as in live figures (live/scene.js): what they hide of lines, arrows and dots is
/// faint. Of these, what is added first lies below; arrows, dots and texts lie above lines.
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
  void line(const SpaceCurve& points, const std::string& color, double width = 2, const std::string& style = "");
  /// A flat polygon; opacity from 0 to 1. Beside bodies one that is opaque hides what is behind it.
  void face(const SpaceCurve& corners, const std::string& color, double opacity = 0.2);
  /// With a text at its tip. Arrows whose texts differ by the subscripts 1, 2 and 3 alone are the axes of a frame.
  /// @throws std::logic_error when they are left-handed.
  void arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const std::string& color,
             const std::string& text = "", Side side = Side::right, double width = 3);
  /// The edges of a box that starts at a corner, those at its back dashed; `edges` has the three edges as columns.
  void box(const Eigen::Vector3d& corner, const Eigen::Matrix3d& edges);
  /// A body in the shape of a box, about a centre with the half edges as columns; each colour is that of the two faces
  /// across an edge.
  void solid_box(const Eigen::Vector3d& center, const Eigen::Matrix3d& half_edges,
                 const std::array<const char*, 3>& face_colors);
  /// An ellipsoid with its half axes as columns. One sees through bodies whose opacity is below 1; lines in them are
  /// faint.
  void ellipsoid(const Eigen::Matrix3d& half_axes, const std::string& color,
                 const Eigen::Vector3d& center = Eigen::Vector3d::Zero(), double opacity = 1);
  /// A body of revolution between two points: its radii at these parts of the way, and discs where two parts are the
  /// same. Across the vector `wide`, if any, it is as much wider as that is long.
  void turned_body(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const PlaneCurve& profile,
                   const std::string& color, const Eigen::Vector3d& wide = Eigen::Vector3d::Zero(), double opacity = 1);
  /// A ring of a round bar about a centre.
  void ring(const Eigen::Vector3d& center, const Eigen::Vector3d& axis, double radius, double thickness,
            const std::string& color);
  void dot(const Eigen::Vector3d& at, const std::string& color, double size = 0.8);
  /// Where others stand already, as far away on the page, to the right and up, with a thin line from there.
  void text(const Eigen::Vector3d& at, const std::string& text, const std::string& color = colors::black,
            Side side = Side::centre, const Eigen::Vector2d& away = Eigen::Vector2d::Zero());

  /// Whether from now on nothing hides what is drawn.
  void in_front(bool is_in_front) { forward_ = is_in_front ? 1e3 : 0; }

  /// On the page, to the right and up, and towards the reader.
  Eigen::Vector3d right() const { return view_.row(0); }
  Eigen::Vector3d up() const { return view_.row(1); }
  Eigen::Vector3d towards() const { return view_.row(2); }

  /// Everything at the same scale in both directions; the height follows from the width in pixels. What is in space is
  /// described in the picture too, so that on a page one can turn it (live/scene.js): not where several pictures stand
  /// in a row, or a live figure in its place.
  void draw(const std::filesystem::path& directory, const std::string& name, int width, bool turns = true) const;
  /// The same as a part of something else; the scale follows from `half_width` in units of the sketch around its
  /// origin.
  void send(gnuplotio::Gnuplot& gnuplot, FigureSize size, double half_width) const;

 private:
  class Picture;
  using Range = Eigen::AlignedBox2d;

  /// In coordinates to the right, up, and towards the reader, as all that is kept.
  Eigen::Vector3d seen(const Eigen::Vector3d& point);
  SpaceCurve seen(SpaceCurve points);
  /// A piece of a body's surface, flat or nearly so, with a normal in each corner.
  void piece(const SpaceCurve& corners, const SpaceCurve& normals, const Eigen::Vector3d& rgb, double opacity);
  /// Round the third of these axes, with places along it and radii.
  void turned(const PlaneCurve& profile, const Eigen::Matrix3d& axes, const Eigen::Vector3d& center,
              const std::string& color, double whiteness, double opacity);
  void send(gnuplotio::Gnuplot& gnuplot, const Range& range, const Picture& picture) const;
  /// For the description: a call of live/scene.js with these points between its other words.
  void describe(const std::string& before, const SpaceCurve& points, const std::string& after);
  std::string description(const Range& range) const;

  Eigen::Matrix3d view_;
  Eigen::Matrix3d upright_;  ///< to coordinates whose third axis points up and whose first is level, towards the reader
  double forward_ = 0;
  Eigen::Vector3d light_;
  Range range_;
  struct Facet {
    SpaceCurve corners, normals;
    Eigen::Vector3d rgb;
    double opacity;
    bool hides_lines = true;
  };
  std::vector<Facet> bodies_;
  struct Mark {
    SpaceCurve points;
    std::string color;
    double size;  ///< the width of a line or an arrow, the opacity of a face, the size of a dot
    std::string style;
    bool is_face = false;
  };
  std::vector<Mark> lines_, arrows_, dots_;
  std::map<std::string, std::map<int, Eigen::Vector3d>> frames_;  ///< axes so far, by text and subscript
  struct Text {
    Eigen::Vector3d at;
    std::string text, color;
    Side side;
  };
  std::vector<Text> texts_;
  struct Call {
    std::string before;
    SpaceCurve points;
    Eigen::Matrix3d axes;  ///< after the points; zero for none
    std::string after;
  };
  std::vector<Call> calls_;
  SpaceCurve places_of_texts_;
};

/// Points of a circle about `center` in the plane of two unit vectors; angles in radians.
SpaceCurve arc(const Eigen::Vector3d& center, double radius, const Eigen::Vector3d& first,
               const Eigen::Vector3d& second, double from = 0, double to = 6.283185307179586);

}  // namespace workbook
