#include "solutions/03_inertia_tensor/shared.hpp"

#include <array>

/// Σ m (x, y) and Σ m z (x, y).
static Vector2d static_unbalance(const VectorXd& m, const Matrix3Xd& r) { return r.topRows<2>() * m; }
static Vector2d moment_of_unbalance(const VectorXd& m, const Matrix3Xd& r) {
  return r.topRows<2>() * m.cwiseProduct(r.row(2).transpose());
}

static Matrix3Xd in_planes(const Vector2d& in_first, const Vector2d& in_second, const Vector2d& planes) {
  return Matrix3Xd{{in_first[0], in_second[0]}, {in_first[1], in_second[1]}, {planes[0], planes[1]}};
}

static Matrix3Xd by_linear_system(const VectorXd& m, const Matrix3Xd& r, const Vector2d& planes, double correction) {
  const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
  Eigen::Matrix4d A;
  A << one, one, planes[0] * one, planes[1] * one;
  Eigen::Vector4d b;
  b << -static_unbalance(m, r), -moment_of_unbalance(m, r);
  const Eigen::Vector4d u = solution_of(A, b / correction);
  return in_planes(u.head<2>(), u.tail<2>(), planes);
}

/// The moment about one plane fixes the mass in the other.
static Matrix3Xd by_moments_about_each_plane(const VectorXd& m, const Matrix3Xd& r, const Vector2d& planes,
                                             double correction) {
  const auto correction_at = [&](double here, double other) -> Vector2d {
    Vector2d moment = Vector2d::Zero();
    for (int p = 0; p < m.size(); ++p) moment += m[p] * (r(2, p) - other) * r.col(p).head<2>();
    return moment / (correction * (other - here));
  };
  return in_planes(correction_at(planes[0], planes[1]), correction_at(planes[1], planes[0]), planes);
}

/// Centre of mass and products of inertia of the whole depend linearly on where the two masses sit: one Newton step.
static Matrix3Xd by_newton_step(const VectorXd& m, const Matrix3Xd& r, const Vector2d& planes, double correction) {
  const auto faults = [&](const Eigen::Vector4d& u) -> Eigen::Vector4d {
    VectorXd masses(m.size() + 2);
    masses << m, correction, correction;
    Matrix3Xd places(3, r.cols() + 2);
    places << r, in_planes(u.head<2>(), u.tail<2>(), planes);
    const Matrix3d I = inertia_of_points(masses, places);
    const Vector3d center = center_of_mass(masses, places);
    return {center.x() * masses.sum(), center.y() * masses.sum(), I(0, 2), I(1, 2)};
  };
  const Eigen::Vector4d start = faults(Eigen::Vector4d::Zero());
  Eigen::Matrix4d slopes;
  for (int i = 0; i < 4; ++i) slopes.col(i) = faults(Eigen::Vector4d::Unit(i)) - start;
  const Eigen::Vector4d u = -solution_of(slopes, start);
  return in_planes(u.head<2>(), u.tail<2>(), planes);
}

