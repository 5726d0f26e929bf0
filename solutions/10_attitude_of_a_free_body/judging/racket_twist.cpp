#include "solutions/10_attitude_of_a_free_body/shared.hpp"

#include <boost/math/quadrature/gauss.hpp>

namespace {

const Vector3d racket(1.21e-3, 16.38e-3, 17.48e-3);

/// What is left of the component of ω along an axis when the axis goes round L.
double rate_about_axis(const Vector3d& I, const Vector3d& w, int axis) {
  return w[axis] - rate_about_L(I, w, axis) * L_of(I, w).normalized()[axis];
}

/// ∫ rate(ω) dt until ∫ clock(ω) dt = 2π, by Euler's equations with that clock.
template <class Rate, class Clock>
double in_a_round(const Vector3d& I, const Vector3d& w, const Rate& rate, const Clock& clock) {
  const Eigen::Vector4d start(w[0], w[1], w[2], 0);
  return followed(start, 2 * pi, 1000, [&](const Eigen::Vector4d& now) -> Eigen::Vector4d {
    const Vector3d omega = now.head<3>();
    Eigen::Vector4d change;
    change << free_rate(I, omega), rate(omega);
    return change / clock(omega);
  })[3];
}

double twist_about(const Vector3d& I, const Vector3d& w, int axis) {
  return in_a_round(
      I, w, [&](const Vector3d& now) { return rate_about_axis(I, now, axis); },
      [&](const Vector3d& now) { return rate_about_L(I, now, axis); });
}

/// From the attitude in time: handle and L are followed in small steps, and the last one is cut.
double by_attitude(const Vector3d& I, const Vector3d& w) {
  using State = Eigen::Matrix<double, 3, 4>;  // ω, then A
  const Vector3d up = L_of(I, w).normalized();
  State now = (State() << w, Matrix3d::Identity()).finished();
  double round = 0, twist = 0, step = 2 * pi / rate_about_L(I, w, 0) / 800;
  const auto angle = [](const Vector3d& before, const Vector3d& after, const Vector3d& axis) {
    const Vector3d across = cross(axis, before), then = cross(axis, after);
    return atan2(axis.dot(cross(across, then)), across.dot(then));
  };
  for (double more = 1; abs(2 * pi - round) > 1e-13 && more != 0;) {
    const State later = one_step_on(now, step, [&](const State& at) -> State {
      return (State() << free_rate(I, at.col(0)), at.rightCols<3>() * skew(at.col(0))).finished();
    });
    const Matrix3d A = now.rightCols<3>(), B = later.rightCols<3>();
    more = angle(A.col(0), B.col(0), up);
    if (round + more > 2 * pi + 1e-13) {
      step *= (2 * pi - round) / more;
      continue;
    }
    round += more;
    twist -= angle(A.transpose() * up, B.transpose() * up, x_axis);
    now = later;
  }
  return twist;
}

/// From elliptic functions: the time of the round by Newton's method, the angles by quadrature.
double by_elliptic_functions(const Vector3d& I, const Vector3d& w) {
  const ExactTop top(I, w);
  const auto until = [&](double time, const auto& rate) {
    constexpr int parts = 12;
    double sum = 0;
    for (int i = 0; i < parts; ++i)
      sum += boost::math::quadrature::gauss<double, 15>::integrate([&](double t) { return rate(top.omega(t)); },
                                                                   time * i / parts, time * (i + 1) / parts);
    return sum;
  };
  const auto round = [&](const Vector3d& now) { return rate_about_L(I, now, 0); };
  double time = 2 * pi / round(w);
  for (int i = 0; i < 8; ++i) time += (2 * pi - until(time, round)) / round(top.omega(time));
  return until(time, [&](const Vector3d& now) { return rate_about_axis(I, now, 0); });
}

}  // namespace

