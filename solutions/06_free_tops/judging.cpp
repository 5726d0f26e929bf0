/// @file
/// How the exercises of lecture 06 are judged.
#include "rigid/free_tops.hpp"
#include "solutions/judging/exact_top.hpp"
#include "solutions/judging/lecture.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <tuple>

namespace {

using namespace rigid;
using namespace workbook;
using namespace workbook::judging;

constexpr double pi = std::numbers::pi;
constexpr Unit per_second = units::none / units::second;

/// A rate that is zero when nothing turns needs some natural size all the same.
double or_one(double size) { return size > 0 ? size : 1.0; }

/// The vector turned about axis 3, from axis 1 towards axis 2.
Vector3d turned(const Vector3d& omega, double angle) { return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega; }

// ---- the symmetric top
// ------------------------------------------------------------------------------------------------

using SymmetricSpin = std::tuple<double, double, double>;              // I1, I3, ω3
using SymmetricMotion = std::tuple<double, double, Vector3d, double>;  // I1, I3, ω at time 0, t
using SymmetricState = std::tuple<double, double, Vector3d>;           // I1, I3, ω

/// Moments I1 = I2 and I3 of a real body, flattened or long, away from the sphere and from the flat plate.
std::array<double, 2> symmetric_moments(Random& random) {
  const double I1 = random.uniform(0.5, 3);
  const double ratio = random.sign() > 0 ? random.uniform(1.2, 1.8) : random.uniform(0.25, 0.8);
  return {I1, ratio * I1};
}

/// The lecture's top: I1 = 1, I3 = 1.8, amplitude 0.4, phase 0.3, ω3 = 2.
Vector3d lecture_omega() { return {0.4 * std::cos(0.3), 0.4 * std::sin(0.3), 2}; }

void describe_body_precession_rate(Lecture& lecture) {
  auto& exercise = lecture.exercise("body_precession_rate", &body_precession_rate);
  exercise.argument("I1", units::moment_of_inertia)
      .argument("I3", units::moment_of_inertia)
      .argument("omega3", units::radian_per_second)
      .result("Omega", units::radian_per_second);

  exercise.worked("the top of the lecture", 1.0, 1.8, 2.0);
  exercise.worked("a long top, whose Ω is negative", 2.0, 0.5, 3.0);
  exercise.worked("a long top that spins the other way", 2.0, 0.5, -3.0);
  exercise.special("a sphere", 2.0, 2.0, 1.5);
  exercise.special("a flat plate, I3 = 2 I1", 0.5, 1.0, 3.0);
  exercise.special("nearly a sphere", 1.0, 1.0 + 1e-6, 2.0);
  exercise.special("no spin", 1.0, 1.8, 0.0);
  exercise.random("a random top", 8, [](Random& random) {
    const auto [I1, I3] = symmetric_moments(random);
    return SymmetricSpin{I1, I3, random.sign() * random.uniform(0.5, 4)};
  });
  exercise.scale([](double, double, double omega3) { return or_one(std::abs(omega3)); });

  exercise.misconception("opposite_sign", "Your rate has the opposite sign: on the slides Ω = ω₃ (I₃ − I₁)/I₁.",
                         "free_tops_body", [](double I1, double I3, double omega3) { return omega3 * (I1 - I3) / I1; });
  exercise.misconception("divided_by_I3",
                         "You divide by I₃; the equation for ω₁ has I₁ in front of its rate, so Ω is divided by I₁.",
                         "free_tops_body", [](double I1, double I3, double omega3) { return omega3 * (I3 - I1) / I3; });
  exercise.misconception("moments_exchanged",
                         "I₁ and I₃ are exchanged in your formula; I₃ belongs to the symmetry axis.", "free_tops_body",
                         [](double I1, double I3, double omega3) { return omega3 * (I1 - I3) / I3; });
  exercise.misconception("inverted", "Your fraction stands on its head: (I₃ − I₁) belongs above, I₁ below.",
                         "free_tops_body",
                         [](double I1, double I3, double omega3) { return I1 == I3 ? 0.0 : omega3 * I1 / (I3 - I1); });
  exercise.misconception("space_rate",
                         "This is ω₃I₃/I₁, which is L/I₁ for a small wobble: the rate in the inertial frame; seen from "
                         "the body it is smaller by ω₃.",
                         "free_tops_space", [](double I1, double I3, double omega3) { return omega3 * I3 / I1; });
  exercise.misconception("sum_of_moments", "You add the moments; Euler's equation has their difference, I₃ − I₁.",
                         "free_tops_body", [](double I1, double I3, double omega3) { return omega3 * (I3 + I1) / I1; });
  exercise.misconception("magnitude", "You return the magnitude of Ω; its sign says which way ω runs round the axis.",
                         "free_tops_body",
                         [](double I1, double I3, double omega3) { return std::abs(omega3 * (I3 - I1) / I1); });
  exercise.misconception("sense_of_spin_lost", "The sense of the spin is lost: Ω changes its sign with ω₃.",
                         "free_tops_body",
                         [](double I1, double I3, double omega3) { return std::abs(omega3) * (I3 - I1) / I1; });
  exercise.misconception("spin_dropped", "ω₃ does not enter; Ω is proportional to the spin.", "free_tops_body",
                         [](double I1, double I3, double) { return (I3 - I1) / I1; });
  exercise.misconception("turns_per_second", "This is Ω/2π, in turns per second; asked for is the rate in rad/s.",
                         "free_tops_body",
                         [](double I1, double I3, double omega3) { return omega3 * (I3 - I1) / I1 / (2 * pi); });
  exercise.misconception("period", "This is the period 2π/Ω; asked for is the rate Ω.", "free_tops_body",
                         [](double I1, double I3, double omega3) {
                           const double rate = omega3 * (I3 - I1) / I1;
                           return rate == 0 ? 0.0 : 2 * pi / rate;
                         });

  exercise.term("ω₃ I₃/I₁", 1.0, [](double I1, double I3, double omega3) { return omega3 * I3 / I1; });
  exercise.term("ω₃", -1.0, [](double, double, double omega3) { return omega3; });

  exercise.route("one less than the ratio", [](double I1, double I3, double omega3) { return (I3 / I1 - 1) * omega3; });
  exercise.route("difference of two rates",
                 [](double I1, double I3, double omega3) { return I3 * omega3 / I1 - omega3; });
  exercise.route("read off Euler's equations", [](double I1, double I3, double omega3) {
    // With ω1 = 1 the second equation gives the rate of ω2, which is Ω.
    const Vector3d I(I1, I1, I3), omega(1, 0, omega3);
    const Vector3d L = I.cwiseProduct(omega);
    return L.cross(omega)[1] / I1;
  });

  exercise.sweep(
      {"A top of I₁ = 1 kg m² and ω₃ = 1 rad/s: from the needle through the sphere to the plate", "I₃/I₁", "Ω (rad/s)"},
      {0.02, 2},
      [](double ratio) {
        return SymmetricSpin{1, ratio, 1};
      },
      {{"Omega", 0, 0}});
}

void describe_symmetric_top(Lecture& lecture) {
  auto& exercise = lecture.exercise("symmetric_top", &symmetric_top);
  exercise.argument("I1", units::moment_of_inertia)
      .argument("I3", units::moment_of_inertia)
      .argument("omega0", units::radian_per_second)
      .argument("t", units::second)
      .result("omega", units::radian_per_second);

  exercise.worked("the top of the lecture", 1.0, 1.8, lecture_omega(), 0.7);
  exercise.worked("a long top, before time 0", 2.0, 0.5, Vector3d(-0.7, 0.4, 1.5), -0.9);
  exercise.special("time 0", 1.0, 1.8, lecture_omega(), 0.0);
  exercise.special("a full period later", 1.0, 1.8, lecture_omega(), 2 * pi / 1.6);
  exercise.special("half a period later", 1.0, 1.8, lecture_omega(), pi / 1.6);
  exercise.special("a sphere", 2.0, 2.0, Vector3d(0.3, -0.2, 0.5), 3.0);
  exercise.special("no wobble", 1.0, 1.8, Vector3d(0, 0, 2), 0.7);
  exercise.special("no spin about the symmetry axis", 1.0, 1.8, Vector3d(0.3, 0.4, 0), 0.7);
  exercise.special("a wobble of 1e-8", 1.0, 1.8, Vector3d(1e-8, 0, 2), 0.7);
  exercise.random("a random top", 10, [](Random& random) {
    const auto [I1, I3] = symmetric_moments(random);
    const Vector3d omega = random.vector(3);
    const double angle = random.uniform(0.4, 1.2);  // how far ω turns: neither 0 nor near half a turn
    return SymmetricMotion{I1, I3, omega, random.sign() * angle / std::abs(body_precession_rate(I1, I3, omega[2]))};
  });
  exercise.scale([](double, double, const Vector3d& omega0, double) { return or_one(omega0.norm()); });

  exercise.misconception(
      "wrong_sense",
      "Your ω runs round the axis the wrong way: ω₁ = A cos(Ωt + φ), ω₂ = A sin(Ωt + φ) with Ω = ω₃ (I₃ − I₁)/I₁.",
      "free_tops_body", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
        return turned(omega0, -body_precession_rate(I1, I3, omega0[2]) * t);
      });
  exercise.misconception(
      "phase_lost", "The initial phase is lost: at t = 0 your ω does not equal omega0.", "free_tops_body",
      [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
        return turned({std::hypot(omega0[0], omega0[1]), 0, omega0[2]}, body_precession_rate(I1, I3, omega0[2]) * t);
      });
  exercise.misconception(
      "phase_negated",
      "The initial phase enters with the wrong sign: at t = 0 your ω₂ is the negative of the given one.",
      "free_tops_body", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
        return turned({omega0[0], -omega0[1], omega0[2]}, body_precession_rate(I1, I3, omega0[2]) * t);
      });
  exercise.misconception(
      "phase_by_atan",
      "The phase lies in the wrong quadrant when ω₁ < 0: take std::atan2(ω₂, ω₁), not std::atan(ω₂/ω₁).",
      "free_tops_body", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
        const double side = omega0[0] < 0 ? -1 : 1;
        return turned({side * omega0[0], side * omega0[1], omega0[2]}, body_precession_rate(I1, I3, omega0[2]) * t);
      });
  exercise.misconception("sine_and_cosine_exchanged",
                         "Sine and cosine are exchanged: ω₁ takes the cosine of Ωt + φ, ω₂ the sine.", "free_tops_body",
                         [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                           const Vector3d right = symmetric_top(I1, I3, omega0, t);
                           return {right[1], right[0], right[2]};
                         });
  exercise.misconception("amplitude_squared", "Your amplitude is ω₁² + ω₂²; A is the square root of it.",
                         "free_tops_body", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                           const double amplitude = std::hypot(omega0[0], omega0[1]);
                           return symmetric_top(I1, I3, {amplitude * omega0[0], amplitude * omega0[1], omega0[2]}, t);
                         });
  exercise.misconception("divided_by_I3", "Your ω turns with ω₃ (I₃ − I₁)/I₃; the rate Ω is divided by I₁.",
                         "free_tops_body", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                           return turned(omega0, omega0[2] * (I3 - I1) / I3 * t);
                         });
  exercise.misconception("moments_exchanged",
                         "I₁ and I₃ are exchanged in the rate at which your ω turns; I₃ belongs to the symmetry axis.",
                         "free_tops_body", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                           return turned(omega0, omega0[2] * (I1 - I3) / I3 * t);
                         });
  exercise.misconception(
      "space_rate",
      "Your ω turns with L/I₁, the rate of precession in the inertial frame; seen from the body it turns with Ω.",
      "free_tops_space", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
        return turned(omega0, space_precession_rate(I1, I3, omega0) * t);
      });
  exercise.misconception("space_rate_of_a_small_wobble",
                         "Your ω turns with ω₃I₃/I₁, which belongs to the inertial frame; seen from the body it turns "
                         "with Ω, smaller by ω₃.",
                         "free_tops_space", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                           return turned(omega0, omega0[2] * I3 / I1 * t);
                         });
  exercise.misconception(
      "spin_rate", "Your ω turns with ω₃ itself; the rate is Ω = ω₃ (I₃ − I₁)/I₁.", "free_tops_body",
      [](double, double, const Vector3d& omega0, double t) -> Vector3d { return turned(omega0, omega0[2] * t); });
  exercise.misconception("magnitude_of_rate",
                         "Your ω always turns from axis 1 to axis 2; the sign of Ω decides the sense.",
                         "free_tops_body", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                           return turned(omega0, std::abs(body_precession_rate(I1, I3, omega0[2])) * t);
                         });
  exercise.misconception("no_motion", "You return ω of time 0; ω₁ and ω₂ change with time.", "free_tops_body",
                         [](double, double, const Vector3d& omega0, double) -> Vector3d { return omega0; });
  exercise.misconception("one_step", "You add one step t·dω/dt to omega0; over a finite time ω turns on a circle.",
                         "free_tops_body", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                           const double angle = body_precession_rate(I1, I3, omega0[2]) * t;
                           return omega0 + angle * Vector3d(-omega0[1], omega0[0], 0);
                         });
  exercise.misconception("inertial_components",
                         "These are the components of ω on axes that do not turn, where it circles the angular "
                         "momentum; asked for are the body components.",
                         "free_tops_space", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                           if (omega0.isZero()) return omega0;
                           const Vector3d L = omega0.cwiseProduct(Vector3d(I1, I1, I3));
                           return Eigen::AngleAxisd(L.norm() / I1 * t, L.normalized()) * omega0;
                         });
  exercise.misconception("spin_not_returned", "Your third component is zero; ω₃ keeps its value.", "free_tops_body",
                         [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                           return symmetric_top(I1, I3, omega0, t).cwiseProduct(Vector3d(1, 1, 0));
                         });

  exercise.term("cos Ωt · (ω₁, ω₂, 0) of time 0", 1.0,
                [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                  return std::cos(body_precession_rate(I1, I3, omega0[2]) * t) * Vector3d(omega0[0], omega0[1], 0);
                });
  exercise.term("sin Ωt · (−ω₂, ω₁, 0) of time 0", 1.0,
                [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                  return std::sin(body_precession_rate(I1, I3, omega0[2]) * t) * Vector3d(-omega0[1], omega0[0], 0);
                });
  exercise.term("(0, 0, ω₃)", 1.0, [](double, double, const Vector3d& omega0, double) -> Vector3d {
    return {0, 0, omega0[2]};
  });
  exercise.conserves(
      "The kinetic energy of a free top does not change: I₁ω₁² + I₁ω₂² + I₃ω₃² is the same at all times.",
      "free_tops_energy", [](double I1, double I3, const Vector3d&, double) {
        return std::vector<double>{I1, I1, I3};
      });

  exercise.route("amplitude and phase", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
    const double amplitude = std::hypot(omega0[0], omega0[1]);
    const double angle = body_precession_rate(I1, I3, omega0[2]) * t + std::atan2(omega0[1], omega0[0]);
    return {amplitude * std::cos(angle), amplitude * std::sin(angle), omega0[2]};
  });
  exercise.route("a complex number", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
    const std::complex<double> transverse =
        std::complex(omega0[0], omega0[1]) * std::polar(1.0, omega0[2] * (I3 / I1 - 1) * t);
    return {transverse.real(), transverse.imag(), omega0[2]};
  });
  exercise.route(
      "Euler's equations, step by step", [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
        const Vector3d I(I1, I1, I3);
        const auto rate = [&I](const Vector3d& omega) -> Vector3d {
          const Vector3d L = I.cwiseProduct(omega);
          return L.cross(omega).cwiseQuotient(I);
        };
        const int steps = 4000;  // Runge and Kutta's fourth order: the error goes with the fourth power of the step
        const double h = t / steps;
        Vector3d omega = omega0;
        for (int i = 0; i < steps; ++i) {
          const Vector3d a = rate(omega), b = rate(omega + h / 2 * a), c = rate(omega + h / 2 * b),
                         d = rate(omega + h * c);
          omega += h / 6 * (a + 2 * b + 2 * c + d);
        }
        return omega;
      });
  exercise.route("the exact asymmetric top, with two equal moments",
                 [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                   return ExactTop({I1, I1, I3}, omega0).omega(t);
                 });
  exercise.route("back from inertial components",
                 [](double I1, double I3, const Vector3d& omega0, double t) -> Vector3d {
                   // In space ω turns about L with L/I1; the body turns likewise and, besides, about its own axis with
                   // −Ω.
                   const Vector3d L = omega0.cwiseProduct(Vector3d(I1, I1, I3));
                   const Eigen::Quaterniond about_L(Eigen::AngleAxisd(L.norm() / I1 * t, L.normalized()));
                   const Eigen::Quaterniond own(
                       Eigen::AngleAxisd(-body_precession_rate(I1, I3, omega0[2]) * t, Vector3d::UnitZ()));
                   return (about_L * own).conjugate() * (about_L * omega0);
                 });

  exercise.sweep({"The top of the lecture: I₁ = 1, I₃ = 1.8 kg m², A = 0.4, ω₃ = 2 rad/s", "time (s)",
                  "body component of ω (rad/s)"},
                 {0, 6},
                 [](double t) {
                   return SymmetricMotion{1, 1.8, lecture_omega(), t};
                 },
                 {{"omega_1", 0, 0}, {"omega_2", 1, 0}, {"omega_3", 2, 0}});
}

