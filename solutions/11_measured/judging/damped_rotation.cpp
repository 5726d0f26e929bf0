#include "solutions/11_measured/shared.hpp"

#include <fmt/format.h>

namespace {

/// The time of a free motion that has come as far.
double free_time(double gamma, double t) { return gamma * t == 0 ? t : -std::expm1(-gamma * t) / gamma; }

Vector3d exact(const Vector3d& I, const Vector3d& omega0, double gamma, double t) {
  return std::exp(-gamma * t) * ExactTop(I, omega0).omega(free_time(gamma, t));
}

int steps_for(const Vector3d& omega0, double t) { return 1 + static_cast<int>(t * max(omega0.norm(), 1.0) / 0.01); }

}  // namespace

void judge_damped_rotation(Lecture& lecture) {
  auto& e = lecture.exercise(
      &damped_rotation,
      {{"I", positive(kg_m2)}, {"omega0", rad_per_s}, {"gamma", not_negative(per_s)}, {"t", not_negative(second)}},
      {"omega", rad_per_s});
  // The expected numbers are exact: elliptic functions, no integration.
  e.judge_by(exact);
  // Right integrators take steps of their own choice; what turns fast or for long is beyond some of them.
  e.generated([](auto& I, auto& omega0, auto gamma, auto t) {
    return I.maxCoeff() < 10 * I.minCoeff() && omega0.norm() < 5 && t < 20 && omega0.norm() * t < 40 && gamma * t < 20;
  });
  e.worked("moments 1, 2, 3 in air", {1, 2, 3}, {0.1, 1, 0.1}, 0.05, 8);
  e.worked("a faster start", {1, 2, 3}, {1, 0.5, 0.25}, 0.2, 3);
  // A number of steps that does not grow with the time is too small here; steps of a fixed length are not.
  e.special("two minutes", {1, 2, 3}, {1, 0.5, 0.25}, 0.005, 120);
  e.special("no air", {1, 2, 3}, {0.1, 1, 0.1}, 0, 8);
  e.special("at once", {1, 2, 3}, {0.1, 1, 0.1}, 0.3, 0);
  e.special("hardly any air", {1, 2, 3}, {1, 0.5, 0.25}, 1e-9, 5);
  e.special("strong air", {1, 2, 3}, {1, 0.5, 0.25}, 4, 3);
  e.special("a sphere", {2, 2, 2}, example_omega, 0.1, 5);
  e.special("a symmetric body", {1, 1, 1.8}, {0.4, 0, 2}, 0.1, 3);
  e.special("about one axis", {1, 2, 3}, {0, -1, 0}, 0.1, 5);
  e.special("at rest", {1, 2, 3}, zero, 0.1, 5);
  e.limit("a sphere", std::exp(-0.5) * example_omega, "ω is along L and becomes shorter with it.");
  e.limit("at once", {0.1, 1, 0.1}, "No time has passed.");
  constexpr double of_all = 0.25;  // of the notes, common to all throws
  const Vector3d start = measured::fitted_start(
      throw_3, [](const Vector3d& from) { return measured::motion_in_air(measured::racket, throw_3.t, from, of_all); });
  const Eigen::Index half = throw_3.t.size() / 2;
  const Vector3d there = throw_3.omega.col(half);
  e.measured(fmt::format("half of throw 3, where the gyroscope says ({:.1f}, {:.1f}, {:.1f}) rad/s", there[0], there[1],
                         there[2]),
             {}, measured::racket, start, of_all, throw_3.t[half] - throw_3.t[0]);
  e.random("a body in air", 10, [](Random& random) {
    const Vector3d I = random.principal_moments(), omega0 = random.vector(2);
    const double t = random.uniform(2, 5);
    return tuple(I, omega0, random.uniform(0.2, 0.7) / t, t);
  });
  e.tolerance(
      1e-6,
      "The answer may be integrated in steps: a method of fourth order with steps of some hundredths of a second "
      "stays within a millionth of the exact solution by elliptic functions.");
  e.scale([](auto&, auto& omega0, auto, auto) { return max(omega0.norm(), 1e-3); });
  e.sweep<3>({"Moments 1, 2, 3 kg m², ω = (0.1, 1, 0.1) rad/s at the start, γ = 0.05/s", "time (s)",
              "body component of ω (rad/s)"},
             {"ω_1", "ω_2", "ω_3"}, {0, 40, 81});

  e.wrong_input<2>("This is the motion without air.", "no_air", fixed(0.0));
  e.wrong(
      "The components shrink here, but the body runs along its curve as fast as without air.", "same_clock",
      [](auto& I, auto& omega0, auto gamma, auto t) { return std::exp(-gamma * t) * ExactTop(I, omega0).omega(t); });
  e.wrong("Your body runs along its curve all the time as slowly as at the end.", "clock_of_the_end",
          [](auto& I, auto& omega0, auto gamma, auto t) {
            const double slower = std::exp(-gamma * t);
            return slower * ExactTop(I, omega0).omega(slower * t);
          });
  e.wrong("The body only becomes slower on its curve here; its angular momentum has the length of the start.",
          "same_length",
          [](auto& I, auto& omega0, auto gamma, auto t) { return ExactTop(I, omega0).omega(free_time(gamma, t)); });
  e.wrong("The torque is opposite to the angular velocity here; it is opposite to the angular momentum.",
          "against_omega", [](auto& I, auto& omega0, auto gamma, auto t) {
            return followed(Vector3d(omega0), t, 4 * steps_for(omega0, t), [&](const Vector3d& w) -> Vector3d {
              return free_rate(I, w) - gamma * w.cwiseQuotient(I);
            });
          });
  e.wrong_input<2>("The angular momentum decays twice too fast here: that is how the energy decays.", "energy_rate",
                   times(2));
  e.wrong("The air drives this rotation: a torque opposite to the angular momentum makes it shorter.", "driven",
          [](auto& I, auto& omega0, auto gamma, auto t) {
            const double time = gamma * t == 0 ? t : std::expm1(gamma * t) / gamma;
            return std::exp(gamma * t) * ExactTop(I, omega0).omega(time);
          });
  e.wrong(
      "The angular momentum changes here by the torque of the start all the time; the torque becomes weaker with it.",
      "constant_torque", [](auto& I, auto& omega0, auto gamma, auto t) {
        return (1 - gamma * t) * ExactTop(I, omega0).omega(t - gamma * t * t / 2);
      });
  e.route("a controlled integration of high order", damped_rotation);
  e.route("the equations with the torque, by Runge and Kutta", [](auto& I, auto& omega0, auto gamma, auto t) {
    return followed(Vector3d(omega0), t, steps_for(omega0, t) + static_cast<int>(100 * gamma * t),
                    [&](const Vector3d& w) -> Vector3d { return free_rate(I, w) - gamma * w; });
  });
  e.route("L in the body, then divided", [](auto& I, auto& omega0, auto gamma, auto t) -> Vector3d {
    const Vector3d L =
        followed(L_of(I, omega0), t, steps_for(omega0, t) + static_cast<int>(100 * gamma * t),
                 [&](const Vector3d& M) -> Vector3d { return cross(M, M.cwiseQuotient(I)) - gamma * M; });
    return L.cwiseQuotient(I);
  });
  e.survivor("double size = ", "ω and time are scaled by it in opposite ways.");
  e.survivor("-size == 0", "Zero has no sign.");
  e.survivor("gamma == 0 ?", "Zero has no sign, and no multiple.");
  e.survivor("make_controlled(", "Tolerances nearby reach the accuracy that is asked for.");
  e.survivor("integrate_adaptive(", "The stepper corrects its first step.");
}
