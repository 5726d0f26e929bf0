#include "rigid/eigen.hpp"
#include "solutions/judging/judging.hpp"

using namespace rigid;

void judge_rotation_about_z(Lecture& lecture) {
  auto& e = lecture.exercise(&rotation_about_z, {{"angle", rad}}, {"R", none});
  e.worked("30 degrees", pi / 6);
  e.special("no rotation", 0);
  e.special("a quarter of a turn", pi / 2);
  e.special("half a turn", pi);
  e.random("an angle", 6, any::spin(0.3, 3));
  e.scale(1.0);
  e.sweep({"The first row", "angle (rad)", "entry of R"}, {{"row x, column x", 0, 0}, {"row x, column y", 0, 1}},
          {-pi, pi}, [](auto angle) { return angle; });
  e.limit("a quarter of a turn", Matrix3d{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, "x goes to y, and y to −x.");

  e.wrong_input<0>("Your matrix rotates from y towards x: the minus belongs to row x, column y.", "other_sense",
                   [](auto angle) { return -angle; });
  e.wrong_input<0>("Sine and cosine take radians: do not divide by 180, the angle comes in radians.", "degrees",
                   [](auto angle) { return angle * pi / 180; });
  e.wrong("Sine and cosine have changed places.", "exchanged", [](auto angle) {
    return Matrix3d{{sin(angle), -cos(angle), 0}, {cos(angle), sin(angle), 0}, {0, 0, 1}};
  });
  e.wrong("Your matrix has no minus sign.", "no_minus", [](auto angle) {
    return Matrix3d{{cos(angle), sin(angle), 0}, {sin(angle), cos(angle), 0}, {0, 0, 1}};
  });
  e.wrong_output("The 1 in the corner is missing: z stays as it is.", "no_corner", [](auto& R) { R(2, 2) = 0; });
  e.property(Is::rotation_matrix, "A rotation keeps lengths, right angles and handedness.");
  e.route("an axis and an angle",
          [](auto angle) { return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix(); });
  e.route("columns", [](auto angle) {
    return columns(cos(angle) * x_axis + sin(angle) * y_axis, cos(angle) * y_axis - sin(angle) * x_axis, z_axis);
  });
  e.route("entry by entry", [](auto angle) {
    Matrix3d R = Matrix3d::Identity();
    R(0, 0) = R(1, 1) = cos(angle);
    R(1, 0) = sin(angle);
    R(0, 1) = -R(1, 0);
    return R;
  });
}
