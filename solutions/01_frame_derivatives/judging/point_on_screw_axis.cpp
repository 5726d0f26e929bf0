#include "solutions/01_frame_derivatives/shared.hpp"

void judge_point_on_screw_axis(Lecture& lecture) {
  auto& e = lecture.exercise(&point_on_screw_axis, {{"r", metre}, {"v", m_per_s}, {"omega", nonzero(rad_per_s)}},
                             {"point", metre});
  const Vector3d r0(1, 2, -1), v0(0.4, -0.3, 0.6);
  e.worked("the vectors of the lecture", r0, v0, example_omega);
  e.worked("a wheel rolls along x", {7, 0.5, 0}, {2, 0, 0}, {0, 0, -4});
  e.special("v along ω", r0, 3 * example_omega, example_omega);
  e.special("the point is at rest", r0, zero, example_omega);
  e.special("the point is the origin", zero, v0, example_omega);
  e.special("the origin lies on the line", 2 * example_omega, -3 * example_omega, example_omega);
  e.special("the point lies across ω", cross(example_omega, v0), v0, example_omega);
  e.special("a slow rotation", r0, v0, 1e-8 * example_omega);
  e.limit("a wheel rolls along x", {7, 0, 0},
          "The point of a rolling wheel that touches the ground is at rest for a moment.");
  e.limit("the origin lies on the line", zero,
          "The given point moves along ω, so it lies on the line, and the line through it along ω passes through the "
          "origin.");
  e.random("a random motion", 10, any::vector(2), any::vector(2), any::vector(2));
  e.scale([](auto& r, auto& v, auto& w) { return or_one(r.norm() + v.norm() / w.norm()); });
  e.sweep({"A wheel of radius 0.5 m whose hub moves at 2 m/s and that spins slowly (it skids) or fast (it slips)",
           "spin (rad/s)", "height of the axis above the ground (m)"},
          {{"height", 1}}, {1, 20}, [](auto spin) { return tuple(Vector3d(7, 0.5, 0), 2 * x_axis, -spin * z_axis); });

  e.wrong("This is a point of the line, but not the one nearest to the origin.", "not_nearest",
          [](auto& r, auto& v, auto& w) { return r + cross(w, v) / w.squaredNorm(); });
  e.wrong_input<1>("The line is on the other side of the given point: v enters with the wrong sign.", "sign", negated);
  e.wrong_input<0>("This is measured from the given point; it is asked for from the origin.", "r_forgotten",
                   fixed(zero));
  e.wrong_inputs(
      "The distance of the line from the given point has the wrong unit: the size of ω enters with the wrong power.",
      "not_squared", [](auto&, auto& v, auto& w) { v *= w.norm(); });
  e.wrong_input<0>("r enters with the wrong sign.", "r_negated", negated);
  e.wrong_input<1>("This is the line through the given point; its points move along ω only if v does.",
                   "through_the_point", fixed(zero));
  e.perpendicular_to(2, "The point of the line that is nearest to the origin is at right angles to ω.");
  e.route("linear equations", [](auto& r, auto& v, auto& w) {
    // n × p = n × r − v/ω apart from what is along n, and n (n·p) = 0 added.
    const Vector3d n = w.stableNormalized(), right = cross(n, r) - v / w.norm();
    return Vector3d((skew(n) + dyad(n)).inverse() * (right - n * n.dot(right)));
  });
  e.route("coordinates in the plane across the axis", [](auto& r, auto& v, auto& w) {
    const Vector3d x = w.unitOrthogonal(), y = cross(w.stableNormalized(), x);
    return Vector3d((r.dot(x) - v.dot(y) / w.norm()) * x + (r.dot(y) + v.dot(x) / w.norm()) * y);
  });
  e.route("along and across the axis", [](auto& r, auto& v, auto& w) {
    const Vector3d n = w.stableNormalized(), radius = cross(n, v) / w.norm();
    return r + radius - n * n.dot(r);
  });
}
