#include "solutions/09_heavy_top/shared.hpp"

namespace {

constexpr double low_orbit = 2 * pi / 5550;

/// The ratios that decide, and the two coefficients of the quadratic equation for the squares across the orbit.
struct Ratios {
  explicit Ratios(const Vector3d& I)
      : pitch((I[1] - I[0]) / I[2]), roll((I[2] - I[0]) / I[1]), yaw((I[2] - I[1]) / I[0]) {}
  double pitch, roll, yaw;
  double sum() const { return 1 + 3 * roll + roll * yaw; }
  double product() const { return 4 * roll * yaw; }
  double apart() const { return sqrt(max(sum() * sum() - 4 * product(), 0.0)); }
};

bool is_held(const Vector3d& I, double margin) {
  const Ratios k(I);
  return is_inertia_tensor(I.asDiagonal()) && 3 * k.pitch >= margin && k.product() > 0 && k.sum() > 0 &&
         k.sum() * k.sum() > 4 * k.product() && k.apart() >= margin && (k.sum() - k.apart()) / 2 >= margin;
}

/// The rates of a small turn from the attitude (as a rotation vector on the axes of the orbit) and of ω on the axes of
/// the body, at an orbital rate of 1.
Eigen::Matrix<double, 6, 1> rates(const Vector3d& I, const Eigen::Matrix<double, 6, 1>& now) {
  const Vector3d turned = now.head<3>(), omega = now.tail<3>();
  const Matrix3d A = turn(turned, turned.norm());
  const Vector3d s = A.transpose() * x_axis, normal = A.transpose() * z_axis;
  const Vector3d torque = 3 * cross(s, I.cwiseProduct(s));
  // The rate of a rotation vector v, for ω relative to the orbit: ω + v × ω/2 + v × (v × ω)/12 up to fourth order
  const Vector3d relative = omega - normal;
  const Vector3d first = cross(turned, relative);
  Eigen::Matrix<double, 6, 1> rate;
  rate << relative + first / 2 + cross(turned, first) / 12,
      (torque - cross(omega, I.cwiseProduct(omega))).cwiseQuotient(I);
  return rate;
}

/// The three frequencies of the linearised motion: that in the plane, and those across it, whose squares are the
/// eigenvalues of −J², each of them twice.
Vector3d by_linearised_motion(const Vector3d& I) {
  using Motion = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> J;
  Motion held = Motion::Zero();
  held[5] = 1;
  for (int i = 0; i < 6; ++i)
    J.col(i) = derivative_at_0([&](double h) -> Motion { return rates(I, held + h * Motion::Unit(i)); }, 5e-3);
  const double in_plane = sqrt(-J(2, 5) * J(5, 2));
  Eigen::Matrix4d across;
  constexpr int kept[] = {0, 1, 3, 4};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) across(i, j) = J(kept[i], kept[j]);
  const double half_sum = -(across * across).trace() / 4, product = across.determinant();
  const double larger = half_sum + sqrt(half_sum * half_sum - product);
  return {in_plane, sqrt(product / larger), sqrt(larger)};
}

/// From the Lagrangian of small angles: the determinant of K − σ² M + iσ G, searched for its zeros.
Vector3d by_determinant(const Vector3d& I) {
  const double g = I[0] + I[1] - I[2], k1 = I[2] - I[1], k2 = 4 * (I[2] - I[0]);
  const auto determinant = [&](double square) { return (k1 - I[0] * square) * (k2 - I[1] * square) - g * g * square; };
  const double least = (k1 * I[1] + k2 * I[0] + g * g) / (2 * I[0] * I[1]);  // where the parabola is lowest
  const auto zero_between = [&](double below, double above) {
    const bool sign = determinant(below) > 0;
    for (int i = 0; i < 200; ++i) {
      const double middle = (below + above) / 2;
      ((determinant(middle) > 0) == sign ? below : above) = middle;
    }
    return sqrt((below + above) / 2);
  };
  return {sqrt(3 * (I[1] - I[0]) / I[2]), zero_between(0, least), zero_between(least, 100)};
}

/// In the plane the curvature of the potential energy over the moment, across it the roots as sums and products.
Vector3d by_sum_and_product(const Vector3d& I) {
  const auto potential = [&](double angle) {  // 3/2 s·I s, for a turn about the normal
    return 1.5 * (I[0] * pow(cos(angle), 2) + I[1] * pow(sin(angle), 2));
  };
  constexpr double h = 0.1;  // it is a + b cos 2α: this difference is exact
  const double curvature = (potential(h) - 2 * potential(0) + potential(-h)) / pow(sin(h), 2);
  const Ratios k(I);
  const double root = sqrt(k.product()), sum = sqrt(k.sum() + 2 * root), difference = sqrt(k.sum() - 2 * root);
  return {sqrt(curvature / I[2]), 2 * root / (sum + difference), (sum + difference) / 2};
}

}  // namespace

