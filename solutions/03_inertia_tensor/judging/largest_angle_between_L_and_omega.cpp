#include "solutions/03_inertia_tensor/shared.hpp"

static double angle_between_L_and_omega(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  return atan2(cross(omega, L).norm(), omega.dot(L));
}

/// The largest angle over all directions: from the best of four, in steps that are halved where none leads up.
static double by_search_over_directions(const Vector3d& I) {
  const auto angle_at = [&](double u, double v) {
    return angle_between_L_and_omega(I, {cos(u) * cos(v), sin(u) * cos(v), sin(v)});
  };
  double best = 0;
  for (const double start : {0.1, 0.7, 1.3, 1.5}) {
    double u = start, v = 0.6 * start, reached = angle_at(u, v);
    for (double step = 0.3; step > 1e-8;) {
      const double before = reached;
      for (const auto& [du, dv] : {std::pair{step, 0.}, {-step, 0.}, {0., step}, {0., -step}}) {
        if (const double there = angle_at(u + du, v + dv); there > reached) reached = there, u += du, v += dv;
      }
      if (reached <= before) step /= 2;
    }
    best = max(best, reached);
  }
  return best;
}

void judge_largest_angle_between_L_and_omega(Lecture& lecture) {
  auto& e = lecture.exercise(&largest_angle_between_L_and_omega, {{"I", positive(kg_m2)}}, {"angle", rad});
  e.domain([](auto& I) { return 2 * I.maxCoeff() <= (1 + 1e-12) * I.sum(); });
  e.scale(1.0);
  e.worked("three different moments, not in order", {2.5, 1.2, 3.1});
  e.special("a sphere", {2, 2, 2});
  e.special("two equal moments", {1, 1, 1.8});
  e.special("a thin rod", {5, 0.01, 5});
  e.special("a flat body", {3, 1, 2});
  e.special("a very thin rod", {1, 1e-6, 1});
  e.limit("a sphere", 0, "L is along ω for every axis.");
  e.limit("a very thin rod", pi / 2,
          "About its own line a rod has hardly any L: all of L comes from the small rest of ω across it.");
  e.random("a body with the middle moment first or last", 10, [](Random& random) -> Vector3d {
    const double x = random.uniform(0.02, 0.2), y = random.uniform(0.4, 1.3), z = random.uniform(1.6, 2.2);
    const Vector3d moments(z + x, x + y, y + z);  // middle, smallest, largest
    return random.sign() > 0 ? moments : moments.reverse();
  });
  e.random("a body with the middle moment in the middle", 3, [](Random& random) -> Vector3d {
    const double x = random.uniform(0.02, 0.2), y = random.uniform(0.4, 1.3), z = random.uniform(1.6, 2.2);
    return {x + y, z + x, y + z};
  });
  e.sweep({"From a rod to a disc: moments x, 1, 1 kg m²", "moment about the axis of symmetry, x (kg m²)",
           "largest angle between L and ω (rad)"},
          {"angle"}, {0.02, 2}, [](auto x) -> Vector3d {
            return {1, x, 1};
          });

  e.wrong(
      "This is the angle for ω midway between the axes of the extreme moments, and also what comes out when the sine "
      "of "
      "the largest angle is taken for its tangent.",
      "halfway", [](auto& I) { return atan2(I.maxCoeff() - I.minCoeff(), I.maxCoeff() + I.minCoeff()); });
  e.wrong("This is where ω lies when the angle is largest, its angle with an axis; asked for is that between L and ω.",
          "direction_of_omega", [](auto& I) { return atan(sqrt(I.minCoeff() / I.maxCoeff())); });
  e.wrong_output("This is the sine of the largest angle; the angle is asked for.", "sine_not_inverted",
                 [](auto angle) { return sin(angle); });
  e.wrong_input<0>("The second moment does not enter; the moments come in any order.", "not_sorted",
                   [](auto& I) { I[1] = (I[0] + I[2]) / 2; });
  e.wrong("This is the angle whose cosine is the smallest moment over the largest one; the angle asked for is smaller.",
          "cosine", [](auto& I) { return acos(I.minCoeff() / I.maxCoeff()); });
  e.wrong("For a given body the angle stays below a right angle by a finite amount; you return a right angle.",
          "right_angle", [](auto&) { return pi / 2; });
  e.property(Is::nonnegative, "The angle between two vectors is never negative.");
  e.route("search over all directions", by_search_over_directions);
  e.route("the axis at which the angle is stationary",
          [](auto& I) { return pi / 2 - 2 * atan(sqrt(I.minCoeff() / I.maxCoeff())); });
  e.route("from the cosine", [](auto& I) {
    const double smallest = I.minCoeff(), largest = I.maxCoeff();
    return acos(min(1.0, 2 * sqrt(smallest * largest) / (smallest + largest)));
  });
}
