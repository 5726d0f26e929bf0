#include "solutions/06_free_tops/shared.hpp"

namespace {

/// L² − 2T I₂
double beyond_separatrix(const Vector3d& I, const Vector3d& w) {
  return I[0] * (I[0] - I[1]) * w[0] * w[0] + I[2] * (I[2] - I[1]) * w[2] * w[2];
}
double squared_L(const Vector3d& I, const Vector3d& w) { return I.cwiseProduct(w).squaredNorm(); }
double root(double square) { return sqrt(max(square, 0.0)); }

auto round_axis(int axis) {
  return [axis](Random& random) {
    while (true) {
      const Vector3d I = random.ascending_moments(), w = random.vector(2);
      const double side = beyond_separatrix(I, w) / squared_L(I, w);
      if ((axis == 2 ? side : -side) > 0.05) return tuple{I, w};
    }
  };
}

/// The largest absolute values along one period of the motion, each from a parabola through three neighbours.
Vector3d largest_along_the_motion(const Vector3d& I, const Vector3d& start) {
  constexpr int steps = 16000;
  const double h = tumbling_period(I, start) / steps;
  Vector3d before = start, now = start, largest = start.cwiseAbs();
  for (int i = 0; i <= steps; ++i) {
    const Vector3d next = one_step_on(now, h, [&](const Vector3d& w) { return free_rate(I, w); });
    for (int k = 0; k < 3; ++k) {
      const double slope = (next[k] - before[k]) / 2, bend = next[k] - 2 * now[k] + before[k];
      const bool is_peak = i > 0 && abs(slope) <= abs(bend);
      largest[k] = max(largest[k], abs(is_peak && bend != 0 ? now[k] - slope * slope / (2 * bend) : now[k]));
    }
    before = now;
    now = next;
  }
  return largest;
}

}  // namespace

void judge_largest_rates(Lecture& lecture) {
  auto& e = lecture.exercise(&largest_rates, {{"I", ascending_moments}, {"omega0", rad_per_s}}, {"largest", rad_per_s});
  either_side_of_separatrix(e);
  e.domain([](auto& I, auto& w) {
    return I[0] < I[2] && w.norm() > 0 && abs(beyond_separatrix(I, w)) >= 1e-3 * squared_L(I, w);
  });
  e.worked("round axis 3", {1.2, 2, 2.7}, {0.5, 0.6, 0.6});
  e.worked("round axis 1", {1.2, 2, 2.7}, {0.9, -0.6, 0.3});
  e.special("a flattened symmetric body", {1, 1, 1.8}, {0.3, -0.4, 2});
  e.special("a long symmetric body", {0.6, 1, 1}, {-2, 0.5, 0.3});
  e.special("a flat body, starting at a turning point", {1, 2, 3}, {0, -1, 0.8});
  const char* const alone =
      "A spin about one axis alone makes the difference of T and L² vanish, and rounding leaves "
      "half the digits to its square root.";
  e.special("a spin about axis 3 alone", {1.1, 2.3, 3.1}, {0, 0, 0.7});
  e.tolerance_of_last_case(1e-6, alone);
  e.special("a spin about axis 1 alone", {1.1, 2.3, 3.1}, {-0.7, 0, 0});
  e.limit("a spin about axis 3 alone", {0, 0, 0.7}, "A spin about a principal axis lasts.");
  e.limit("a flattened symmetric body", {0.5, 0.5, 2},
          "The component on the axis of symmetry stays, and the two others go round a circle.");
  e.tolerance_of_last_case(1e-6);
  e.random("round axis 3", 5, round_axis(2));
  e.random("round axis 1", 5, round_axis(0));
  e.scale([](auto&, auto& w) { return w.norm(); });
  e.sweep<1>({"I = (1.2, 2, 2.7) kg m², ω = (0.5, 0.6, ω₃) rad/s: round axis 1 on the left, round axis 3 on the right",
              "ω₃ at the start (rad/s)", "largest value (rad/s)"},
             {"of |omega_1|", "of |omega_2|", "of |omega_3|"}, {0, 1, 80},
             [](auto w3) { return Vector3d(0.5, 0.6, w3); });

  e.wrong("These are the absolute values at the start; other moments of the motion have larger ones.", "start_values",
          [](auto&, auto& w) -> Vector3d { return w.cwiseAbs(); });
  e.wrong("This is as if all the energy went into one axis at a time; L does not allow that.", "energy_bound",
          [](auto& I, auto& w) -> Vector3d { return (twice_T(I, w) * I.cwiseInverse()).cwiseSqrt(); });
  e.wrong("This is as if all of L pointed along one axis at a time; the energy does not allow that.", "momentum_bound",
          [](auto& I, auto& w) -> Vector3d { return sqrt(squared_L(I, w)) * I.cwiseInverse(); });
  e.wrong_output({"Your second component is right for motion round axis 3 only; when ω circles axis 1, it is ω₁ that "
                  "never vanishes.",
                  "free_tops_polhodes"},
                 "one_bound_for_axis_2", [](auto& largest, auto& I, auto& w) {
                   const double below = twice_T(I, w) * I[2] - squared_L(I, w);
                   if (I[2] > I[1]) largest[1] = root(below / (I[1] * (I[2] - I[1])));
                 });
  e.wrong_output("The first and the third component are exchanged.", "labels_1_3", reversed);
  e.property(Is::nonnegative, "An absolute value is never negative.");
  e.route("from T and L², with two cases", [](auto& I, auto& w) {
    const double below = twice_T(I, w) * I[2] - squared_L(I, w), above = squared_L(I, w) - twice_T(I, w) * I[0];
    const double middle =
        squared_L(I, w) > twice_T(I, w) * I[1] ? below / (I[1] * (I[2] - I[1])) : above / (I[1] * (I[1] - I[0]));
    return Vector3d(root(below / (I[0] * (I[2] - I[0]))), root(middle), root(above / (I[2] * (I[2] - I[0]))));
  });
  e.route("the ends of the line of squares", [](auto& I, auto& w) -> Vector3d {
    // T and L² are linear in the squares; at an end one square is zero, and the two others are not negative.
    Vector3d largest = w.cwiseAbs2();
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      if (I[i] == I[j]) continue;
      const Eigen::Matrix2d sums{{I[i], I[j]}, {I[i] * I[i], I[j] * I[j]}};
      const Vector2d squares = sums.inverse() * Vector2d(twice_T(I, w), squared_L(I, w));
      if (squares.minCoeff() < -1e-12 * w.squaredNorm()) continue;
      largest[i] = max(largest[i], squares[0]);
      largest[j] = max(largest[j], squares[1]);
    }
    return largest.cwiseSqrt();
  });
  e.route("the motion followed for a period", largest_along_the_motion);
}