void describe_space_precession_rate(Lecture& lecture) {
  auto& exercise = lecture.exercise("space_precession_rate", &space_precession_rate);
  exercise.argument("I1", units::moment_of_inertia)
      .argument("I3", units::moment_of_inertia)
      .argument("omega", units::radian_per_second)
      .result("rate", units::radian_per_second);

  exercise.worked("the top of the lecture", 1.0, 1.8, lecture_omega());
  exercise.worked("a plate that spins the other way", 0.5, 1.0, Vector3d(0.8, -0.5, -3));
  exercise.special("a sphere", 2.0, 2.0, Vector3d(0.3, -0.2, 0.5));
  exercise.special("no wobble", 1.0, 1.8, Vector3d(0, 0, 2));
  exercise.special("no spin about the symmetry axis", 1.0, 1.8, Vector3d(0.3, 0.4, 0));
  exercise.special("no rotation", 1.0, 1.8, Vector3d::Zero());
  exercise.special("a wobble of 1e-8", 1.0, 1.8, Vector3d(1e-8, 0, 2));
  exercise.random("a random top", 8, [](Random& random) {
    const auto [I1, I3] = symmetric_moments(random);
    return SymmetricState{I1, I3, random.vector(3)};
  });
  exercise.scale(
      [](double I1, double I3, const Vector3d& omega) { return or_one(std::max(1.0, I3 / I1) * omega.norm()); });

  const auto momentum = [](double I1, double I3, const Vector3d& omega) {
    return Vector3d(I1 * omega[0], I1 * omega[1], I3 * omega[2]).norm();
  };
  exercise.misconception(
      "divided_by_I3", "You divide L by I₃; the symmetry axis runs round L with L/I₁.", "free_tops_space",
      [momentum](double I1, double I3, const Vector3d& omega) { return momentum(I1, I3, omega) / I3; });
  exercise.misconception(
      "body_rate", "This is Ω, the rate seen from the body; in the inertial frame the axis runs round L with L/I₁.",
      "free_tops_space",
      [](double I1, double I3, const Vector3d& omega) { return body_precession_rate(I1, I3, omega[2]); });
  exercise.misconception(
      "magnitude_of_body_rate",
      "This is |Ω|, the rate seen from the body; in the inertial frame the axis runs round L with L/I₁.",
      "free_tops_space",
      [](double I1, double I3, const Vector3d& omega) { return std::abs(body_precession_rate(I1, I3, omega[2])); });
  const std::string small_wobble =
      "This is ω₃I₃/I₁, right only for a small wobble: it must still be divided by the cosine of the angle between L "
      "and the axis.";
  exercise.misconception("small_wobble", small_wobble, "free_tops_space",
                         [](double I1, double I3, const Vector3d& omega) { return omega[2] * I3 / I1; });
  exercise.misconception("small_wobble_positive", small_wobble, "free_tops_space",
                         [](double I1, double I3, const Vector3d& omega) { return std::abs(omega[2]) * I3 / I1; });
  exercise.misconception("length_of_omega", "This is |ω|; the axis runs round L, and L has another length than I₁|ω|.",
                         "free_tops_space", [](double, double, const Vector3d& omega) { return omega.norm(); });
  exercise.misconception("not_divided", "This is L itself; the rate is L/I₁.", "free_tops_space",
                         [momentum](double I1, double I3, const Vector3d& omega) { return momentum(I1, I3, omega); });
  exercise.misconception(
      "moments_exchanged", "I₁ and I₃ are exchanged: I₃ goes with ω₃, and I₁ divides.", "free_tops_space",
      [momentum](double I1, double I3, const Vector3d& omega) { return momentum(I3, I1, omega) / I3; });
  exercise.misconception(
      "second_component_lost", "ω₂ does not enter; both components across the axis belong to L.", "free_tops_space",
      [](double I1, double I3, const Vector3d& omega) { return std::hypot(omega[0], omega[2] * I3 / I1); });
  exercise.misconception(
      "first_component_lost", "ω₁ does not enter; both components across the axis belong to L.", "free_tops_space",
      [](double I1, double I3, const Vector3d& omega) { return std::hypot(omega[1], omega[2] * I3 / I1); });
  exercise.misconception(
      "momentum_squared", "You divide L² by I₁; the square root of L² is missing.", "free_tops_space",
      [momentum](double I1, double I3, const Vector3d& omega) { return std::pow(momentum(I1, I3, omega), 2) / I1; });
  exercise.misconception(
      "sign_of_spin",
      "Your rate changes its sign with ω₃; the axis turns about L in the right-handed sense, so the rate is positive.",
      "free_tops_space", [momentum](double I1, double I3, const Vector3d& omega) {
        return std::copysign(momentum(I1, I3, omega) / I1, omega[2]);
      });
  exercise.misconception(
      "along_momentum",
      "This is the part of ω along L, which is 2T/L: it still contains the body's own spin about its axis.",
      "free_tops_space", [](double I1, double I3, const Vector3d& omega) {
        const Vector3d L = omega.cwiseProduct(Vector3d(I1, I1, I3));
        return L.isZero() ? 0.0 : omega.dot(L.normalized());
      });
  exercise.misconception(
      "components_added", "You add the components of L; its length is the root of the sum of their squares.",
      "free_tops_space",
      [](double I1, double I3, const Vector3d& omega) { return omega[0] + omega[1] + I3 / I1 * omega[2]; });
  exercise.misconception(
      "turns_per_second", "This is the rate over 2π, in turns per second; asked for is rad/s.", "free_tops_space",
      [momentum](double I1, double I3, const Vector3d& omega) { return momentum(I1, I3, omega) / I1 / (2 * pi); });
  exercise.property(PropertyKind::nonnegative, "The precession is right-handed about L, so its rate is never negative.",
                    "free_tops_space");

  exercise.route("components in turn", [](double I1, double I3, const Vector3d& omega) {
    const double x = I1 * omega[0], y = I1 * omega[1], z = I3 * omega[2];
    return std::sqrt(x * x + y * y + z * z) / I1;
  });
  exercise.route("across and along the axis", [](double I1, double I3, const Vector3d& omega) {
    return std::hypot(std::hypot(omega[0], omega[1]), I3 / I1 * omega[2]);
  });
  exercise.route("with Ω", [](double I1, double I3, const Vector3d& omega) {
    return Vector3d(omega[0], omega[1], omega[2] + body_precession_rate(I1, I3, omega[2])).norm();
  });
  exercise.route("from energy and momentum", [](double I1, double I3, const Vector3d& omega) {
    // 2T = L²/I1 − (I3 − I1) I3 ω3² / I1, solved for L.
    const double twice_energy = Vector3d(I1, I1, I3).dot(omega.cwiseAbs2());
    return std::sqrt((I1 * twice_energy + (I3 - I1) * I3 * omega[2] * omega[2])) / I1;
  });

  exercise.sweep({"A top of I₁ = 1, I₃ = 1.8 kg m² and ω₃ = 2 rad/s wobbles harder and harder",
                  "amplitude A of the wobble (rad/s)", "rate of precession (rad/s)"},
                 {0, 6},
                 [](double amplitude) {
                   return SymmetricState{1, 1.8, Vector3d(0.6 * amplitude, 0.8 * amplitude, 2)};
                 },
                 {{"rate", 0, 0}});
}

