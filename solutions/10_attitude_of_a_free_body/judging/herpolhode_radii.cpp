#include "solutions/10_attitude_of_a_free_body/shared.hpp"

namespace {

double root(double square) { return sqrt(max(square, 0.0)); }

/// The radii from two values of ω².
Vector2d between(const Vector3d& I, const Vector3d& w, double one, double other) {
  const double height = twice_T(I, w) / L_of(I, w).norm();
  return {root(min(one, other) - height * height), root(max(one, other) - height * height)};
}

/// ω² where component i vanishes: it is linear in T and L².
double squared_without(int i, const Vector3d& I, const Vector3d& w) {
  const double Ij = I[(i + 1) % 3], Ik = I[(i + 2) % 3];
  return (twice_T(I, w) * (Ij + Ik) - L_of(I, w).squaredNorm()) / (Ij * Ik);
}

/// The square of the radius where component i vanishes; negative where it never does.
double square_without(int i, const Vector3d& I, const Vector3d& w) {
  const double Ij = I[(i + 1) % 3], Ik = I[(i + 2) % 3], L2 = L_of(I, w).squaredNorm(), T2 = twice_T(I, w);
  return (T2 * Ik - L2) * (L2 - T2 * Ij) / (Ij * Ik * L2);
}
double radius_without(int i, const Vector3d& I, const Vector3d& w) { return root(square_without(i, I, w)); }

Vector2d sorted(double one, double other) { return {min(one, other), max(one, other)}; }

/// Smallest and largest of some length along the motion, by steps through a period and a parabola at each extremum.
template <class Length>
Vector2d extremes(const Vector3d& I, const Vector3d& w, const Length& length) {
  constexpr int steps = 3000;
  const ExactTop top(I, w);
  const double h = top.period() / steps;
  Vector2d found(length(w), length(w));
  for (int i = 0; i < steps && h > 0; ++i) {
    const double before = length(top.omega((i - 1) * h)), now = length(top.omega(i * h)),
                 after = length(top.omega((i + 1) * h));
    const double slope = (after - before) / 2, bend = after - 2 * now + before;
    const double peak = abs(slope) <= abs(bend) && bend != 0 ? now - slope * slope / (2 * bend) : now;
    found = Vector2d(min(found[0], peak), max(found[1], peak));
  }
  return found;
}

/// The wrong answers that are known.
template <class Exercise>
void mistakes_of_herpolhode_radii(Exercise& e) {
  e.wrong("Both radii are the one at the start; the point of contact comes closer to the foot, and goes further away.",
          "start_twice", [](auto& I, auto& w) { return Vector2d(Vector2d::Constant(poinsot(I, w)[1])); });
  e.wrong_output("The larger radius comes first here; the smaller one is asked for first.", "largest_first", reversed);
  e.wrong({"One of your radii belongs to a vanishing ω₁, also for motion round axis 1, where ω₁ never vanishes.",
           "attitude_herpolhode"},
          "round_axis_3_always", [](auto& I, auto& w) {
            const double L2 = L_of(I, w).squaredNorm(), gap = I[2] > I[1] ? I[2] - I[1] : 1;
            const double square_2 = (twice_T(I, w) * I[2] - L2) / (I[1] * gap),
                         square_3 = (L2 - twice_T(I, w) * I[1]) / (I[2] * gap);
            const double other = poinsot(I, Vector3d(0, sqrt(abs(square_2)), sqrt(abs(square_3))))[1];
            const double one = between(I, w, squared_without(1, I, w), squared_without(1, I, w))[0];
            return Vector2d(min(one, other), max(one, other));
          });
  const Sentence not_reached{
      "One of your radii belongs to a component that never vanishes in this motion: round axis 1 that "
      "is ω₁, round axis 3 it is ω₃.",
      "attitude_herpolhode"};
  e.wrong(not_reached, "round_axis_3_clamped",
          [](auto& I, auto& w) { return sorted(radius_without(1, I, w), radius_without(0, I, w)); });
  e.wrong(not_reached, "round_axis_3_absolute", [](auto& I, auto& w) {
    return sorted(sqrt(abs(square_without(1, I, w))), sqrt(abs(square_without(0, I, w))));
  });
  e.wrong({"Your radii belong to a vanishing ω₁ and a vanishing ω₃; ω₂ vanishes in every motion, and one of the two "
           "others never does.",
           "attitude_herpolhode"},
          "never_axis_2", [](auto& I, auto& w) { return sorted(radius_without(0, I, w), radius_without(2, I, w)); });
  e.wrong(
      {"Your radii take the largest values of two components together; where one of them is largest the other is not.",
       "attitude_herpolhode"},
      "largest_together", [](auto& I, auto& w) {
        const double above = L_of(I, w).squaredNorm() - twice_T(I, w) * I[0],
                     below = twice_T(I, w) * I[2] - L_of(I, w).squaredNorm();
        const double a1 = root(below / I[0] / (I[2] - I[0])), a3 = root(above / I[2] / (I[2] - I[0]));
        const bool is_round_axis_3 = L_of(I, w).squaredNorm() > twice_T(I, w) * I[1];
        const double inner =
            is_round_axis_3 ? root(below / I[1] * (I[2] - I[1])) * a3 : root(above / I[1] * (I[1] - I[0])) * a1;
        return Vector2d(sorted(inner, (I[2] - I[0]) * a1 * a3) / L_of(I, w).norm());
      });
  e.wrong({"This holds if ω reaches the ends of the half-axes of the ellipsoid; the polhode does not go there.",
           "attitude_herpolhode"},
          "half_axes", [](auto& I, auto& w) {
            const double height = twice_T(I, w) / L_of(I, w).norm();
            return sorted(root(twice_T(I, w) / I[2] - height * height), root(twice_T(I, w) / I[0] - height * height));
          });
  e.wrong(
      "These are the smallest and the largest length of ω, distances from the centre of the ellipsoid; asked for are "
      "those "
      "from the foot of the perpendicular.",
      "length_of_omega", [](auto& I, auto& w) {
        const Vector2d radii = herpolhode_radii(I, w);
        const double height = poinsot(I, w)[0];
        return Vector2d(hypot(radii[0], height), hypot(radii[1], height));
      });
  e.wrong({"These are the largest values of ω₁ and ω₂, of the polhode on the axes of the body; asked for is the curve "
           "on the plane in space.",
           "attitude_herpolhode"},
          "polhode_axes", [](auto& I, auto& w) {
            const double below = twice_T(I, w) * I[2] - L_of(I, w).squaredNorm();
            return Vector2d(root(below / (I[0] * (I[2] - I[0]))),
                            I[2] > I[1] ? root(below / (I[1] * (I[2] - I[1]))) : 0.0);
          });
  e.wrong({"These are distances of ω from the axis that it circles in the body; asked for are those from L, in space.",
           "attitude_herpolhode"},
          "polhode_radii", [](auto& I, auto& w) {
            const int c = L_of(I, w).squaredNorm() > twice_T(I, w) * I[1] ? 2 : 0, a = 2 - c;
            const double left = abs(twice_T(I, w) * I[c] - L_of(I, w).squaredNorm());
            const double other = abs(I[c] - I[a]), middle = abs(I[c] - I[1]);
            return sorted(root(left / (I[a] * other)), middle > 0 ? root(left / (I[1] * middle)) : 0.0);
          });
}

}  // namespace

