#include "solutions/01_frame_derivatives/shared.hpp"

static double longest_side(const Matrix3d& r) {
  return max({(r.col(1) - r.col(0)).norm(), (r.col(2) - r.col(1)).norm(), (r.col(0) - r.col(2)).norm()});
}

/// The part of ω across the side from point i to point k.
static Vector3d across_side(const Matrix3d& r, const Matrix3d& v, int i, int k) {
  const Vector3d side = r.col(k) - r.col(i);
  return cross(side, v.col(k) - v.col(i)) / side.squaredNorm();
}

/// A rigid body in motion: positions, and velocities v₀ + ω × r.
static auto moving(const Matrix3d& r, const Vector3d& v0, const Vector3d& omega) {
  return tuple{r, Matrix3d((skew(omega) * r).colwise() + v0)};
}

static void add_points_cases(auto& e) {
  const Matrix3d r0 = columns({1, 0.5, -0.2}, {0.3, 1.8, 0.4}, {-0.6, 0.2, 1.5});
  const Vector3d v0(1, -2, 0.5), side = r0.col(1) - r0.col(0), normal = cross(side, r0.col(2) - r0.col(0));
  const auto add = [&](auto kind, const char* name, const auto& motion) {
    std::apply([&](auto& r, auto& v) { (e.*kind)(name, r, v); }, motion);
  };
  using Added = std::remove_reference_t<decltype(e)>;
  const auto worked = &Added::worked, special = &Added::special;
  const Matrix3d far = r0.colwise() + Vector3d(800, -300, 500), right = columns({1, 1, 1}, {2, 1, 1}, {1, 2, 1});
  add(worked, "the triangle of the problem", moving(r0, v0, example_omega));
  add(special, "rotation about a side", moving(r0, v0, 0.4 * side));
  add(worked, "a right triangle rotates about a line in its plane", moving(right, zero, {1, 2, 0}));
  add(special, "translation only", moving(r0, {3, 0, 0}, zero));
  add(special, "rotation about z through the origin", moving(r0, zero, {0, 0, 2}));
  add(special, "rotation across the plane of the triangle", moving(r0, v0, normal));
  add(special, "at rest", moving(r0, zero, zero));
  add(special, "far from the origin", moving(far, v0, example_omega));
  add(special, "slow", moving(r0, v0 * 1e-8, example_omega * 1e-8));
  add(special, "a flat triangle", moving(columns(zero, {0.5, 0.15, 0}, {1, 0, 0}), v0, example_omega));
  e.random("a random triangle and motion", 10, [](Random& random) {
    const Matrix3d axes = random.rotation();
    const Vector3d a = random.vector(), b(random.uniform(0.7, 1.5), 0, 0);
    const Vector3d c(random.uniform(-0.5, 1), random.uniform(0.5, 1.5), 0);
    const Vector3d omega(random.vector(2)), v(random.vector(2));
    return moving(columns(a, a + axes * b, a + axes * c), v, omega);
  });
}