// ---- the asymmetric top
// -------------------------------------------------------------------------------------------------

using Spin = std::tuple<Vector3d, double>;                            // moments, spin
using Wobble = std::tuple<Vector3d, double, double, double, double>;  // moments, ω3, A, φ, t

void describe_linearized_rates(Lecture& lecture) {
  auto& exercise = lecture.exercise("linearized_rates", &linearized_rates);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega3", units::radian_per_second)
      .result("rates", units::radian_per_second);

  exercise.worked("the smallest moment about axis 3", Vector3d(2, 3, 1), 5.0);
  exercise.worked("the intermediate moment about axis 3", Vector3d(3, 1, 2), -1.5);
  exercise.special("a symmetric top: both rates are Ω", Vector3d(1, 1, 1.8), 2.0);
  exercise.special("a sphere", Vector3d(2, 2, 2), 1.5);
  exercise.special("two equal moments, one of them I3", Vector3d(1, 2, 2), 1.5);
  exercise.special("no spin", Vector3d(2, 3, 1), 0.0);
  exercise.random("a random body", 8, [](Random& random) {
    const Vector3d I = random.principal_moments();
    return Spin{I, random.sign() * random.uniform(0.5, 4)};
  });
  exercise.scale([](const Vector3d& I, double omega3) {
    return or_one(std::abs(omega3) * I.maxCoeff() / I.head<2>().minCoeff());
  });

  exercise.misconception(
      "exchanged", "Ω₁ and Ω₂ are exchanged: the subscript names the moment in the denominator.", "free_tops_linear",
      [](const Vector3d& I, double omega3) -> Vector2d { return linearized_rates(I, omega3).reverse(); });
  exercise.misconception("opposite_signs", "Both rates have the opposite sign: I₃ comes first in both differences.",
                         "free_tops_linear",
                         [](const Vector3d& I, double omega3) -> Vector2d { return -linearized_rates(I, omega3); });
  exercise.misconception("denominators_exchanged", "Your denominators are exchanged: Ω₁ is divided by I₁, Ω₂ by I₂.",
                         "free_tops_linear", [](const Vector3d& I, double omega3) -> Vector2d {
                           return omega3 * Vector2d((I[2] - I[1]) / I[1], (I[2] - I[0]) / I[0]);
                         });
  exercise.misconception("numerators_exchanged", "Your numerators are exchanged: Ω₁ takes I₃ − I₂, Ω₂ takes I₃ − I₁.",
                         "free_tops_linear", [](const Vector3d& I, double omega3) -> Vector2d {
                           return omega3 * Vector2d((I[2] - I[0]) / I[0], (I[2] - I[1]) / I[1]);
                         });
  exercise.misconception(
      "divided_by_I3", "You divide by I₃; each rate is divided by the moment in front of its own equation, I₁ or I₂.",
      "free_tops_linear",
      [](const Vector3d& I, double omega3) -> Vector2d { return omega3 * Vector2d(I[2] - I[1], I[2] - I[0]) / I[2]; });
  exercise.misconception(
      "not_divided", "You leave out the division by I₁ and I₂.", "free_tops_linear",
      [](const Vector3d& I, double omega3) -> Vector2d { return omega3 * Vector2d(I[2] - I[1], I[2] - I[0]); });
  exercise.misconception(
      "second_sign", "Ω₂ has the opposite sign: Euler's second equation holds I₁ − I₃, and the slides turn it round.",
      "free_tops_linear", [](const Vector3d& I, double omega3) -> Vector2d {
        return linearized_rates(I, omega3).cwiseProduct(Vector2d(1, -1));
      });
  exercise.misconception("first_sign",
                         "Ω₁ has the opposite sign: the slides define it by dω₁/dt = −Ω₁ω₂, with a minus.",
                         "free_tops_linear", [](const Vector3d& I, double omega3) -> Vector2d {
                           return linearized_rates(I, omega3).cwiseProduct(Vector2d(-1, 1));
                         });
  exercise.misconception(
      "magnitudes", "You return the magnitudes; whether the signs agree decides about stability.", "free_tops_linear",
      [](const Vector3d& I, double omega3) -> Vector2d { return linearized_rates(I, omega3).cwiseAbs(); });
  exercise.misconception(
      "sense_of_spin_lost", "The sense of the spin is lost: both rates change sign with ω₃.", "free_tops_linear",
      [](const Vector3d& I, double omega3) -> Vector2d { return linearized_rates(I, std::abs(omega3)); });
  exercise.misconception("spin_dropped", "ω₃ does not enter; both rates are proportional to the spin.",
                         "free_tops_linear",
                         [](const Vector3d& I, double) -> Vector2d { return linearized_rates(I, 1); });
  exercise.misconception(
      "symmetric", "Both your rates are the Ω of a symmetric top with I₂ = I₁; here I₂ differs.", "free_tops_linear",
      [](const Vector3d& I, double omega3) -> Vector2d { return Vector2d::Constant(omega3 * (I[2] - I[0]) / I[0]); });

  exercise.term("ω₃I₃ (1/I₁, 1/I₂)", 1.0, [](const Vector3d& I, double omega3) -> Vector2d {
    return omega3 * I[2] * Vector2d(1 / I[0], 1 / I[1]);
  });
  exercise.term("ω₃ (I₂/I₁, I₁/I₂)", -1.0, [](const Vector3d& I, double omega3) -> Vector2d {
    return omega3 * Vector2d(I[1] / I[0], I[0] / I[1]);
  });

  exercise.route("ratios of moments", [](const Vector3d& I, double omega3) -> Vector2d {
    return {omega3 * I[2] / I[0] - omega3 * I[1] / I[0], omega3 * I[2] / I[1] - omega3 * I[0] / I[1]};
  });
  exercise.route("differentiated from Euler's equations", [](const Vector3d& I, double omega3) -> Vector2d {
    // Euler's equations are quadratic, so the central difference is exact for any step.
    const auto rate = [&](double x, double y) -> Vector3d {
      const Vector3d omega(x, y, omega3), L = I.cwiseProduct(omega);
      return L.cross(omega).cwiseQuotient(I);
    };
    return {-(rate(0, 1) - rate(0, -1))[0] / 2, (rate(1, 0) - rate(-1, 0))[1] / 2};
  });
  exercise.route("entry by entry", [](const Vector3d& I, double omega3) -> Vector2d {
    Vector2d rates;
    for (int i = 0; i < 2; ++i) rates[i] = (I[2] - I[1 - i]) * (omega3 / I[i]);
    return rates;
  });

  exercise.sweep(
      {"I₁ = 2, I₂ = 3 kg m², ω₃ = 1 rad/s: the signs differ where I₃ lies between", "I₃ (kg m²)", "rate (rad/s)"},
      {1, 5},
      [](double I3) {
        return Spin{Vector3d(2, 3, I3), 1};
      },
      {{"Omega_1", 0, 0}, {"Omega_2", 1, 0}});
}

