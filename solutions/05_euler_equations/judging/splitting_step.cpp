#include "solutions/05_euler_equations/shared.hpp"

namespace {

struct Stage {
  int axis;
  double time;
};
using Stages = std::initializer_list<Stage>;

/// ω after some stages, each of which turns L about an axis by the angle that `angle` makes of L and the stage.
template <class Angle>
Vector3d after(const Vector3d& I, const Vector3d& w, Stages stages, const Angle& angle) {
  Vector3d L = L_of(I, w);
  for (const Stage& stage : stages) L = turn(Vector3d::Unit(stage.axis), angle(L, stage)) * L;
  return L.cwiseQuotient(I);
}
Vector3d after(const Vector3d& I, const Vector3d& w, Stages stages) {
  return after(I, w, stages, [&](auto& L, auto& stage) { return -stage.time * L[stage.axis] / I[stage.axis]; });
}

/// The five stages of the problem, one after the other.
template <class Follow>
void five_stages(double h, const Follow& each) {
  for (const auto& [axis, time] : Stages{{0, h / 2}, {1, h / 2}, {2, h}, {1, h / 2}, {0, h / 2}}) each(axis, time);
}

}  // namespace

void judge_splitting_step(Lecture& lecture) {
  auto& e = lecture.exercise(&splitting_step, {{"I", positive(kg_m2)}, {"omega", rad_per_s}, {"h", second}},
                             {"omega", rad_per_s});
  // Beyond some turns an answer that integrates the stages loses digits.
  e.generated([](auto& I, auto& w, auto h) { return abs(h) * L_of(I, w).norm() < 10 * I.minCoeff(); });
  e.worked("moments 1, 2, 3, a large step", example_moments, example_omega, 0.8);
  e.worked("a step back in time", {2.7, 1.2, 2}, {1, 2, -3}, -0.3);
  e.special("a spin about axis 3 alone", example_moments, {0, 0, 5}, 2);
  e.special("no step", example_moments, example_omega, 0);
  e.special("a sphere", {2, 2, 2}, example_omega, 0.8);
  e.special("a symmetric body", {1, 1, 1.8}, example_omega, 0.8);
  e.special("a slow body, a step of months", example_moments, 1e-7 * example_omega, 8e6);
  e.special("no rotation", example_moments, zero, 0.8);
  e.limit("no step", example_omega, "No time passes.");
  e.limit("a spin about axis 3 alone", {0, 0, 5},
          "L lies on the axis about which the third term turns it, and the two others are zero.");
  e.random("a random body", 10, &Random::principal_moments, any::vector(2), any::spin(0.3, 1));
  e.scale([](auto& I, auto& w, auto) { return or_one(L_of(I, w).norm() / I.minCoeff()); });
  e.sweep<2>(
      {"One step from ω = (0.3, −0.2, 0.5) rad/s, moments 1, 2, 3 kg m²", "step h (s)", "body component of ω (rad/s)"},
      {"omega_1", "omega_2", "omega_3"}, {-6, 6});

  e.wrong_input<2>(
      "This is the step backwards: L turns the wrong way. The body turns about ω, and sees L turn against it.", "sense",
      negated);
  e.wrong("The order of the axes is 3, 2, 1, 2, 3 here; the first term comes first and last.", "other_order",
          [](auto& I, auto& w, auto h) {
            return after(I, w, {{2, h / 2}, {1, h / 2}, {0, h}, {1, h / 2}, {2, h / 2}});
          });
  e.wrong("These are three stages of full length, 1, 2, 3; the first two terms come twice, for half the step each.",
          "first_order", [](auto& I, auto& w, auto h) {
            return after(I, w, {{0, h}, {1, h}, {2, h}});
          });
  e.wrong("All five stages last half of the step here; the one in the middle lasts the whole step.", "all_halves",
          [](auto& I, auto& w, auto h) {
            return after(I, w, {{0, h / 2}, {1, h / 2}, {2, h / 2}, {1, h / 2}, {0, h / 2}});
          });
  e.wrong("All angles belong to ω at the start; each stage begins with the L that the one before it left.",
          "frozen_rates", [](auto& I, auto& w, auto h) {
            return after(I, w, {{0, h / 2}, {1, h / 2}, {2, h}, {1, h / 2}, {0, h / 2}},
                         [&](auto&, auto& stage) { return -stage.time * w[stage.axis]; });
          });
  e.wrong("The last two stages turn by the angles of the second and the first; L has changed since then.",
          "angles_reused", [](auto& I, auto& w, auto h) {
            Vector3d first_angles = Vector3d::Constant(std::nan(""));
            return after(I, w, {{0, h / 2}, {1, h / 2}, {2, h}, {1, h / 2}, {0, h / 2}}, [&](auto& L, auto& stage) {
              double& first = first_angles[stage.axis];
              if (std::isnan(first)) first = -stage.time * L[stage.axis] / I[stage.axis];
              return first;
            });
          });
  e.wrong(
      "Each stage is the midpoint rule here, which takes the half angle for its tangent; L turns by the whole angle "
      "exactly.",
      "midpoint_stages", [](auto& I, auto& w, auto h) {
        return after(I, w, {{0, h / 2}, {1, h / 2}, {2, h}, {1, h / 2}, {0, h / 2}},
                     [&](auto& L, auto& stage) { return -2 * atan(stage.time * L[stage.axis] / I[stage.axis] / 2); });
      });
  e.wrong("Your stages turn ω itself; what keeps its length in each stage is L.", "omega_turned",
          [](auto&, auto& w, auto h) {
            const Vector3d ones = Vector3d::Ones();
            return after(ones, w, {{0, h / 2}, {1, h / 2}, {2, h}, {1, h / 2}, {0, h / 2}});
          });
  e.wrong({"This is the free rotation itself after the time h; the five stages only come near it.",
           "euler_equations_exact"},
          "exact_motion", [](auto& I, auto& w, auto h) { return ExactTop(I, w).omega(h); });
  e.conserves({"Every stage turns L and leaves its length.", "euler_equations_invariants"},
              [](auto& I, auto&...) { return Vector3d(I.cwiseAbs2()); });
  e.route("complex numbers", [](auto& I, auto& w, auto h) -> Vector3d {
    Vector3d L = L_of(I, w);
    five_stages(h, [&](int i, double time) {
      double &one = L[(i + 1) % 3], &other = L[(i + 2) % 3];
      const auto turned = std::complex(one, other) * polar(1.0, -L[i] * time / I[i]);
      one = turned.real();
      other = turned.imag();
    });
    return L.cwiseQuotient(I);
  });
  e.route("each stage integrated", [](auto& I, auto& w, auto h) -> Vector3d {
    Vector3d L = L_of(I, w);
    five_stages(h, [&](int i, double time) {
      const auto rate = [&](const Vector3d& now) { return cross(now, now[i] / I[i] * Vector3d::Unit(i)); };
      L = followed(L, time, 2000, rate);
    });
    return L.cwiseQuotient(I);
  });
  e.route("the attitude of the body, with L at rest in space", [](auto& I, auto& w, auto h) -> Vector3d {
    const Vector3d L = L_of(I, w);
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
    five_stages(h, [&](int i, double time) {
      const double rate = (attitude.conjugate() * L)[i] / I[i];
      attitude = attitude * Eigen::AngleAxisd(rate * time, Vector3d::Unit(i));
    });
    return Vector3d(attitude.conjugate() * L).cwiseQuotient(I);
  });
}
