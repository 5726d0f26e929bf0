#include "solutions/10_attitude_of_a_free_body/shared.hpp"

#include <boost/math/quadrature/gauss.hpp>

namespace {

/// The turn about L through an angle, in inertial components.
Matrix3d about_L(const Vector3d& I, const Vector3d& w, double angle) {
  return turn(L_of(I, w), std::fmod(angle, 2 * pi));
}

/// What makes a whole number of the number of periods.
using Whole = double (*)(double);

/// The number of whole periods in t, and what is left of it.
struct Split {
  Split(const Vector3d& I, const Vector3d& w, double t, Whole whole_of = std::floor) {
    const double P = ExactTop(I, w).period();
    whole = whole_of(t / P);
    rest = std::fma(-whole, P, t);
  }
  double whole, rest;
};

/// The attitude after whole periods of a turn of one's own about L.
template <class Turn>
auto with_turn(const Turn& turn_in_a_period, Whole whole_of) {
  return [=](const Vector3d& I, const Vector3d& w, double t) {
    const Split time(I, w, t, whole_of);
    return about_L(I, w, time.whole * turn_in_a_period(I, w)) * exact_attitude(I, w, time.rest);
  };
}

/// The attitude in the frame whose third axis is along L and whose first one points to the side of axis 1.
Matrix3d beside_L(const Vector3d& L) {
  const Vector3d up = L.normalized(), along = x_axis, first = (along - along.dot(up) * up).normalized();
  return columns(first, cross(up, first), up).transpose();
}

Matrix3d turns_and_rest(const Vector3d& I, const Vector3d& w, double t) {
  const Split time(I, w, t);
  return about_L(I, w, time.whole * turn_per_period(I, w)) * integrated(I, w, time.rest).A;
}

Matrix3d power_of_a_period(const Vector3d& I, const Vector3d& w, double t) {
  const Split time(I, w, t);
  const double P = ExactTop(I, w).period();
  Eigen::Quaterniond factor(integrated(I, w, time.whole < 0 ? -P : P).A), power(integrated(I, w, time.rest).A);
  for (auto n = static_cast<long>(abs(time.whole)); n > 0; n /= 2) {
    if (n % 2 == 1) power = (factor * power).normalized();
    factor = (factor * factor).normalized();
  }
  return power.toRotationMatrix();
}

Matrix3d axis_1_followed(const Vector3d& I, const Vector3d& w, double t) {
  const Split time(I, w, t);
  const ExactTop top(I, w);
  const auto rate = [&](double at) { return rate_about_L(I, top.omega(at), 0); };
  const double in_a_period = over_a_period(I, w, [&](const Vector3d& now) { return rate_about_L(I, now, 0); });
  double angle = std::fmod(time.whole * in_a_period, 2 * pi);
  constexpr int pieces = 40;
  const double h = time.rest / pieces;
  for (int i = 0; i < pieces; ++i)
    angle += boost::math::quadrature::gauss<double, 15>::integrate(rate, i * h, (i + 1) * h);
  return beside_L(L_of(I, w)).transpose() * turn(z_axis, angle) * beside_L(L_of(I, top.omega(time.rest)));
}

/// The wrong answers that are known.
template <class Exercise>
void mistakes_of_exact_attitude(Exercise& e) {
  e.wrong_output("This is the transposed matrix: the principal axes are its rows; they should be its columns.",
                 "transposed", transposed);
  const auto upright = [](auto& I, auto& w) -> Matrix3d {
    const Vector3d L = L_of(I, w);
    return turn(y_axis, atan2(hypot(L[0], L[1]), L[2])) * turn(z_axis, atan2(L[1], -L[0]));
  };
  e.wrong("This is the attitude in a frame with L upright; at time 0 it is not the unit matrix.", "L_upright",
          [=](auto& I, auto& w, auto t) -> Matrix3d { return upright(I, w) * exact_attitude(I, w, t); });
  e.wrong(
      "The way back to the frame of time 0 stands on the right here; it takes inertial components, so that it acts "
      "last "
      "and stands on the left.",
      "start_on_the_right", [=](auto& I, auto& w, auto t) -> Matrix3d {
        return upright(I, w) * exact_attitude(I, w, t) * upright(I, w).transpose();
      });
  // The remainder of t may be counted from the period before, from that towards 0, or from the nearest one.
  const std::tuple<std::string, Whole> countings[] = {
      {"", std::floor}, {"_towards_0", std::trunc}, {"_nearest", std::round}};
  for (const auto& [counting, whole_of] : countings) {
    e.wrong(
        "This is the attitude at the remainder of t after whole periods; in each of these the body has turned about L.",
        "no_turn" + counting, with_turn([](auto&, auto&) { return 0.0; }, whole_of));
    e.wrong("The body turns about L in the wrong sense in whole periods; axis 3 goes round L in the positive one.",
            "turn_reversed" + counting, with_turn([](auto& I, auto& w) { return -turn_per_period(I, w); }, whole_of));
    e.wrong(
        "The turn about L of the whole periods stands on the right; L has its inertial components, so it acts last.",
        "turn_on_the_right" + counting, [=](auto& I, auto& w, auto t) {
          const Split time(I, w, t, whole_of);
          return Matrix3d(exact_attitude(I, w, time.rest) * about_L(I, w, time.whole * turn_per_period(I, w)));
        });
    e.wrong("The turns of the whole periods are about ω here; what stays after a period is L.",
            "about_omega" + counting, [=](auto& I, auto& w, auto t) {
              const Split time(I, w, t, whole_of);
              return Matrix3d(turn(w, std::fmod(time.whole * turn_per_period(I, w), 2 * pi)) *
                              exact_attitude(I, w, time.rest));
            });
    e.wrong({"In each period this turns the body about L by the dynamical part alone; the solid angle is missing.",
             "attitude_phase"},
            "dynamical_phase_only" + counting, with_turn(dynamical_phase, whole_of));
    e.wrong({"In each period this turns the body about L with the solid angle counted in the wrong sense.",
             "attitude_phase"},
            "phase_reversed" + counting,
            with_turn(
                [](auto& I, auto& w) {
                  const double S = geometric_phase(I, w);
                  return dynamical_phase(I, w) + (is_round_3(I, w) ? S : -S);
                },
                whole_of));
    e.wrong({"In each period this counts the solid angle in the same sense round both axes; round axis 1 it is the "
             "other sense.",
             "attitude_phase"},
            "round_axis_3_always" + counting,
            with_turn([](auto& I, auto& w) { return dynamical_phase(I, w) - geometric_phase(I, w); }, whole_of));
  }
  e.wrong("The body only turns about L here, at the rate of ω along L; it also moves against L.", "turn_about_L",
          [](auto& I, auto& w, auto t) { return about_L(I, w, twice_T(I, w) / L_of(I, w).norm() * t); });
  e.wrong("ω keeps its components on the axes of the body here; they change, unless it lies along a principal axis.",
          "constant_omega", [](auto&, auto& w, auto t) { return turn(w, std::fmod(w.norm() * t, 2 * pi)); });
}

}  // namespace