void judge_racket_twist(Lecture& lecture) {
  auto& e = lecture.exercise(&racket_twist, {{"I", ascending_moments}, {"omega0", nonzero(rad_per_s)}}, {"twist", rad});
  e.domain([](auto& I, auto& w) {
    const Vector3d L = L_of(I, w);
    return is_inertia_tensor(I.asDiagonal()) && 20 * I[0] >= I[2] && hypot(L[1], L[2]) >= 0.5 * L.norm();
  });
  // Where the twist is many turns, as of a thin rod, right steps must be shorter.
  e.generated([](auto& I, auto& w) { return abs(w[0]) * I[2] < 5 * L_of(I, w).norm(); });
  e.worked("a racket thrown a little off axis 2", racket, {-0.3, 10, 0.4});
  e.worked("the crate of the lecture", lecture_body, round_3);
  e.worked("the crate round axis 1", lecture_body, round_1);
  e.special("exactly about axis 2", racket, {0, 10, 0});
  e.special("off axis 2 by a tenth of a degree", racket, {0, 10, 0.0175});
  e.special("on the separatrix", {1, 2, 3}, {1, 1, std::sqrt(1 / 3.0)});
  e.special("two equal moments across the handle", {1, 2, 2}, {0.4, -0.9, 0.6});
  e.special("a flat body with equal moments about the handle and across it", {1, 1, 2}, {0.4, -0.9, 0.6});
  e.special("a sphere", {2, 2, 2}, {0.3, -0.2, 0.5});
  e.limit("exactly about axis 2", 0, "It rotates about axis 2 for ever, and shows no other face.");
  e.limit("two equal moments across the handle", 2 * pi * 0.4 / hypot(0.4, 1.8, 1.2),
          "The handle keeps its angle from L, and the body twists steadily, here I₂/I₁ − 1 = 1 times as fast as it "
          "goes round, times the cosine of that angle.");
  e.random("a racket", 6, [](Random& random) {
    const Vector3d I(random.uniform(1.2e-3, 1.8e-3), random.uniform(14e-3, 17e-3), random.uniform(17.2e-3, 18.1e-3));
    const double spin = random.sign() * random.uniform(8, 14);
    const Vector3d off(random.sign() * random.uniform(0.04, 0.2), 1, random.sign() * random.uniform(0.04, 0.2));
    return tuple{Vector3d(I[0], I[1], min(I[2], I[0] + I[1])), spin * off};
  });
  e.random("a body that tumbles", 6, [](Random& random) {
    while (true) {
      const Vector3d I = random.ascending_moments(), w = random.vector(2), L = L_of(I, w);
      if (hypot(L[1], L[2]) > 0.6 * L.norm()) return tuple{I, w};
    }
  });
  e.tolerance(1e-6, "The answer may be integrated in steps: a thousand steps of fourth order stay within a millionth.");
  e.scale([](auto& I, auto& w) { return max(1.0, abs(racket_twist(I, w))); });
  e.sweep<1>({"A racket thrown end over end with 10 rad/s, ω off axis 2 by 1° towards the handle",
              "ω off axis 2 towards the normal (rad)", "twist in one round of the handle (rad)"},
             {"twist"}, {-0.3, 0.3, 121}, [](auto off) { return Vector3d(10 * tan(degree), 10, 10 * tan(off)); });

  e.wrong({"This is the component of ω along the handle, integrated; a part of it belongs to the handle's way round L, "
           "which is not perpendicular to the handle.",
           "attitude_twist"},
          "omega_1", [](auto& I, auto& w) {
            return in_a_round(
                I, w, [](const Vector3d& now) { return now[0]; },
                [&](const Vector3d& now) { return rate_about_L(I, now, 0); });
          });
  e.wrong(
      "The motion stops here when the time of a turn at the first angular velocity is over; the handle goes round "
      "at another rate.",
      "time_for_angle", [](auto& I, auto& w) {
        return in_a_round(
            I, w, [&](const Vector3d& now) { return rate_about_axis(I, now, 0); },
            [&](const Vector3d&) { return w.norm(); });
      });
  e.wrong("The body rotates about L by one turn here, at the rate of ω along L; the handle goes round at another rate.",
          "turn_of_the_body", [](auto& I, auto& w) {
            return in_a_round(
                I, w, [&](const Vector3d& now) { return rate_about_axis(I, now, 0); },
                [&](const Vector3d& now) { return now.dot(L_of(I, now)) / L_of(I, now).norm(); });
          });
  e.wrong(
      "The motion stops here after the time of one turn about the middle axis alone; the handle goes round at another "
      "rate.",
      "time_of_middle_axis", [](auto& I, auto& w) {
        return in_a_round(
            I, w, [&](const Vector3d& now) { return rate_about_axis(I, now, 0); },
            [&](const Vector3d&) { return L_of(I, w).norm() / I[1]; });
      });
  e.wrong({"The twist grows here as fast as at the throw; but the disturbance grows in between.", "attitude_half_turn"},
          "first_rate", [](auto& I, auto& w) { return 2 * pi * rate_about_axis(I, w, 0) / rate_about_L(I, w, 0); });
  e.wrong_output("Seen from the body L goes round the handle, in the opposite sense to the twist: this is its angle.",
                 "of_L", negated);
  e.wrong(
      "This is the angle by which the direction of ω has gone round the handle; the plane to compare with is that "
      "of L.",
      "of_omega", [](auto& I, auto& w) {
        return in_a_round(
            I, w,
            [&](const Vector3d& now) {
              const Vector3d rate = free_rate(I, now);
              return (now[2] * rate[1] - now[1] * rate[2]) / (now[1] * now[1] + now[2] * now[2]);
            },
            [&](const Vector3d& now) { return rate_about_L(I, now, 0); });
      });
  e.wrong("This is the twist about axis 3 while axis 3 goes round; the handle is the axis of the smallest moment.",
          "axis_3", [](auto& I, auto& w) { return twist_about(I, w, 2); });
  e.wrong_output("The sense is lost: this is the size of the twist.", "size", [](auto& twist) { twist = abs(twist); });
  e.route("Euler's equations with the handle as the clock, by Runge and Kutta",
          [](auto& I, auto& w) { return twist_about(I, w, 0); });
  e.route("the attitude integrated, and handle and L followed", by_attitude);
  e.route("elliptic functions, and the time of a round by Newton's method", by_elliptic_functions);
  e.survivor("constexpr int steps", "More steps, or some fewer, reach the accuracy that is asked for.");
}
