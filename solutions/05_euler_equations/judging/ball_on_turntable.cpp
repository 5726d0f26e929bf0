#include "solutions/05_euler_equations/shared.hpp"

namespace {

Vector2d across(const Vector2d& v) { return {-v.y(), v.x()}; }

/// A circle in which the velocity turns at a rate of one's own, in complex numbers.
Vector2d circling(double rate, const Vector2d& start, const Vector2d& velocity, double t) {
  const std::complex v(velocity.x(), velocity.y());
  const auto moved = rate == 0 ? v * t : v * (polar(1.0, rate * t) - 1.0) / std::complex(0.0, rate);
  return start + Vector2d(moved.real(), moved.imag());
}

/// The same with a factor of the table's rate that depends on k.
template <class Factor>
auto at_rate(const Factor& factor) {
  return [factor](auto k, auto rate, auto& r, auto& v, auto t) { return circling(factor(k) * rate, r, v, t); };
}

/// Position and a ω, level parts. The lowest point goes with the table: v = a ω × ẑ + Ω ẑ × r. The contact force M v̇
/// has the torque −a ẑ × M v̇ = I ω̇ about the centre; with the rate of the condition, (1 + k) a ω̇ = Ω v.
Vector2d rolled(double k, double rate, const Vector2d& start, const Vector2d& velocity, double t) {
  using Ball = Eigen::Matrix2d;
  const Ball now = (Ball() << start, rate * start + across(velocity)).finished();
  const Ball end = followed(now, t, 1 + static_cast<int>(abs(rate * t) / 0.005), [&](const Ball& ball) {
    const Vector2d v = rate * across(ball.col(0)) - across(ball.col(1));
    return (Ball() << v, rate / (1 + k) * v).finished();
  });
  return end.col(0);
}

/// ṙ = (constant + Ω ẑ × r) k/(1 + k) with the constant of the start, by the exponential of its matrix.
Vector2d by_exponential(double k, double rate, const Vector2d& start, const Vector2d& velocity, double t) {
  Matrix3d motion = Matrix3d::Zero();
  motion.topLeftCorner<2, 2>() << 0, -rate, rate, 0;
  motion.topRightCorner<2, 1>() = (1 + 1 / k) * velocity - rate * across(start);
  const int halvings = 24;
  const Matrix3d X = motion * (k / (1 + k) * t / std::exp2(halvings));
  Matrix3d less_one = X + X * X / 2 + X * X * X / 6;
  for (int i = 0; i < halvings; ++i) less_one = 2 * less_one + less_one * less_one;
  return start + (less_one * Vector3d(start.x(), start.y(), 1)).head<2>();
}

}  // namespace

void judge_ball_on_turntable(Lecture& lecture) {
  auto& e = lecture.exercise(
      &ball_on_turntable,
      {{"k", positive(none)}, {"table_rate", rad_per_s}, {"start", metre}, {"velocity", m_per_s}, {"t", second}},
      {"position", metre});
  e.domain([](auto k, auto rate, auto&, auto&, auto t) { return k <= 2. / 3 && abs(rate * t) <= 60; });
  e.generated([](auto k, auto, auto&, auto&, auto) { return k > 1e-3; });
  const Vector2d start(0.4, -0.1), velocity(0.3, 0.5);
  e.worked("a solid ball on a record player", 0.4, 3.5, start, velocity, 4);
  e.worked("a table-tennis ball, the table clockwise", 2. / 3, -2, {-0.2, 0.3}, {0.1, -0.6}, 7.5);
  e.special("a table at rest", 0.4, 0, start, velocity, 4);
  e.special("a table that hardly turns", 0.4, 1e-7, start, velocity, 4);
  e.special("put down at rest", 0.4, 3.5, start, Vector2d::Zero(), 4);
  e.special("at rest relative to the table", 0.4, 3.5, start, {0.35, 1.4}, 2);
  e.special("on a circle about the middle", 0.4, 3.5, {0.4, 0}, {0, 0.4}, 4);
  e.special("after a full circle", 0.4, 3.5, start, velocity, 2 * pi);
  e.special("before time 0", 0.4, 3.5, start, velocity, -3);
  e.limit("a table at rest", start + 4 * velocity, "On a table at rest a ball rolls straight on.");
  e.limit("put down at rest", start,
          "The table turns the ball on the spot, steadily; so it needs no force, and stays.");
  e.random("a random ball", 10, [](Random& random) {
    const double k = random.uniform(0.2, 0.36), rate = random.sign() * random.uniform(1, 5);
    const Vector2d r = random.vector(0.5).head<2>(), v = random.vector(0.8).head<2>();
    return tuple(k, rate, r, v, random.sign() * random.uniform(1, 2.5) * (1 + 1 / k) / abs(rate));
  });
  e.tolerance(1e-7,
              "The answer may be integrated: a rule of fourth order with steps of 0.01 rad of the table is good to "
              "a hundred millionth.");
  e.scale([](auto, auto, auto& r, auto& v, auto t) { return or_one(r.norm() + v.norm() * abs(t)); });
  e.sweep<4>({"A solid ball on a table that makes a turn in 1.8 s", "time (s)", "position (m)"}, {"x", "y"}, {0, 8});

  e.wrong("Your ball circles with the table; its inertia against rotation and against displacement share the effect.",
          "table_rate", at_rate([](auto) { return 1; }));
  e.wrong("Your ball goes straight on, as on ice; the table drags its lowest point along.", "no_friction",
          at_rate([](auto) { return 0; }));
  e.wrong(
      "The effects of the force on centre and rim are subtracted; it pushes the one and slows down the other, so they "
      "add.",
      "minus_for_plus", at_rate([](auto k) { return k / (1 - k); }));
  e.wrong("Your rate is that of the table times k; the force rotates the ball, and it pushes its centre as well.",
          "only_rotation", at_rate([](auto k) { return k; }));
  e.wrong(
      "The shares of displacement and rotation are exchanged: yours lets a ball with its mass in the centre go round "
      "with the table.",
      "share_of_the_centre", at_rate([](auto k) { return 1 / (1 + k); }));
  e.wrong("Your ball circles against the table; the table drags it along.", "sense",
          at_rate([](auto k) { return -k / (1 + k); }));
  e.wrong_input<0>("Your ball is solid, whatever k is.", "always_solid", fixed(0.4));
  e.wrong_output(
      "These are components on axes that rotate with the table; asked for are those of an observer beside it.",
      "on_the_table",
      [](auto& r, auto, auto rate, auto&, auto&, auto t) -> Vector2d { return Eigen::Rotation2Dd(-rate * t) * r; });
  e.wrong_inputs("The velocity is taken as relative to the table; it is that for somebody beside the table.",
                 "velocity_on_the_table", [](auto, auto rate, auto& r, auto& v, auto) { v += rate * across(r); });
  e.wrong("Your circle is about the middle of the table; where its centre lies depends on the velocity.",
          "about_the_middle", [](auto k, auto rate, auto& r, auto&, auto t) -> Vector2d {
            return Eigen::Rotation2Dd(k / (1 + k) * rate * t) * r;
          });
  e.route("a circle in complex numbers", at_rate([](auto k) { return k / (1 + k); }));
  e.route("Newton's and Euler's laws with the force at the contact", rolled);
  e.route("the angular momentum about a point of the table", by_exponential);
}