/// Principal moments of a real body with the smallest or the largest about axis 3, so that a spin about it is stable.
Vector3d moments_stable_about_3(Random& random, bool largest) {
  Vector3d I = random.ascending_moments();
  if (!largest) std::swap(I[0], I[2]);
  if (random.sign() > 0) std::swap(I[0], I[1]);
  return I;
}

/// A wobble with Ω1 and Ω2 of the given sign, away from the angles at which sine or cosine vanish.
Wobble random_wobble(Random& random, double sign_of_rates) {
  const bool largest = random.sign() > 0;
  const Vector3d I = moments_stable_about_3(random, largest);
  const double omega3 = (largest ? 1 : -1) * sign_of_rates * random.uniform(1, 5);
  const Vector2d rates = linearized_rates(I, omega3);
  const double phase = random.sign() * random.uniform(0.3, 0.6);
  const double angle = random.uniform(0.8, 1.2) + pi * random.whole(-1, 1);  // where the wobble has got to
  return {I, omega3, random.uniform(0.01, 0.05), phase, (angle - phase) / std::sqrt(rates.prod())};
}

void describe_linearized_top(Lecture& lecture) {
  auto& exercise = lecture.exercise("linearized_top", &linearized_top);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega3", units::radian_per_second)
      .argument("amplitude", units::radian_per_second)
      .argument("phase", units::radian)
      .argument("t", units::second)
      .result("omega", units::radian_per_second);

  exercise.worked("the smallest moment about axis 3 (both rates negative)", Vector3d(2, 3, 1), 5.0, 0.01, 0.3, 0.2);
  exercise.worked("the largest moment about axis 3 (both rates positive)", Vector3d(1, 2, 3), 2.0, 0.02, -0.4, 0.7);
  exercise.special("time 0", Vector3d(2, 3, 1), 5.0, 0.01, 0.3, 0.0);
  exercise.special("phase 0", Vector3d(2, 3, 1), 5.0, 1e-5, 0.0, 0.2);
  exercise.special("no wobble", Vector3d(2, 3, 1), 5.0, 0.0, 0.3, 0.2);
  exercise.special("a flattened symmetric top", Vector3d(1, 1, 1.8), 2.0, 0.01, 0.3, 0.7);
  exercise.special("a long symmetric top", Vector3d(2, 2, 0.5), 2.0, 0.01, 0.3, 0.7);
  exercise.special("moments that differ by a millionth", Vector3d(1, 1 + 1e-6, 1.8), 2.0, 0.01, 0.3, 0.7);
  exercise.random("both rates negative", 6, [](Random& random) { return random_wobble(random, -1); });
  exercise.random("both rates positive", 4, [](Random& random) { return random_wobble(random, 1); });
  exercise.scales([](const Vector3d& I, double omega3, double amplitude, double, double) {
    const Vector2d rates = linearized_rates(I, omega3);
    const double size = or_one(std::abs(amplitude));
    return std::vector<double>{size, size * std::sqrt(rates[1] / rates[0])};
  });

  struct Parts {
    Vector2d rates;
    double frequency, ratio, sign;
  };
  const auto parts = [](const Vector3d& I, double omega3) {
    const Vector2d rates = linearized_rates(I, omega3);
    return Parts{rates, std::sqrt(rates.prod()), std::sqrt(rates[1] / rates[0]), rates[0] < 0 ? -1.0 : 1.0};
  };
  // A cos(angle) and factor · A sin(angle).
  const auto wobble = [](double amplitude, double angle, double factor) -> Vector2d {
    return amplitude * Vector2d(std::cos(angle), factor * std::sin(angle));
  };
  exercise.misconception("formula_of_the_slides",
                         "This is the formula printed on the slides, and there the slides slip: if Ω₁ and Ω₂ are "
                         "negative, ω₂ has the opposite sign.",
                         "free_tops_sign",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.frequency * t + phase, p.ratio);
                         });
  exercise.misconception(
      "sign_always_reversed",
      "Your ω₂ has the wrong sign where Ω₁ and Ω₂ are positive; its sign is that of Ω₁, not always minus.",
      "free_tops_sign", [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
        const Parts p = parts(I, omega3);
        return wobble(amplitude, p.frequency * t + phase, -p.ratio);
      });
  exercise.misconception("sign_reversed", "Your ω₂ has the wrong sign everywhere: put it into dω₁/dt = −Ω₁ω₂ and see.",
                         "free_tops_sign",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.frequency * t + phase, -p.sign * p.ratio);
                         });
  exercise.misconception("sign_in_frequency",
                         "The sign of Ω₁ stands in your frequency, so the motion begins at another phase; it belongs "
                         "in front of the sine of ω₂.",
                         "free_tops_sign",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.sign * p.frequency * t + phase, p.ratio);
                         });
  exercise.misconception(
      "sign_of_spin", "You give ω₂ the sign of ω₃; it is the sign of Ω₁, which also changes with I₃ − I₂.",
      "free_tops_sign", [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
        const Parts p = parts(I, omega3);
        return wobble(amplitude, p.frequency * t + phase, std::copysign(p.ratio, omega3));
      });
  const std::string ratio_inverted = "Your ratio of amplitudes is inverted: ω₂ has √(Ω₂/Ω₁) times the amplitude of ω₁.";
  exercise.misconception("ratio_inverted", ratio_inverted, "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.frequency * t + phase, p.sign / p.ratio);
                         });
  exercise.misconception("ratio_inverted_and_unsigned", ratio_inverted, "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.frequency * t + phase, 1 / p.ratio);
                         });
  const std::string equal_amplitudes =
      "Both your components have the same amplitude, as in a symmetric top; here ω₂ has √(Ω₂/Ω₁) times that of ω₁.";
  exercise.misconception("equal_amplitudes", equal_amplitudes, "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.frequency * t + phase, p.sign);
                         });
  exercise.misconception("equal_amplitudes_unsigned", equal_amplitudes, "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.frequency * t + phase, 1);
                         });
  exercise.misconception("ratio_without_root", "The root is missing in the ratio of amplitudes: it is √(Ω₂/Ω₁).",
                         "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.frequency * t + phase, p.sign * p.ratio * p.ratio);
                         });
  exercise.misconception("frequency_without_root", "The root is missing in your frequency: it is √(Ω₁Ω₂).",
                         "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.rates.prod() * t + phase, p.sign * p.ratio);
                         });
  exercise.misconception("frequency_first", "Your wobble has the frequency |Ω₁|; it is √(Ω₁Ω₂), between |Ω₁| and |Ω₂|.",
                         "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, std::abs(p.rates[0]) * t + phase, p.sign * p.ratio);
                         });
  exercise.misconception(
      "frequency_mean", "Your frequency is the mean of |Ω₁| and |Ω₂|; it is the root of their product.",
      "free_tops_linear", [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
        const Parts p = parts(I, omega3);
        return wobble(amplitude, std::abs(p.rates.sum()) / 2 * t + phase, p.sign * p.ratio);
      });
  exercise.misconception("phase_lost", "The phase does not enter: at t = 0 the first component must be A cos φ.",
                         "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.frequency * t, p.sign * p.ratio);
                         });
  exercise.misconception("phase_subtracted", "You subtract the phase; the slides add it.", "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, p.frequency * t - phase, p.sign * p.ratio);
                         });
  exercise.misconception("time_lost", "Your result does not depend on time.", "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(amplitude, phase, p.sign * p.ratio);
                         });
  exercise.misconception("sine_and_cosine_exchanged",
                         "Sine and cosine are exchanged: ω₁ takes the cosine, ω₂ the sine.", "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           const double angle = p.frequency * t + phase;
                           return amplitude * Vector2d(std::sin(angle), p.sign * p.ratio * std::cos(angle));
                         });
  exercise.misconception("amplitude_lost", "The amplitude does not enter; both components are proportional to it.",
                         "free_tops_linear",
                         [=](const Vector3d& I, double omega3, double, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           return wobble(1, p.frequency * t + phase, p.sign * p.ratio);
                         });
  exercise.misconception("hyperbolic", "You use cosh and sinh; about a stable axis Ω₁Ω₂ > 0, and the wobble swings.",
                         "free_tops_stability",
                         [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                           const Parts p = parts(I, omega3);
                           const double angle = p.frequency * t + phase;
                           return amplitude * Vector2d(std::cosh(angle), p.sign * p.ratio * std::sinh(angle));
                         });
  exercise.angles_read_as_degrees("free_tops_linear");

  exercise.route("sign and ratio apart",
                 [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                   const Parts p = parts(I, omega3);
                   return wobble(amplitude, p.frequency * t + phase, std::copysign(p.ratio, p.rates[1]));
                 });
  exercise.route("turning an initial vector",
                 [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                   // x and y/ratio turn like the hand of a clock, in the sense of Ω1.
                   const Parts p = parts(I, omega3);
                   const std::complex<double> start = std::polar(amplitude, p.sign * phase);
                   const std::complex<double> now = start * std::polar(1.0, p.sign * p.frequency * t);
                   return {now.real(), p.ratio * now.imag()};
                 });
  exercise.route("step by step",
                 [=](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
                   const Vector2d rates = linearized_rates(I, omega3);
                   Eigen::Matrix2d system;
                   system << 0, -rates[0], rates[1], 0;
                   Vector2d omega = linearized_top(I, omega3, amplitude, phase, 0);
                   const int steps = 4000;
                   const Eigen::Matrix2d h = system * (t / steps);
                   const Eigen::Matrix2d step =
                       Eigen::Matrix2d::Identity() +
                       h * (Eigen::Matrix2d::Identity() +
                            h / 2 * (Eigen::Matrix2d::Identity() + h / 3 * (Eigen::Matrix2d::Identity() + h / 4)));
                   for (int i = 0; i < steps; ++i) omega = step * omega;
                   return omega;
                 });
  exercise.route(
      "frequency from the moments",
      [](const Vector3d& I, double omega3, double amplitude, double phase, double t) -> Vector2d {
        const double a = I[2] - I[1], b = I[2] - I[0];
        const double angle = std::abs(omega3) * std::sqrt(a * b / (I[0] * I[1])) * t + phase;
        const double side = omega3 * a > 0 ? 1 : -1;
        return {amplitude * std::cos(angle), side * amplitude * std::sqrt(b * I[0] / (a * I[1])) * std::sin(angle)};
      });

  exercise.sweep({"I = (2, 3, 1) kg m², ω₃ = 5 rad/s, A = 0.01 rad/s, φ = 0.3: both rates are negative", "time (s)",
                  "body component of ω (rad/s)"},
                 {0, 3},
                 [](double t) {
                   return Wobble{Vector3d(2, 3, 1), 5, 0.01, 0.3, t};
                 },
                 {{"omega_1", 0, 0}, {"omega_2", 1, 0}});
}