void judge_balance_rotor(Lecture& lecture) {
  auto& e = lecture.exercise(&balance_rotor,
                             {{"m", positive(kg)}, {"r", metre}, {"planes", metre}, {"correction", positive(kg)}},
                             {"positions", metre});
  e.domain([](auto& m, auto& r, auto& planes, auto) { return m.size() == r.cols() && planes[0] != planes[1]; });
  e.scale([](auto& m, auto& r, auto& planes, auto correction) -> Eigen::Matrix<double, 6, 1> {
    double across = 0;
    for (int p = 0; p < m.size(); ++p)
      across += m[p] * r.col(p).template head<2>().norm() * (planes.cwiseAbs().maxCoeff() + abs(r(2, p)));
    across = or_one(across / (correction * abs(planes[1] - planes[0])));
    const double along = planes.cwiseAbs().maxCoeff();
    return {across, across, along, across, across, along};
  });
  const VectorXd masses{{0.02, 0.03, 0.05}};
  const Matrix3Xd places{{0.1, -0.04, 0.03}, {0, 0.09, -0.06}, {0.05, 0.2, -0.1}};
  e.worked("three masses", masses, places, {-0.05, 0.25}, 0.04);
  e.special("balanced at rest, not in rotation", VectorXd{{0.1, 0.1}}, Matrix3Xd{{0.1, -0.1}, {0, 0}, {0, 0.3}},
            {0, 0.3}, 0.05);
  e.special("one mass in one of the planes", VectorXd{{0.1}}, Matrix3Xd{{0.02}, {0.03}, {0.1}}, {0, 0.1}, 0.1);
  e.special("balanced", VectorXd{{0.1, 0.1}}, Matrix3Xd{{0.1, -0.1}, {0, 0}, {0.2, 0.2}}, {0, 0.3}, 0.05);
  e.special("a tiny rotor", 1e-9 * masses, 1e-9 * places, {-5e-11, 2.5e-10}, 4e-11);
  e.special("no mass at all", VectorXd(0), Matrix3Xd(3, 0), {0.1, 0.3}, 0.05);
  e.limit("balanced", Matrix3Xd{{0, 0}, {0, 0}, {0, 0.3}},
          "Nothing is to be corrected, so both masses go onto the axis.");
  e.limit("one mass in one of the planes", Matrix3Xd{{0, -0.02}, {0, -0.03}, {0, 0.1}},
          "An equal mass opposite to it in its own plane is enough.");
  e.random("a rotor", 10, [](Random& random) {
    const int count = random.whole(2, 6);
    const double first = random.sign() * random.uniform(0.2, 0.6), gap = random.sign() * random.uniform(0.3, 1);
    return tuple(random.masses(count), random.points(count), Vector2d(first, first + gap), random.uniform(0.5, 2));
  });
  e.sweep({"Three masses; the second plane moves away from the first, at −0.05 m", "second plane, z (m)",
           "position of an added mass (m)"},
          {{"first, x", 0, 0}, {"second, x", 0, 1}, {"second, y", 1, 1}}, {0, 0.5},
          [=](auto z) { return tuple(masses, places, Vector2d(-0.05, z), 0.04); });

  e.wrong("The rotor is balanced at rest only: the axis is not a principal one, and the bearings feel the rotation.",
          "static_only", [](auto& m, auto& r, auto& planes, auto correction) {
            const Vector2d half = static_unbalance(m, r) / (-2 * correction);
            return in_planes(half, half, planes);
          });
  e.wrong_output("The added masses sit on the same side as the unbalance and double it.", "sign",
                 [](auto& positions) { positions.template topRows<2>() *= -1; });
  e.wrong_output("What belongs into the first plane stands in the second, and the other way round.", "planes_exchanged",
                 [](auto& u) { u.template topRows<2>() = u.template topRows<2>().rowwise().reverse().eval(); });
  e.wrong("The products of inertia vanish here, but the centre of mass stays off the axis.", "dynamic_only",
          [](auto& m, auto& r, auto& planes, auto correction) {
            const Vector2d pair = moment_of_unbalance(m, r) / (correction * (planes[1] - planes[0]));
            return in_planes(pair, -pair, planes);
          });
  e.wrong(
      "The levers are counted from the origin here; for the mass in one plane, that in the other exerts no moment "
      "about this other plane only.",
      "levers_from_origin", [](auto& m, auto& r, auto& planes, auto correction) {
        const Vector2d second = moment_of_unbalance(m, r) / (-correction * (planes[1] - planes[0]));
        return in_planes(Vector2d(-static_unbalance(m, r) / correction - second), second, planes);
      });
  e.wrong("Two equal masses against the force exert a moment as well, unless the planes are at ±z: it is missing.",
          "halves_and_couple", [](auto& m, auto& r, auto& planes, auto correction) {
            const Vector2d half = static_unbalance(m, r) / (-2 * correction);
            const Vector2d pair = moment_of_unbalance(m, r) / (correction * (planes[1] - planes[0]));
            return in_planes(Vector2d(half + pair), Vector2d(half - pair), planes);
          });
  e.wrong("The rotor counts as all its mass in the centre of mass; masses at different heights have a moment besides.",
          "mass_in_the_center", [](auto& m, auto& r, auto& planes, auto correction) {
            const Vector2d all = static_unbalance(m, r);
            const Vector2d moment = (m.size() > 0 ? center_of_mass(m, r).z() : 0) * all;
            const double apart = correction * (planes[0] - planes[1]);
            return in_planes((planes[1] * all - moment) / apart, (moment - planes[0] * all) / apart, planes);
          });
  e.wrong("Each mass is balanced in the plane that is nearer to it; a mass beside a plane also exerts a moment.",
          "distance_to_nearest", [](auto& m, auto& r, auto& planes, auto correction) {
            std::array<Vector2d, 2> sums{Vector2d::Zero(), Vector2d::Zero()};
            for (int p = 0; p < m.size(); ++p)
              sums[abs(r(2, p) - planes[0]) <= abs(r(2, p) - planes[1]) ? 0 : 1] -=
                  m[p] / correction * r.col(p).template head<2>();
            return in_planes(sums[0], sums[1], planes);
          });
  e.route("four linear equations", by_linear_system);
  e.route("moments about each plane", by_moments_about_each_plane);
  e.route("Newton's method on the inertia tensor", by_newton_step);
  e.survivor("positions.row(2)", "Eigen turns a column into a row when it is assigned to one.");
}