void judge_exact_attitude(Lecture& lecture) {
  auto& e =
      lecture.exercise(&exact_attitude, {{"I", ascending_moments}, {"omega0", rad_per_s}, {"t", second}}, {"A", none});
  either_side_of_separatrix(e);
  e.domain([](auto& I, auto& w, auto t) { return tumbles(I, w, 0.01, 0.2) && abs(t) <= 1e6; });
  e.worked("round axis 3, after eight days", lecture_body, round_3, 700000);
  e.worked("round axis 1, after eight days", lecture_body, round_1, 700000);
  e.worked("a day and a half before", lecture_body, round_3, -123456.7);
  e.special("time 0", lecture_body, round_1, 0);
  e.special("after one period", lecture_body, round_3, ExactTop(lecture_body, round_3).period());
  const double half = ExactTop(lecture_body, {0.5, 0, -0.8}).period() / 2;
  for (const int odd : {1, 3, 7, 15, 101, 1001})
    e.special("ω₂ = 0 at the start, after half periods: " + std::to_string(odd), lecture_body, {0.5, 0, -0.8},
              odd * half);
  e.special("not far from the separatrix, round axis 3", lecture_body, {0.6, 0.5, 0.465}, 3e5);
  e.special("not far from the separatrix, round axis 1", lecture_body, {0.6, 0.5, 0.39}, 3e5);
  e.special("starting with ω₂ = 0", lecture_body, {0.5, 0, -0.8}, 4e5);
  e.special("starting with ω₁ = 0", lecture_body, {0, -0.7, 0.8}, -1e6);
  e.special("starting with ω₃ = 0", lecture_body, {-0.9, 0.3, 0}, 1e6);
  e.special("a small wobble about axis 3", lecture_body, {0.2, 0.1, -1}, 8e5);
  e.special("a small wobble about axis 1", lecture_body, {1, -0.1, 0.2}, 8e5);
  e.special("moments close together", {1, 1.07, 1.15}, {0.3, -0.2, 0.5}, 6e5);
  e.special("a moment later", lecture_body, round_3, 0.01);
  e.limit("time 0", Matrix3d::Identity(), "No time has passed.");
  e.limit("a moment later", turn(round_3.normalized(), 0.01 * round_3.norm()),
          "In so short a time ω hardly changes, and the body turns about it.");
  e.random("round axis 3", 6, round_axis(3), any::spin(1e5, 1e6));
  e.random("round axis 1", 6, round_axis(1), any::spin(1e5, 1e6));
  e.random("within a minute", 4, round_axis(1), any::spin(20, 60));
  e.tolerance(1e-6, "After a million seconds the last digits of period and turn have become an error of a few 10⁻⁸.");
  e.scale(1);
  e.sweep<2>(
      {"I = (1.2, 2, 2.7) kg m², ω = (0.4, −0.9, 0.6) rad/s: how far each axis is from where it was 8 days before",
       "t − 691200 s (s)", "cosine of the angle"},
      {{"axis 1", 0, 0}, {"axis 2", 1, 1}, {"axis 3", 2, 2}}, {0, 30, 91}, [](auto t) { return 691200 + t; });

  mistakes_of_exact_attitude(e);
  e.property(Is::rotation_matrix, "The principal axes stay at right angles and of length 1, and right-handed.");
  e.route("a turn about L for whole periods, the rest integrated", turns_and_rest);
  e.route("one period integrated, its attitude raised to a power", power_of_a_period);
  e.route("axis 1 followed about L, by sums", axis_1_followed);
  e.survivor("jacobi_cn(k, - u)", "cn is an even function.");
  e.survivor("squares[2] >=", "Zero is the separatrix, which is no legal input.");
  e.survivor("copysign( -1.0", "copysign takes the size of its first argument only.");
  e.survivor("copysign(-1,", "copysign takes the size of its first argument only.");
  e.survivor("( -k", "The modulus enters squared.");
  e.survivor("isfinite", "No legal input leads there.");
  e.survivor("double cotangent = -", "The cotangent enters squared.");
  e.survivor("( -I[0] * largest", "The cotangent enters squared.");
  e.survivor(" * within / turn", "A part of the correction, or half as much again, still tells the turns.");
  e.survivor("AngleAxisd(about_L", "A turn takes no factor and no sign.");
  e.survivor("( -upright", "A quaternion and its opposite are the same turn.");
}