void describe_axis_stability(Lecture& lecture) {
  auto& exercise = lecture.exercise("axis_stability", &axis_stability);
  exercise.argument("I", units::moment_of_inertia).argument("axis", units::none).result("stability", units::none);

  exercise.worked("moments 2, 3, 1: the intermediate moment", Vector3d(2, 3, 1), 0);
  exercise.worked("moments 2, 3, 1: the largest moment", Vector3d(2, 3, 1), 1);
  exercise.worked("moments 2, 3, 1: the smallest moment", Vector3d(2, 3, 1), 2);
  exercise.worked("moments 3, 2, 1: the intermediate moment", Vector3d(3, 2, 1), 1);
  exercise.worked("a flattened symmetric top about its symmetry axis", Vector3d(1, 1, 1.8), 2);
  exercise.worked("a flattened symmetric top across its symmetry axis", Vector3d(1, 1, 1.8), 0);
  exercise.worked("a long symmetric top about its symmetry axis", Vector3d(2, 0.5, 2), 1);
  exercise.worked("a long symmetric top across its symmetry axis", Vector3d(2, 0.5, 2), 2);
  exercise.worked("a sphere", Vector3d(2, 2, 2), 1);
  exercise.special("moments that differ by a thousandth, about the middle one", Vector3d(1.001, 1, 1.002), 0);
  exercise.special("moments that differ by a thousandth, about the largest", Vector3d(1.001, 1, 1.002), 2);
  for (int axis = 0; axis < 3; ++axis) {
    exercise.random("a random body, axis " + std::to_string(axis), 4, [axis](Random& random) {
      return std::tuple<Vector3d, int>{random.principal_moments(), axis};
    });
  }
  exercise.scale([](const Vector3d&, int) { return 1.0; });

  // What a wrong rule makes of ties is its author's choice: each comes in the plausible versions, with one message.
  const auto others = [](const Vector3d& I, int axis) { return Vector2d(I[(axis + 1) % 3], I[(axis + 2) % 3]); };
  const auto tied = [others](const Vector3d& I, int axis) { return (others(I, axis).array() == I[axis]).any(); };
  const std::string only_largest = "You call only the axis of the largest moment stable; so is that of the smallest.";
  const std::string only_smallest = "You call only the axis of the smallest moment stable; so is that of the largest.";
  const std::string by_number =
      "You go by the number of the axis; what counts is which moment lies between the other two.";
  const std::string ties =
      "Where another moment equals this one the axis is neutral, 0: neither does a disturbance stay small, nor does it "
      "grow exponentially.";
  for (const int at_tie : {0, 1, -1}) {
    const std::string version = at_tie == 0 ? "" : at_tie > 0 ? "_ties_stable" : "_ties_unstable";
    exercise.misconception("only_largest" + version, only_largest, "free_tops_stability",
                           [=](const Vector3d& I, int axis) {
                             return tied(I, axis) ? at_tie : I[axis] > others(I, axis).maxCoeff() ? 1 : -1;
                           });
    exercise.misconception("only_smallest" + version, only_smallest, "free_tops_stability",
                           [=](const Vector3d& I, int axis) {
                             return tied(I, axis) ? at_tie : I[axis] < others(I, axis).minCoeff() ? 1 : -1;
                           });
    exercise.misconception("by_number" + version, by_number, "free_tops_stability", [=](const Vector3d& I, int axis) {
      return tied(I, axis) ? at_tie : axis == 1 ? -1 : 1;
    });
    if (at_tie != 0) {
      exercise.misconception(
          "no_neutral_axis" + version, ties, "free_tops_stability",
          [=](const Vector3d& I, int axis) { return tied(I, axis) ? at_tie : axis_stability(I, axis); });
    }
  }
  exercise.misconception("largest_with_ties", only_largest, "free_tops_stability",
                         [](const Vector3d& I, int axis) { return I[axis] == I.maxCoeff() ? 1 : -1; });
  exercise.misconception("smallest_with_ties", only_smallest, "free_tops_stability",
                         [](const Vector3d& I, int axis) { return I[axis] == I.minCoeff() ? 1 : -1; });
  exercise.misconception("by_number_alone", by_number, "free_tops_stability",
                         [](const Vector3d&, int axis) { return axis == 1 ? -1 : 1; });
  exercise.misconception("opposite", "Stable and unstable are exchanged: +1 means stable.", "free_tops_stability",
                         [](const Vector3d& I, int axis) { return -axis_stability(I, axis); });
  exercise.misconception("counted_from_one", "You count the axes from 1; here they are 0, 1 and 2.",
                         "free_tops_stability",
                         [](const Vector3d& I, int axis) { return axis_stability(I, (axis + 2) % 3); });
  exercise.misconception("symmetric_top_neutral",
                         "You call every axis of a body with two equal moments neutral; its symmetry axis is stable.",
                         "free_tops_stability", [](const Vector3d& I, int axis) {
                           const bool symmetric = I[0] == I[1] || I[1] == I[2] || I[2] == I[0];
                           return symmetric ? 0 : axis_stability(I, axis);
                         });
  exercise.misconception(
      "unstable_as_neutral",
      "You return 0 for the intermediate axis; a disturbance grows there exponentially, so it is −1.",
      "free_tops_stability", [](const Vector3d& I, int axis) { return std::max(axis_stability(I, axis), 0); });
  exercise.misconception("always_stable", "You call every axis stable; the intermediate one is not.",
                         "free_tops_stability", [](const Vector3d&, int) { return 1; });
  exercise.misconception("compares_one_neighbour", "You compare with only one of the other two moments; both decide.",
                         "free_tops_stability", [](const Vector3d& I, int axis) {
                           const double difference = I[axis] - I[(axis + 1) % 3];
                           return (difference > 0) - (difference < 0);
                         });

  exercise.route("rank among the moments", [](const Vector3d& I, int axis) {
    const auto smaller = (I.array() < I[axis]).count();
    const auto larger = (I.array() > I[axis]).count();
    if (smaller + larger < 2) return 0;
    return smaller == larger ? -1 : 1;
  });
  exercise.route("signs of the two rates", [](const Vector3d& I, int axis) {
    const Vector3d turned_round(I[(axis + 1) % 3], I[(axis + 2) % 3], I[axis]);  // the axis in question becomes axis 3
    const double product = linearized_rates(turned_round, 1).prod();
    return product > 0 ? 1 : product < 0 ? -1 : 0;
  });
  exercise.route("sorted", [](const Vector3d& I, int axis) {
    Vector3d sorted = I;
    std::sort(sorted.begin(), sorted.end());
    const double own = I[axis];
    if ((own == sorted[0] && own == sorted[1]) || (own == sorted[1] && own == sorted[2])) return 0;
    return own == sorted[1] ? -1 : 1;
  });

  exercise.sweep({"Spin about axis 3 of a body with I₁ = 2, I₂ = 3 kg m²", "I₃ (kg m²)", "stability"}, {1, 5, 60},
                 [](double I3) {
                   return std::tuple<Vector3d, int>{Vector3d(2, 3, I3), 2};
                 },
                 {{"stability", 0, 0}});
}