void judge_attitude_frequencies(Lecture& lecture) {
  auto& e = lecture.exercise(&attitude_frequencies, {{"I", positive(kg_m2)}, {"orbital_rate", positive(rad_per_s)}},
                             {"frequencies", rad_per_s});
  e.domain([](auto& I, auto) { return is_held(I, 1e-7); });
  e.generated([](auto& I, auto) { return is_held(I, 0.02); });
  e.worked("a small satellite with a boom", {2, 20, 21}, low_orbit);
  e.worked("moments 2, 3, 4", {2, 3, 4}, low_orbit);
  e.special("nearly a rod", {0.1, 20, 20.05}, low_orbit);
  e.worked("the Moon", {0.99937, 0.9996, 1}, 2 * pi / (27.32 * 86400));
  e.special("a plate edge on to the orbit", {1, 2, 3}, low_orbit);
  e.special("the smallest moment along the normal", {0.75, 1, 0.7}, low_orbit);
  e.limit("nearly a rod", low_orbit * Vector3d(sqrt(3), sqrt(0.5), 2),
          "A rod swings √3 times in an orbit in the plane and twice across it, as two masses on a string do; about "
          "itself it is carried round once, which gives √((I₃ − I₂)/I₁).");
  e.limit("a plate edge on to the orbit", low_orbit * Vector3d(1, 1, 2),
          "In the plane the tide holds it a third as strongly as a rod. Across the plane its forward axis returns as a "
          "free particle does, once in an orbit; at its radial axis the tide also pulls, 3 n² beside n².");
  e.random("a satellite", 8, [](Random& random) {
    return tuple{random.ascending_moments(), random.uniform(5e-4, 2e-3)};
  });
  e.random("the smallest moment along the normal", 3, [](Random& random) {
    while (true) {
      const double rate = random.uniform(5e-4, 2e-3);
      const Vector3d I(random.uniform(0.75, 0.99), 1, random.uniform(0.1, 0.9));
      if (is_held(I, 0.02)) return tuple{I, rate};
    }
  });
  e.scale([](auto& I, auto n) { return attitude_frequencies(I, n); });
  e.sweep({"Moments 2, 3 kg m² radial and forward, in a low orbit", "moment along the normal (kg m²)",
           "angular frequency (rad/s)"},
          {"in the plane", "across, slow", "across, fast"}, {3.02, 5, 100},
          [](auto normal) { return tuple(Vector3d(2, 3, normal), low_orbit); });

  const char* const not_coupled =
      "The two swings across the plane do not know of each other here; the rotation of the orbit couples them.";
  const auto without_coupling = [](auto& I, auto n, double roll, double yaw) {
    return n * Vector3d(sqrt(3 * Ratios(I).pitch), min(2 * sqrt(roll), sqrt(yaw)), max(2 * sqrt(roll), sqrt(yaw)));
  };
  e.wrong(not_coupled, "not_coupled",
          [=](auto& I, auto n) { return without_coupling(I, n, abs(Ratios(I).roll), abs(Ratios(I).yaw)); });
  e.wrong(not_coupled, "not_coupled_no_number",
          [=](auto& I, auto n) { return without_coupling(I, n, Ratios(I).roll, Ratios(I).yaw); });
  e.wrong(not_coupled, "not_coupled_or_zero",
          [=](auto& I, auto n) { return without_coupling(I, n, max(0.0, Ratios(I).roll), max(0.0, Ratios(I).yaw)); });
  e.wrong("The frame turns with the orbit; your swings across the plane are those under the torque alone.",
          "frame_at_rest", [](auto& I, auto n) {
            const Ratios k(I);
            return n * Vector3d(sqrt(3 * k.pitch), 0, sqrt(3 * abs(k.roll)));
          });
  e.wrong_output(
      "In the plane a factor is missing: the torque of gravity has a three, that of the pull and of its "
      "direction.",
      "no_three", [](auto& sigma) { sigma[0] /= sqrt(3); });
  e.wrong("Across the plane the torque has its three, but the turning frame adds nothing to it.", "three_for_four",
          [](auto& I, auto n) {
            const Ratios k(I);
            const double sum = 3 * k.roll + k.yaw + (1 - k.roll) * (1 - k.yaw), product = 3 * k.roll * k.yaw;
            const double root = sqrt(max(sum * sum - 4 * product, 0.0));
            return n * Vector3d(sqrt(3 * k.pitch), sqrt(2 * product / (sum + root)), sqrt((sum + root) / 2));
          });
  e.wrong("Across the plane the turning frame alone acts here; the torque of gravity counts too.", "frame_alone",
          [](auto& I, auto n) {
            const Ratios k(I);
            const double sum = 1 + k.roll * k.yaw, root = sqrt(abs(sum * sum - 4 * k.roll * k.yaw));
            return n * Vector3d(sqrt(3 * k.pitch), sqrt(abs(sum - root) / 2), sqrt((sum + root) / 2));
          });
  e.wrong(
      "The torque of gravity has a three, that of the pull and of its direction; it is missing in the plane and "
      "across.",
      "no_three_anywhere", [](auto& I, auto n) {
        const Ratios k(I);
        const double sum = k.yaw + 2 * k.roll + (1 - k.roll) * (1 - k.yaw), product = 2 * k.roll * k.yaw;
        const double root = sqrt(max(sum * sum - 4 * product, 0.0));
        return n * Vector3d(sqrt(k.pitch), sqrt(2 * product / (sum + root)), sqrt((sum + root) / 2));
      });
  e.wrong_output("Across the plane the faster swing stands first; the slower one is asked for first.", "order",
                 exchange(1, 2));
  e.wrong_output("These are the squares of the frequencies.", "squares",
                 [](auto& sigma) { sigma = sigma.cwiseAbs2().eval(); });
  e.wrong_output("These are in swings per second; radians per second are asked for.", "per_second", times(0.5 / pi));
  e.property(Is::nonnegative, "A frequency is not negative.");
  e.route("the equations of motion, linearised by differences",
          [](auto& I, auto n) { return n * by_linearised_motion(I); });
  e.route("zeros of the determinant", [](auto& I, auto n) { return n * by_determinant(I); });
  e.route("curvature of the potential energy, and sum and product of the roots",
          [](auto& I, auto n) { return n * by_sum_and_product(I); });
}