void judge_herpolhode_radii(Lecture& lecture) {
  auto& e = lecture.exercise(&herpolhode_radii, {{"I", ascending_moments}, {"omega0", nonzero(rad_per_s)}},
                             {"radii", rad_per_s});
  either_side_of_separatrix(e);
  e.domain([](auto& I, auto& w) { return I[0] < I[2] && abs(side_of_separatrix(I, w)) >= 1e-3; });
  e.worked("round axis 3", lecture_body, round_3);
  e.worked("round axis 1", lecture_body, round_1);
  e.special("a flattened symmetric body", {1, 1, 1.8}, {0.4, 0, 2});
  e.special("a long symmetric body", {0.6, 1, 1}, {-2, 0.5, 0.3});
  e.special("starting at the larger radius", lecture_body, {0.8, 0, 0.7});
  e.special("starting at the smaller radius", lecture_body, {0, 0.6, 1});
  e.special("a flat body", {1, 2, 3}, {0.2, -1, 0.8});
  const char* const alone =
      "For a spin about one axis a difference of squares vanishes, and rounding leaves half the digits to its root.";
  e.special("a spin about axis 3 alone", {1, 2, 3}, {0, 0, -3});
  e.tolerance_of_last_case(1e-6, alone);
  e.special("a spin about axis 1 alone", {1.1, 2.3, 3.1}, {0.7, 0, 0});
  e.limit("a spin about axis 3 alone", {0, 0}, "The point of contact is the foot of the perpendicular.");
  e.limit("a flattened symmetric body", Vector2d::Constant(0.64 / hypot(0.4, 3.6)),
          "The angle between ω and L stays, so the curve is a circle, as wide as the part of ω across L.");
  e.tolerance_of_last_case(1e-6);
  e.random("round axis 3", 6, round_axis(3));
  e.random("round axis 1", 6, round_axis(1));
  e.scale([](auto&, auto& w) { return w.norm(); });
  e.sweep<1>({"I = (1.2, 2, 2.7) kg m², ω = (0.5, 0.6, ω₃) rad/s: round axis 1 on the left, round axis 3 on the right",
              "ω₃ at the start (rad/s)", "radius (rad/s)"},
             {"smaller", "larger"}, {0, 1.5, 76}, [](auto w3) { return Vector3d(0.5, 0.6, w3); });

  mistakes_of_herpolhode_radii(e);
  e.property(Is::nonnegative, "A radius is never negative.");
  e.route("ω² as a number linear in T and L²", [](auto& I, auto& w) {
    return between(I, w, squared_without(1, I, w), squared_without(is_round_3(I, w) ? 0 : 2, I, w));
  });
  e.route("the exact motion followed for a period", [](auto& I, auto& w) {
    const double L = L_of(I, w).norm();
    return extremes(I, w, [&](const Vector3d& now) { return cross(now, L_of(I, now)).norm() / L; });
  });
  e.route("the turning points from T and L²", [](auto& I, auto& w) {
    const double L2 = L_of(I, w).squaredNorm(), below = twice_T(I, w) * I[2] - L2, above = L2 - twice_T(I, w) * I[0];
    const int c = is_round_3(I, w) ? 2 : 0;
    const double first = root(below / (I[0] * (I[2] - I[0]))), third = root(above / (I[2] * (I[2] - I[0])));
    // Where component a vanishes, two linear equations give the squares of the others.
    const Eigen::Matrix2d sums{{I[1], I[c]}, {I[1] * I[1], I[c] * I[c]}};
    const Vector2d squares = sums.inverse() * Vector2d(twice_T(I, w), L2);
    const double one = (I[2] - I[0]) * first * third / sqrt(L2);
    const double other = abs(I[c] - I[1]) * root(squares[0]) * root(squares[1]) / sqrt(L2);
    return Vector2d(min(one, other), max(one, other));
  });
  e.survivor("-omega0", "Reversing ω reverses L and changes no length.");
  e.survivor("(i + 4) % 3", "The remainder is the same.");
  e.survivor("% -3", "The remainder is the same.");
}
