#include "solutions/11_measured/shared.hpp"

void judge_moment_ratios(Lecture& lecture) {
  auto& e = lecture.exercise(&moment_ratios, {{"a", none}, {"c", none}}, {"ratios", none});
  e.domain([](auto a, auto c) { return abs(a) <= 1 && c > -1 && c <= 1; });
  e.generated([](auto, auto c) { return c > -0.9; });
  e.worked("moments 3, 2, 4", -2.0 / 3, 1.0 / 4);
  e.worked("a racket", -0.992, 0.852);
  e.special("a sphere", 0, 0);
  e.special("a flat body", -1, 0.5);
  e.special("a thin rod along y", -1, 1);
  e.special("symmetric about z", -0.6, 0);
  e.special("symmetric about x", 0, -0.4);
  e.limit("a sphere", {1, 1}, "Its moments are equal, and Euler's equations have no products left.");
  e.limit("a thin rod along y", {0, 1}, "It has no moment about itself, and equal ones about x and z.");
  e.random("moments in any order", 10, [](Random& random) {
    while (true) {
      const Vector3d I = random.principal_moments();
      const double a = (I[1] - I[2]) / I[0], c = (I[0] - I[1]) / I[2];
      // With one of them small, a wrong sign or another divisor hardly shows.
      if (min(abs(a), abs(c)) > 0.1 && abs(a + c) > 0.05) return tuple(a, c);
    }
  });
  const Vector3d coefficients = euler_coefficients(throw_3.t, throw_3.omega);
  e.measured("the coefficients of throw 3", {}, coefficients[0], coefficients[2]);
  e.scale([](auto, auto c) { return Vector2d::Constant(2 / (1 + c)).eval(); });
  e.sweep<1>({"a = −2/3: the ratios of the moments", "c", "ratio of moments"}, {"I_y/I_x", "I_z/I_x"}, {-0.4, 1});

  e.wrong_output("These are the inverse ratios: the moment about x stands below.", "inverted", [](auto& ratios) {
    for (double& ratio : ratios) ratio = ratio == 0 ? 0 : 1 / ratio;
  });
  e.wrong_output("The two ratios are exchanged: that of y comes first.", "exchanged", reversed);
  e.wrong("Your second ratio is one more than the first, as for a flat body; a tells whether the body is flat.", "flat",
          [](auto a, auto c) {
            const double first = moment_ratios(a, c)[0];
            return Vector2d(first, 1 + first);
          });
  e.wrong_input<1>("The sign of c is the opposite one here: look which moment is subtracted in Euler's third equation.",
                   "sign_of_c", negated);
  e.wrong_input<0>("The sign of a is the opposite one here: look which moment is subtracted in Euler's first equation.",
                   "sign_of_a", negated);
  e.wrong("The differences of the moments are all divided by the moment about x; each equation has its own.",
          "one_divisor", [](auto a, auto c) { return Vector2d(1 - c, 1 - c - a); });
  e.property(Is::nonnegative, "No moment of inertia is negative, and no ratio of two.");
  e.route("a linear system", [](auto a, auto c) -> Vector2d {
    const Eigen::Matrix2d system{{1, -1}, {1, c}};
    return solution_of(system, Vector2d(a, 1));
  });
  e.route("the second ratio first", [](auto a, auto c) {
    const double second = (1 - a) / (1 + c);
    return Vector2d(second + a, second);
  });
  e.route("the moments as a null vector", [](auto a, auto c) {
    const Vector3d I = cross(Vector3d(a, -1, 1), Vector3d(-1, 1, c));
    return Vector2d(I[1] / I[0], I[2] / I[0]);
  });
}
