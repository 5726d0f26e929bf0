#include "solutions/07_euler_angles/shared.hpp"

namespace {

/// 1 + [v] + [v]²/(1 + c)
Matrix3d turned_from_products(const Vector3d& v, double c) {
  return Matrix3d::Identity() + skew(v) + skew(v) * skew(v) / (1 + c);
}

double angle_from(const Vector3d& a, const Vector3d& b) { return atan2(cross(a, b).norm(), a.dot(b)); }

/// Mirrors in the plane across a vector.
Matrix3d mirror(const Vector3d& across) { return Matrix3d::Identity() - 2 * dyad(across.stableNormalized()); }

}  // namespace

void judge_shortest_rotation(Lecture& lecture) {
  auto& e = lecture.exercise(&shortest_rotation, {{"a", nonzero(none)}, {"b", nonzero(none)}}, {"D", none});
  e.domain([](auto& a, auto& b) { return angle_from(a.normalized(), b.normalized()) <= pi - 0.02; });
  e.worked("two oblique directions", {1, 2, -1}, {0.4, -0.3, 0.6});
  e.worked("nearly opposite", {1, 0, 0}, {-1, 0.01, 0.02});
  e.special("parallel", {0, 0, 2}, {0, 0, 5});
  e.special("equal", {0.3, -0.2, 0.5}, {0.3, -0.2, 0.5});
  e.special("a quarter turn about ê₃", {1, 0, 0}, {0, 3, 0});
  e.special("1e-5 apart", {0.3, -0.2, 0.5}, {0.3, -0.2 + 1e-5, 0.5});
  e.special("very long and very short", {1e80, 2e80, -1e80}, {4e-80, -3e-80, 6e-80});
  e.limit("parallel", Matrix3d::Identity(), "The directions agree already; lengths do not count.");
  e.limit("a quarter turn about ê₃", Matrix3d{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
          "From axis 1 to axis 2 the smallest rotation is that about axis 3.");
  e.random("any two directions", 8, [](Random& random) {
    Vector3d a = random.vector(3), b = random.vector(0.5);
    while (angle_from(a, b) > pi - 0.1 || angle_from(a, b) < 0.2) b = random.vector(0.5);
    return tuple(a, b);
  });
  e.scale(1);
  e.sweep({"From ê₁ to a direction that turns about (1, 1, 1)", "angle (rad)", "entry of D"},
          {{"D_11", 0, 0}, {"D_22", 1, 1}, {"D_33", 2, 2}}, {0, 2 * pi}, [](auto angle) {
            return tuple(x_axis, turn({1, 1, 1}, angle) * Vector3d(1, 0.3, 0));
          });

  e.wrong_output("This is the inverse: it carries b into a.", "transposed", transposed);
  e.wrong("This goes by azimuth and inclination: a comes to b, but by a longer way than about the normal of both.",
          "azimuth_and_inclination", [](auto& a, auto& b) {
            const auto aimed = [](auto& v) {
              return turn(z_axis, atan2(v.y(), v.x())) * turn(y_axis, atan2(hypot(v.x(), v.y()), v.z()));
            };
            return aimed(b) * aimed(a).transpose();
          });
  e.wrong("This is half a turn about the bisector of a and b; the angle between them is smaller.", "half_turn",
          [](auto& a, auto& b) -> Matrix3d { return -mirror(a.normalized() + b.normalized()); });
  e.wrong("The sum of two vectors halves the angle between them only if both are equally long.", "bisector_of_lengths",
          [](auto& a, auto& b) -> Matrix3d { return mirror(a + b) * mirror(a); });
  e.wrong("This is a reflection, with determinant −1; a rotation has +1.", "reflection",
          [](auto& a, auto& b) { return mirror(a.normalized() - b.normalized()); });
  e.wrong("The lengths of a and b enter; only the directions count.", "not_normalised",
          [](auto& a, auto& b) { return turned_from_products(cross(a, b), a.dot(b)); });
  e.wrong(
      "This is the first order in the angle, and the angle is finite.", "first_order",
      [](auto& a, auto& b) -> Matrix3d { return Matrix3d::Identity() + skew(cross(a.normalized(), b.normalized())); });
  e.wrong_output("Your rotation goes twice as far as b.", "double_angle", [](auto& D) { D *= Matrix3d(D); });
  e.property(Is::rotation_matrix, "A rotation matrix has orthonormal columns and determinant +1.");
  e.route("axis and angle", [](auto& a, auto& b) {
    const Vector3d u = a.normalized(), v = b.normalized();
    return turn(cross(u, v), angle_from(u, v));
  });
  e.route("two reflections",
          [](auto& a, auto& b) { return mirror(a.normalized() + b.normalized()) * mirror(a.normalized()); });
  e.route("quaternion from the bisector", [](auto& a, auto& b) {
    const Vector3d u = a.normalized(), half = (u + b.normalized()).normalized(), v = cross(u, half);
    return Quaterniond(u.dot(half), v.x(), v.y(), v.z()).toRotationMatrix();
  });
  e.route("two triads", [](auto& a, auto& b) -> Matrix3d {
    const Vector3d u = a.normalized(), v = b.normalized(), across = cross(u, v);
    if (across.norm() < 1e-12) return Matrix3d::Identity();
    const Vector3d n = across.normalized();
    return columns(v, n, cross(v, n)) * columns(u, n, cross(u, n)).transpose();
  });
}
