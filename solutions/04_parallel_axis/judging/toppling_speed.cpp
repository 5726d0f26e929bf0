#include "solutions/04_parallel_axis/shared.hpp"

#include <boost/math/quadrature/gauss.hpp>

/// How much the centre of mass rises until it stands above the edge.
static double rise_of_center(double length, double height) { return (hypot(length, height) - height) / 2; }

static double kinetic_energy_of(const VectorXd& m, const Matrix3Xd& velocities) {
  return velocities.colwise().squaredNorm().dot(m) / 2;
}

/// Eight masses in place of the block. Their angular momentum about the ridge gives the rotation after the blow, at
/// 1 m/s; its energy grows with the square of the speed.
static double by_eight_masses(double length, double height, double g) {
  const VectorXd m = VectorXd::Constant(8, 1. / 8);
  const Vector3d middle(-length / 2, 0, height / 2);
  const Matrix3Xd r = gauss_points_of_cuboid({length, 1, height}).colwise() + middle;
  double angular_momentum = 0, moment = 0;
  for (int p = 0; p < 8; ++p) {
    angular_momentum += m[p] * cross(r.col(p), x_axis).y();
    moment += m[p] * (r.col(p) - r(1, p) * y_axis).squaredNorm();
  }
  Matrix3Xd after(3, 8);
  for (int p = 0; p < 8; ++p) after.col(p) = angular_momentum / moment * cross(y_axis, r.col(p));
  return sqrt(g * rise_of_center(length, height) / kinetic_energy_of(m, after));
}

/// The impulse of the ridge brings the edge to rest; per mass and 1 m/s. The energy after the blow is König's sum.
static double by_impulse(double length, double height, double g) {
  const double gyration = (length * length + height * height) / 12;  // squared, about the centre of mass
  const Vector2d edge(length / 2, -height / 2);                      // from the centre of mass
  // Unknown: the impulse; rotation ω = (edge × impulse)/gyration, counted from x to z.
  const Vector2d across(-edge[1], edge[0]);  // the velocity of the edge for ω = 1
  const Eigen::Matrix2d mobility = Eigen::Matrix2d::Identity() + across * across.transpose() / gyration;
  const Vector2d impulse = mobility.inverse() * Vector2d(-1, 0);
  const Vector2d V = Vector2d(1, 0) + impulse;
  const double omega = across.dot(impulse) / gyration;
  return sqrt(g * rise_of_center(length, height) / ((V.squaredNorm() + gyration * omega * omega) / 2));
}

/// The work of gravity, integrated over the angle, in place of the height.
static double by_work_of_torque(double length, double height, double g) {
  using Gauss = boost::math::quadrature::gauss<double, 20>;
  const double arm = hypot(length, height) / 2, moment = 4 * arm * arm / 3, tilt = atan2(length, height);
  const double work = Gauss::integrate([&](double angle) { return g * arm * sin(angle); }, 0.0, tilt);
  return sqrt(2 * work * moment) / (height / 2);
}

void judge_toppling_speed(Lecture& lecture) {
  auto& e = lecture.exercise(&toppling_speed,
                             {{"length", positive(metre)}, {"height", positive(metre)}, {"g", positive(m_per_s2)}},
                             {"v", m_per_s});
  e.worked("a block of 0.3 m by 0.5 m", 0.3, 0.5, 9.81);
  e.special("a cube", 0.2, 0.2, 9.81);
  e.special("a flat plate", 1, 0.1, 9.81);
  e.special("a tall post", 0.1, 2, 9.81);
  e.special("a tiny block, hardly any gravity", 3e-12, 5e-12, 9.81e-14);
  e.special("a very flat plate", 1, 1e-3, 9.81);
  e.limit("a tall post", 0.1 * sqrt(2 * 9.81 / (3 * 2)),
          "Stopped at its foot a post keeps three quarters of its energy, and needs to be raised by length²/(4 height) "
          "only.");
  e.limit("a very flat plate", sqrt(9.81 * 4 / 3) * 1000,
          "A plate keeps only ¾ (height/length)² of its energy, and must be raised by half of its length.");
  e.random("a block", 10, [](Random& random) {
    const double height = random.uniform(0.1, 2), ratio = random.uniform(1.2, 4);
    return tuple(random.sign() > 0 ? height * ratio : height / ratio, height, random.uniform(1.6, 25));
  });
  e.sweep({"Blocks of height 0.2 m", "length along the motion (m)", "least speed (m/s)"}, {{"v"}}, {0.02, 0.6},
          [](auto length) { return tuple(length, 0.2, 9.81); });

  e.wrong("This is the speed that would do if no energy were lost in the blow.", "energy_kept",
          [](auto length, auto height, auto g) { return sqrt(2 * g * rise_of_center(length, height)); });
  e.wrong({"This is half of the right speed, as with the moment about the centre of mass in place of the one about the "
           "edge, or with the whole height as the lever of the momentum.",
           theorem_notes},
          "moment_about_center",
          [](auto length, auto height, auto g) { return toppling_speed(length, height, g) / 2; });
  e.wrong("The lever of the momentum is the height of the centre of mass; yours is its distance from the edge.",
          "diagonal_lever", [](auto length, auto height, auto g) {
            return toppling_speed(length, height, g) * height / hypot(length, height);
          });
  e.wrong_inputs("Length and height are exchanged.", "length_height_exchanged", first_two_exchanged);
  e.wrong(
      "This is twice the right speed, as with the moment about the edge in the blow and the one about the centre of "
      "mass in the energy.",
      "mixed_moments", [](auto length, auto height, auto g) { return 2 * toppling_speed(length, height, g); });
  e.wrong(
      "The impulse of the edge is level here; the centre of mass starts to rise in the blow, which takes an upward "
      "one too.",
      "level_impulse", [](auto length, auto height, auto g) {
        const double omega = sqrt(6 * g * rise_of_center(length, height)) / hypot(length, height);
        return omega * (pow(length, 2) + 4 * pow(height, 2)) / (6 * height);
      });
  e.wrong("The motion of the centre of mass counts twice in the energy here: the moment about the edge includes it.",
          "translation_twice",
          [](auto length, auto height, auto g) { return sqrt(4. / 7) * toppling_speed(length, height, g); });
  e.wrong("The centre of mass is raised by its height above the edge less the height that it has already.",
          "whole_height", [](auto length, auto height, auto g) {
            const auto diagonal = hypot(length, height);
            return sqrt(4. / 3 * g * diagonal) * diagonal / height;
          });
  e.property(Is::nonnegative, "A speed is never negative.");
  e.route("eight masses", by_eight_masses);
  e.route("the impulse of the ridge", by_impulse);
  e.route("work of the torque", by_work_of_torque);
  e.survivor("diagonal = std::hypot(", "Only the squares enter.");
}