void describe_growth_rate(Lecture& lecture) {
  auto& exercise = lecture.exercise("growth_rate", &growth_rate);
  exercise.argument("I_ascending", units::moment_of_inertia)
      .argument("omega2", units::radian_per_second)
      .result("sigma", per_second);

  exercise.worked("moments 1, 2, 3", Vector3d(1, 2, 3), 1.5);
  exercise.worked("moments 2, 3, 4 and the other sense", Vector3d(2, 3, 4), -2.5);
  exercise.special("I1 = I2", Vector3d(2, 2, 3), 1.5);
  exercise.special("I2 = I3", Vector3d(1, 2, 2), 1.5);
  exercise.special("a sphere", Vector3d(2, 2, 2), 1.5);
  exercise.special("no spin", Vector3d(1, 2, 3), 0.0);
  exercise.special("moments that differ by a millionth", Vector3d(1, 1 + 1e-6, 1 + 2e-6), 1.5);
  exercise.random("a random body", 10, [](Random& random) {
    const Vector3d I = random.ascending_moments();
    return Spin{I, random.sign() * random.uniform(0.5, 4)};
  });
  exercise.scale([](const Vector3d&, double omega2) { return or_one(std::abs(omega2)); });

  const auto product = [](const Vector3d& I) { return (I[1] - I[0]) * (I[2] - I[1]); };
  exercise.misconception("squared", "This is σ²: the square root is missing.", "free_tops_growth",
                         [](const Vector3d& I, double omega2) { return std::pow(growth_rate(I, omega2), 2); });
  exercise.misconception(
      "no_root_of_moments", "The square root is missing over the moments of inertia.", "free_tops_growth",
      [product](const Vector3d& I, double omega2) { return std::abs(omega2) * product(I) / (I[0] * I[2]); });
  exercise.misconception("spin_dropped", "ω₂ does not enter; σ is proportional to the spin.", "free_tops_growth",
                         [](const Vector3d& I, double) { return growth_rate(I, 1); });
  const std::string own_moment =
      "I₂ stands in your denominator; there it takes the moments of the two other axes, I₁I₃.";
  exercise.misconception(
      "own_moment_squared", own_moment, "free_tops_growth",
      [product](const Vector3d& I, double omega2) { return std::abs(omega2) * std::sqrt(product(I)) / I[1]; });
  exercise.misconception(
      "own_moment_for_third", own_moment, "free_tops_growth",
      [product](const Vector3d& I, double omega2) { return std::abs(omega2) * std::sqrt(product(I) / (I[0] * I[1])); });
  exercise.misconception(
      "own_moment_for_first", own_moment, "free_tops_growth",
      [product](const Vector3d& I, double omega2) { return std::abs(omega2) * std::sqrt(product(I) / (I[1] * I[2])); });
  exercise.misconception(
      "negative_for_negative_spin",
      "Your rate is negative when ω₂ is; a disturbance grows in either sense of the spin.", "free_tops_growth",
      [](const Vector3d& I, double omega2) { return std::copysign(growth_rate(I, omega2), omega2); });
  exercise.misconception("decaying",
                         "This is −σ, the rate of the dying part of the disturbance; what is left soon grows with +σ.",
                         "free_tops_growth", [](const Vector3d& I, double omega2) { return -growth_rate(I, omega2); });
  const auto swing = [](const Vector3d& I, double omega, int axis) {
    const Vector3d turned_round(I[(axis + 1) % 3], I[(axis + 2) % 3], I[axis]);
    return std::sqrt(linearized_rates(turned_round, omega).prod());
  };
  exercise.misconception(
      "about_the_largest",
      "This is the frequency of a wobble about axis 3, which is stable; asked for is a spin about axis 2.",
      "free_tops_stability", [swing](const Vector3d& I, double omega2) { return swing(I, omega2, 2); });
  exercise.misconception(
      "about_the_smallest",
      "This is the frequency of a wobble about axis 1, which is stable; asked for is a spin about axis 2.",
      "free_tops_stability", [swing](const Vector3d& I, double omega2) { return swing(I, omega2, 0); });
  exercise.misconception("time", "This is the time 1/σ in which a disturbance grows e-fold; asked for is the rate.",
                         "free_tops_growth", [](const Vector3d& I, double omega2) {
                           const double rate = growth_rate(I, omega2);
                           return rate > 0 ? 1 / rate : 0.0;
                         });
  exercise.misconception("period", "This is 2π/σ; a growing disturbance has no period, and asked for is its rate.",
                         "free_tops_growth", [](const Vector3d& I, double omega2) {
                           const double rate = growth_rate(I, omega2);
                           return rate > 0 ? 2 * pi / rate : 0.0;
                         });
  exercise.misconception("over_two_pi", "You divide by 2π; σ is a rate of growth, not a frequency in turns.",
                         "free_tops_growth",
                         [](const Vector3d& I, double omega2) { return growth_rate(I, omega2) / (2 * pi); });
  exercise.misconception(
      "outer_difference", "You take I₃ − I₁; it is the differences to the intermediate moment that count.",
      "free_tops_growth",
      [](const Vector3d& I, double omega2) { return std::abs(omega2) * (I[2] - I[0]) / std::sqrt(I[0] * I[2]); });
  exercise.misconception(
      "not_divided", "You leave out the division by I₁I₃.", "free_tops_growth",
      [product](const Vector3d& I, double omega2) { return std::abs(omega2) * std::sqrt(product(I)); });
  exercise.property(PropertyKind::nonnegative, "The rate of growth is never negative.", "free_tops_growth");

  exercise.route("root by root", [](const Vector3d& I, double omega2) {
    return std::sqrt((I[1] - I[0]) / I[2]) * std::sqrt((I[2] - I[1]) / I[0]) * std::abs(omega2);
  });
  exercise.route("an eigenvalue of the linearized equations", [](const Vector3d& I, double omega2) {
    Matrix3d system = Matrix3d::Zero();
    system(0, 2) = (I[1] - I[2]) / I[0] * omega2;
    system(2, 0) = (I[0] - I[1]) / I[2] * omega2;
    return std::sqrt((system * system).trace() / 2);
  });
  exercise.route("from the two rates", [](const Vector3d& I, double omega2) {
    const Vector2d rates = linearized_rates({I[2], I[0], I[1]}, omega2);  // axis 2 becomes axis 3
    return std::sqrt(std::max(0.0, -rates[0] * rates[1]));
  });

  exercise.sweep({"I₁ = 2, I₃ = 3 kg m², ω₂ = 1 rad/s: fastest where I₂ lies half-way", "I₂ (kg m²)", "σ (1/s)"},
                 {2, 3},
                 [](double I2) {
                   return Spin{Vector3d(2, I2, 3), 1};
                 },
                 {{"sigma", 0, 0}});
}

