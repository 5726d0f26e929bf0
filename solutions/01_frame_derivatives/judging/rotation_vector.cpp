#include "solutions/01_frame_derivatives/shared.hpp"

static double cosine_of(const Matrix3d& E) { return clamp((E.trace() - 1) / 2, -1.0, 1.0); }

/// A rotation by an angle from this range, about any axis.
static auto turned_by(double from, double to) {
  return [=](Random& random) {
    const Vector3d axis = random.vector();
    return turn(axis, random.uniform(from, to));
  };
}

static void add_turns(auto& e) {
  const Vector3d axis = Vector3d(1, 2, 2) / 3;
  const auto a_turn = [](const Vector3d& v) { return turn(v, v.norm()); };
  const char* const arccosine = "Within 10⁻³ of half a turn an arccosine of the trace has seven digits.";
  e.worked("a turn by more than a right angle", a_turn({1.2, -0.7, 2.1}));
  e.worked("half a turn", 2 * dyad(axis) - Matrix3d::Identity());
  e.worked("a very small turn", a_turn(1e-9 * Vector3d(2, -1, 2)));
  e.special("no turn", Matrix3d::Identity());
  e.special("hardly a turn", a_turn(1e-13 * Vector3d(2, -1, 2)));
  e.special("half a turn about y", Matrix3d{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}});
  // Where the sine, and a series of one term, are no longer the angle.
  e.special("a turn by 0.0003", a_turn(1e-4 * Vector3d(2, -1, 2)));
  e.special("a turn by 0.003", a_turn(1e-3 * Vector3d(2, -1, 2)));
  e.special("a turn by 0.03", a_turn(1e-2 * Vector3d(2, -1, 2)));
  e.special("a quarter turn about z", Matrix3d{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}});
  e.special("a third of a turn", Matrix3d{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  e.special("just short of half a turn", turn(axis, pi - 1e-8));
  e.tolerance_of_last_case(1e-7, arccosine);
  e.special("somewhat less than half a turn", turn(axis, pi - 1e-5));
  e.tolerance_of_last_case(1e-7);
  e.special("two millionths less than half a turn", turn(axis, pi - 2e-6));
  e.tolerance_of_last_case(1e-7);
  e.special("beyond half a turn", turn(axis, pi + 1e-5));
  e.tolerance_of_last_case(1e-7);
  e.random("a random turn close to half a turn", 4, turned_by(pi - 1e-6, pi - 1e-9));
  e.tolerance_of_last_case(1e-7);
  e.random("a random small turn", 4, turned_by(1e-8, 1e-4));
  e.random("a random turn by less than a right angle", 4, turned_by(0.2, 1.4));
  e.random("a random turn by more than a right angle", 6, turned_by(1.7, 3));
  e.scale([](auto& E) { return or_one(rotation_vector(E).norm()); });
  // Closer to half a turn arccosines do not reach nine digits.
  e.generated([](auto& E) { return E.trace() > -1 + 1e-6; });
  e.sweep({"A turn about (1, 2, 2): beyond half a turn the way back is shorter", "angle turned (rad)",
           "component of the rotation vector (rad)"},
          {"x", "y", "z"}, {0, 2 * pi, 122}, [](auto angle) {
            return turn({1, 2, 2}, angle);
          });
}

void judge_rotation_vector(Lecture& lecture) {
  auto& e = lecture.exercise(&rotation_vector, {{"E", rotation}}, {"v", rad});
  e.compare(rotation_by_vector);
  add_turns(e);
  e.limit("no turn", zero, "Nothing has turned, and no axis is needed.");
  e.limit("a quarter turn about z", {0, 0, pi / 2},
          "Axis 1 has gone to axis 2, axis 2 to the reverse of axis 1, and axis 3 has stayed.");
  e.wrong("This is the axis times the sine of the angle; the angle itself is asked for.", "no_theta_over_sin",
          [](auto& E) { return axial_part(E); });
  e.wrong("The angle comes from its sine alone, which an angle shares with its supplement.", "asin", [](auto& E) {
    const Vector3d v = axial_part(E);
    return asin(min(v.norm(), 1.0)) * v.stableNormalized();
  });
  e.wrong_output(
      "Your vector has the wrong sign: it belongs to the way back, from the body's axes to the inertial ones.",
      "transposed", negated);
  e.wrong_output("This is the unit vector along the axis; its length should be the angle.", "axis_only",
                 [](auto& v) { return v.stableNormalized(); });
  e.wrong(
      "The axis comes from the antisymmetric part of E, which vanishes at half a turn; the symmetric part still has "
      "it.",
      "zero_at_half_turn", [](auto& E) {
        const Vector3d v = axial_part(E);
        return atan2(v.norm(), (E.trace() - 1) / 2) * v.stableNormalized();
      });
  e.wrong_output("Small angles have lost their digits: their cosine is rounded to 1; the sine still has the angle.",
                 "acos_digits", [](auto& v, auto& E) { v = acos(cosine_of(E)) * v.stableNormalized(); });
  e.wrong_output("This is half of the vector: the angle of a quaternion is half the angle of the rotation.",
                 "half_angle", times(0.5));
  e.wrong_output(
      "The antisymmetric part of E holds the axis with the sine of the angle as a factor; the sine is still in your "
      "axis.",
      "not_divided_by_sine", [](auto& v) -> Vector3d { return sin(v.norm()) * v; });
  e.wrong_output("The vector part of a quaternion is taken for the unit vector along the axis here; it is shorter.",
                 "vector_part", [](auto& v) -> Vector3d { return sin(v.norm() / 2) * v; });
  e.wrong_output("The angle is in degrees.", "degrees", times(1 / degree));
  e.route("by Eigen", [](auto& E) {
    const Eigen::AngleAxisd turned(E);
    return turned.angle() * turned.axis();
  });
  e.route("the axis as the vector that stays, the angle from one across it", [](auto& E) {
    const Matrix3d change = E - Matrix3d::Identity();
    const Eigen::JacobiSVD<Matrix3d> svd(change, Eigen::ComputeFullV);
    const Vector3d axis = svd.matrixV().col(2), across = axis.unitOrthogonal(), moved = change * across;
    return atan2(axis.dot(cross(across, moved)), 1 + across.dot(moved)) * axis;
  });
  e.route("the angle from |E − 1|, the axis from the diagonal where the turn is large", [](auto& E) {
    const Vector3d v = axial_part(E);
    const double sine_of_half = (E - Matrix3d::Identity()).norm() / sqrt(8);
    if (sine_of_half == 0) return zero;
    const double angle = 2 * atan2(sine_of_half, v.norm() / (2 * sine_of_half)), cosine = 1 - 2 * pow(sine_of_half, 2);
    if (cosine > -0.5) return angle * v.stableNormalized();
    Eigen::Index largest = 0;
    E.diagonal().maxCoeff(&largest);
    const Vector3d along = (E.col(largest) + E.row(largest).transpose()) / 2 - cosine * Vector3d::Unit(largest);
    const Vector3d axis = along / sqrt((E(largest, largest) - cosine) * (1 - cosine));
    return copysign(angle, axis.dot(v)) * axis;
  });
  e.survivor("if (cosine >= 0)", "At a quarter turn both formulas hold.");
  e.survivor("0 ? Vector3d(angle / sine * sine_axis)",
             "Angle and sine vanish together, and only their being 0 counts.");
  e.survivor("if (sine > 0)",
             "Beyond a quarter turn the long way holds for every angle, and before it the sine is that of the angle.");
  e.survivor("longest = 1", "It is set before it is used.");
  e.survivor("along.col(longest)", "The axis may have either sign here; the next line decides.");
  e.survivor("along.row(longest)", "The matrix is symmetric.");
  e.survivor("axis.dot(sine_axis)", "Only the sign counts, and at half a turn both signs of the axis are right.");
}