void judge_angular_velocity_from_three_points(Lecture& lecture) {
  auto& e = lecture.exercise(&angular_velocity_from_three_points, {{"r", metre}, {"v", m_per_s}}, {"omega", rad_per_s});
  e.domain([](auto& r, auto& v) {
    const double longest = longest_side(r);
    for (int i = 0; i < 3; ++i) {
      const Vector3d side = r.col((i + 1) % 3) - r.col(i), rate = v.col((i + 1) % 3) - v.col(i);
      if (abs(side.dot(rate)) > 1e-12 * longest * v.norm()) return false;
    }
    return cross(r.col(1) - r.col(0), r.col(2) - r.col(0)).norm() >= 0.1 * longest * longest;
  });
  add_points_cases(e);
  e.limit("translation only", zero, "All points have the same velocity: nothing rotates.");
  e.limit("rotation about z through the origin", {0, 0, 2},
          "No point moves along z, and each moves across its radius at 2 rad/s times its distance from the z axis.");
  // The velocities, not their differences, carry the rounding errors.
  e.scale([](auto& r, auto& v) { return or_one(v.norm() / longest_side(r)); });
  e.sweep({"A triangle in the x–y plane; ω of 1 rad/s tilts from its normal into its plane and on to the other side",
           "angle between ω and the normal (rad)", "component of ω (rad/s)"},
          {"x", "y", "z"}, {0, pi}, [](auto tilt) {
            return moving(columns({1, 0, 0}, {0, 1, 0}, {-1, -1, 0}), {1, -2, 0.5},
                          {0.6 * sin(tilt), 0.8 * sin(tilt), cos(tilt)});
          });

  e.wrong("This is what the side from the first to the second point shows; a rotation about this side is lost.",
          "one_edge", [](auto& r, auto& v) { return across_side(r, v, 0, 1); });
  e.wrong("This is what the side from the first to the third point shows; a rotation about this side is lost.",
          "other_edge", [](auto& r, auto& v) { return across_side(r, v, 0, 2); });
  e.wrong("This is the mean of what the three sides show; each lacks its own part of ω, and so does the mean.",
          "mean_of_edges", [](auto& r, auto& v) {
            return (across_side(r, v, 0, 1) + across_side(r, v, 1, 2) + across_side(r, v, 2, 0)) / 3;
          });
  e.wrong("This is the mean of what two sides show; each lacks its own part of ω, and so does the mean.",
          "mean_of_two_edges",
          [](auto& r, auto& v) { return (across_side(r, v, 0, 1) + across_side(r, v, 0, 2)) / 2; });
  e.wrong("This is half the sum of what the three sides show, as for three lines at right angles; these are not.",
          "half_sum_of_edges", [](auto& r, auto& v) {
            return (across_side(r, v, 0, 1) + across_side(r, v, 1, 2) + across_side(r, v, 2, 0)) / 2;
          });
  e.wrong(
      "Your sum is that for three unit vectors at right angles to each other; two sides of a triangle are oblique.",
      "oblique_axes", [](auto& r, auto& v) {
        const Vector3d a = r.col(1) - r.col(0), b = r.col(2) - r.col(0), n = cross(a, b),
                       n_rate = cross(v.col(1) - v.col(0), b) + cross(a, v.col(2) - v.col(0));
        return Vector3d((across_side(r, v, 0, 1) + across_side(r, v, 0, 2) + cross(n, n_rate) / n.squaredNorm()) / 2);
      });
  e.wrong("This is the rate at which the first point goes round the origin, as if the body rotated about the origin.",
          "translation_kept", [](auto& r, auto& v) { return cross(r.col(0), v.col(0)) / r.col(0).squaredNorm(); });
  e.wrong("The first point counts as at rest; ω shows in the differences of velocities too.", "first_point_at_rest",
          [](auto& r, auto& v) -> Vector3d {
            Matrix3d normal = Matrix3d::Zero();
            Vector3d sum = zero;
            for (const int k : {1, 2}) {
              const Vector3d side = r.col(k) - r.col(0), velocity = v.col(k);
              normal -= skew(side) * skew(side);
              sum += cross(side, velocity);
            }
            return normal.inverse() * sum;
          });
  e.wrong(
      "Positions and velocities themselves are taken, as if the origin were a point of the body at rest; ω shows in "
      "their differences from point to point.",
      "origin_at_rest", [](auto& r, auto& v) { return axial_part(v * r.inverse()); });
  e.wrong(
      "Positions and velocities themselves are taken, as if the origin were a point of the body at rest; ω shows in "
      "their differences from point to point.",
      "origin_at_rest_by_least_squares", [](auto& r, auto& v) -> Vector3d {
        const Matrix3d tensor = r.squaredNorm() * Matrix3d::Identity() - r * r.transpose(), L = r * v.transpose();
        return tensor.inverse() * axial(L.transpose() - L);
      });
  e.wrong("The angular momentum of three equal masses is divided by a number here; what takes ω to it is a tensor.",
          "momentum_over_squares", [](auto& r, auto& v) -> Vector3d {
            const Matrix3d x = r.colwise() - r.rowwise().mean(), u = v.colwise() - v.rowwise().mean();
            Vector3d sum = zero;
            for (int k = 0; k < 3; ++k) sum += cross(x.col(k), u.col(k));
            return sum / x.squaredNorm();
          });
  e.wrong_output("Your ω has the wrong sign: a line from one point of the body to another turns in the sense of ω.",
                 "sign", negated);
  const char* const vanishing = "This is a quotient whose two parts vanish when ω lies in the plane of the triangle.";
  const auto quotient = [](auto& r, auto& v) {
    const Vector3d rate = v.col(1) - v.col(0), other_rate = v.col(2) - v.col(0);
    return Vector3d(cross(rate, other_rate) / rate.dot(r.col(2) - r.col(0)));
  };
  e.wrong(vanishing, "quotient", quotient);
  e.wrong(vanishing, "quotient_or_zero", [=](auto& r, auto& v) -> Vector3d {
    const Vector3d rate = v.col(1) - v.col(0), side = r.col(2) - r.col(0);
    if (abs(rate.dot(side)) <= 1e-12 * rate.norm() * side.norm()) return zero;
    return quotient(r, v);
  });
  e.route("from L = I·ω of three equal masses about their center", [](auto& r, auto& v) {
    const Matrix3d c = r.colwise() - r.rowwise().mean(), squares = c * c.transpose(), moments = v * c.transpose();
    const Matrix3d I = squares.trace() * Matrix3d::Identity() - squares;
    return Vector3d(I.inverse() * axial(moments - moments.transpose()));
  });
  e.route("the matrix that takes three edges to their rates", [](auto& r, auto& v) {
    const Vector3d a = r.col(1) - r.col(0), b = r.col(2) - r.col(0), a_rate = v.col(1) - v.col(0),
                   b_rate = v.col(2) - v.col(0);
    const Matrix3d W =
        columns(a_rate, b_rate, cross(a_rate, b) + cross(a, b_rate)) * columns(a, b, cross(a, b)).inverse();
    return axial_part(W);
  });
  e.route("one side, and the rest from the third point", [](auto& r, auto& v) {
    const Vector3d a = r.col(1) - r.col(0), b = r.col(2) - r.col(0), seen = across_side(r, v, 0, 1);
    const Vector3d across = cross(a, b), left = v.col(2) - v.col(0) - cross(seen, b);
    return seen + a * (left.dot(across) / across.squaredNorm());
  });
  e.survivor("v.rowwise().mean()", "The x sum to zero, so a velocity common to all drops out.");
}