/// λ and m of the exact solution, by differences that do not cancel.
struct EllipticMotion {
  double lambda;
  double m;
  double complement;  // 1 − m
};

EllipticMotion elliptic_motion(const Vector3d& I, const Vector3d& omega) {
  const Vector3d squares = omega.cwiseAbs2();
  // L² − 2T I_k, each as a sum over the two other axes.
  const double above_first = I[1] * (I[1] - I[0]) * squares[1] + I[2] * (I[2] - I[0]) * squares[2];
  const double above_second = I[0] * (I[0] - I[1]) * squares[0] + I[2] * (I[2] - I[1]) * squares[2];
  const double below_third = I[0] * (I[2] - I[0]) * squares[0] + I[1] * (I[2] - I[1]) * squares[1];
  const double third = above_first * (I[2] - I[1]), first = below_third * (I[1] - I[0]);
  const double steady = std::max(third, first);
  return {std::sqrt(steady / I.prod()), std::min(third, first) / steady,
          (I[2] - I[0]) * std::abs(above_second) / steady};
}

void describe_tumbling_period(Lecture& lecture) {
  using Motion = std::tuple<Vector3d, Vector3d>;
  auto& exercise = lecture.exercise("tumbling_period", &tumbling_period);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega0", units::radian_per_second)
      .result("period", units::second);

  exercise.worked("a flip: moments 1, 2, 3, spin about axis 2, disturbed", Vector3d(1, 2, 3), Vector3d(0.1, 1, 0.1));
  exercise.worked("round axis 1", Vector3d(1, 2, 3), Vector3d(1, 0.5, 0.25));
  exercise.special("a spin about axis 3 alone", Vector3d(1, 2, 3), Vector3d(0, 0, 2));
  exercise.special("a spin about axis 1 alone", Vector3d(1, 2, 3), Vector3d(-2, 0, 0));
  exercise.special("a flattened symmetric top", Vector3d(1, 1, 1.5), Vector3d(0.5, 0.25, 2));
  exercise.special("a long symmetric top", Vector3d(0.5, 1, 1), Vector3d(2, 0.5, 0.25));
  exercise.special("close to the separatrix, on the side of axis 3", Vector3d(1, 2, 3), Vector3d(0, 1, 1e-3));
  exercise.special("close to the separatrix, on the side of axis 1", Vector3d(1, 2, 3), Vector3d(1e-3, -1, 0));
  exercise.random("a random motion", 10, [](Random& random) {
    // Where m is small K(m) hardly depends on it; where m is close to 1 a right answer loses digits.
    while (true) {
      const Vector3d I = random.ascending_moments(), omega = random.vector(3);
      const double m = elliptic_motion(I, omega).m;
      if (m > 0.2 && m < 0.95) return Motion{I, omega};
    }
  });

  const auto period = [](const EllipticMotion& motion) {
    return 4 * boost::math::ellint_rf(0.0, motion.complement, 1.0) / motion.lambda;
  };
  exercise.misconception("half",
                         "This is half the period, 2K/λ: after it two components have changed their signs, and only "
                         "after 4K/λ is ω the same again.",
                         "free_tops_period", [period](const Vector3d& I, const Vector3d& omega) {
                           return period(elliptic_motion(I, omega)) / 2;
                         });
  exercise.misconception(
      "quarter", "This is K/λ, a quarter of the period.", "free_tops_period",
      [period](const Vector3d& I, const Vector3d& omega) { return period(elliptic_motion(I, omega)) / 4; });
  exercise.misconception("parameter_as_modulus",
                         "You pass the parameter m where your library expects the modulus k = √m.", "free_tops_modulus",
                         [](const Vector3d& I, const Vector3d& omega) {
                           const EllipticMotion motion = elliptic_motion(I, omega);
                           return 4 * boost::math::ellint_1(motion.m) / motion.lambda;
                         });
  exercise.misconception("root_taken_twice", "You take the root of m twice: K gets the modulus k = √m, once.",
                         "free_tops_modulus", [](const Vector3d& I, const Vector3d& omega) {
                           const EllipticMotion motion = elliptic_motion(I, omega);
                           return 4 * boost::math::ellint_1(std::pow(motion.m, 0.25)) / motion.lambda;
                         });
  exercise.misconception("complementary_parameter",
                         "You pass 1 − m for m: that is the complementary integral, and it belongs to imaginary time.",
                         "free_tops_modulus", [](const Vector3d& I, const Vector3d& omega) {
                           const EllipticMotion motion = elliptic_motion(I, omega);
                           return 4 * boost::math::ellint_rf(0.0, std::max(motion.m, 1e-300), 1.0) / motion.lambda;
                         });
  exercise.misconception(
      "no_elliptic_integral", "This is 2π/λ, as if K were π/2; that holds only in the limit m → 0.", "free_tops_period",
      [](const Vector3d& I, const Vector3d& omega) { return 2 * pi / elliptic_motion(I, omega).lambda; });
  const auto small_wobble = [](const Vector3d& I, const Vector3d& omega, int axis) {
    const Vector3d turned_round(I[(axis + 1) % 3], I[(axis + 2) % 3], I[axis]);
    const double rate = std::sqrt(std::abs(linearized_rates(turned_round, omega[axis]).prod()));
    return rate > 0 ? 2 * pi / rate : 0.0;
  };
  exercise.misconception("small_wobble_about_3",
                         "This is 2π/√(Ω₁Ω₂), the period of a small wobble about axis 3; the motion here is not small.",
                         "free_tops_period", [small_wobble](const Vector3d& I, const Vector3d& omega) {
                           return small_wobble(I, omega, 2);
                         });
  exercise.misconception(
      "small_wobble_about_1", "This is the period of a small wobble about axis 1; the motion here is not small.",
      "free_tops_period",
      [small_wobble](const Vector3d& I, const Vector3d& omega) { return small_wobble(I, omega, 0); });
  exercise.misconception(
      "growth_as_frequency",
      "This is 2π/σ with the growth rate of the unstable axis; the time between flips is no such period.",
      "free_tops_flip", [](const Vector3d& I, const Vector3d& omega) {
        const double rate = growth_rate(I, omega[1]);
        return rate > 0 ? 2 * pi / rate : 0.0;
      });
  exercise.misconception("turn_of_the_body",
                         "This is 2π/|ω|, about the time of one turn of the body in space; ω repeats itself in the "
                         "body after another time.",
                         "free_tops_period",
                         [](const Vector3d&, const Vector3d& omega) { return 2 * pi / omega.norm(); });
  exercise.misconception("lambda_dropped", "This is 4K(m), a pure number; dividing by λ makes it a time.",
                         "free_tops_period", [period](const Vector3d& I, const Vector3d& omega) {
                           const EllipticMotion motion = elliptic_motion(I, omega);
                           return period(motion) * motion.lambda;
                         });
  exercise.misconception("lambda_squared", "You divide by λ²; its root is missing.", "free_tops_period",
                         [period](const Vector3d& I, const Vector3d& omega) {
                           const EllipticMotion motion = elliptic_motion(I, omega);
                           return period(motion) / motion.lambda;
                         });
  exercise.misconception("logarithm",
                         "This is the law ln(16/(1 − m)) that holds close to the separatrix; here it is not exact.",
                         "free_tops_flip", [](const Vector3d& I, const Vector3d& omega) {
                           const EllipticMotion motion = elliptic_motion(I, omega);
                           return 2 * std::log(16 / motion.complement) / motion.lambda;
                         });

  exercise.route("arithmetic-geometric mean", [](const Vector3d& I, const Vector3d& omega) {
    const EllipticMotion motion = elliptic_motion(I, omega);
    double a = 1, b = std::sqrt(motion.complement);
    for (int i = 0; i < 60; ++i) {
      const double mean = (a + b) / 2;
      b = std::sqrt(a * b);
      a = mean;
    }
    return 2 * pi / (a * motion.lambda);
  });
  exercise.route("the textbook formula", [](const Vector3d& I, const Vector3d& omega) {
    const double twice_energy = I.dot(omega.cwiseAbs2()), momentum_squared = I.cwiseProduct(omega).squaredNorm();
    const bool about_3 = momentum_squared > twice_energy * I[1];
    const double I1 = about_3 ? I[0] : I[2], I2 = I[1], I3 = about_3 ? I[2] : I[0];
    const double lambda = std::sqrt((momentum_squared - twice_energy * I1) * (I3 - I2) / (I1 * I2 * I3));
    const double m =
        (twice_energy * I3 - momentum_squared) * (I2 - I1) / ((momentum_squared - twice_energy * I1) * (I3 - I2));
    return 4 * std::comp_ellint_1(std::sqrt(m)) / lambda;
  });
  exercise.route("quadrature of the elliptic integral", [](const Vector3d& I, const Vector3d& omega) {
    // The integrand is periodic, so the trapezoidal rule converges exponentially; near m = 1 it needs many nodes.
    const EllipticMotion motion = elliptic_motion(I, omega);
    const int nodes = 60000;
    double sum = 0;
    for (int i = 0; i < nodes; ++i) {
      const double alpha = 2 * pi * (i + 0.5) / nodes;
      sum += 1 / std::sqrt(std::pow(std::cos(alpha), 2) + motion.complement * std::pow(std::sin(alpha), 2));
    }
    return 2 * pi / nodes * sum / motion.lambda;
  });
  exercise.route("the exact motion's own period", [](const Vector3d& I, const Vector3d& omega) {
    const ExactTop top(I, omega);
    // A steady rotation has no period of its own: there the question is for the limit of small wobbles.
    return top.rate() > 0 ? top.period() : 2 * pi / elliptic_motion(I, omega).lambda;
  });
  exercise.route("Boost's complete integral", [](const Vector3d& I, const Vector3d& omega) {
    const EllipticMotion motion = elliptic_motion(I, omega);
    return 4 * boost::math::ellint_1(std::sqrt(motion.m)) / motion.lambda;
  });

  exercise.sweep({"I = (1, 2, 3) kg m², ω₁ = 1, ω₂ = 0.5 rad/s: from axis 1 across the separatrix to axis 3",
                  "ω₃ (rad/s)", "period (s)"},
                 {0.05, 1.5},
                 [](double omega3) {
                   return Motion{Vector3d(1, 2, 3), Vector3d(1, 0.5, omega3)};
                 },
                 {{"period", 0, 0}});
}

}  // namespace

void workbook::judging::describe(Lecture& lecture) {
  describe_body_precession_rate(lecture);
  describe_symmetric_top(lecture);
  describe_space_precession_rate(lecture);
  describe_linearized_rates(lecture);
  describe_linearized_top(lecture);
  describe_axis_stability(lecture);
  describe_growth_rate(lecture);
  describe_tumbling_period(lecture);
}
