#include "solutions/04_parallel_axis/shared.hpp"

/// The period on a knife edge at the distance h, for the radius of gyration k about the centre of mass.
static double period_on_edge(double h, double k, double g) { return 2 * pi * sqrt((h * h + k * k) / (g * h)); }

/// For each guess of k² both periods give a value of g; between two bounds these become equal.
static double by_bisection(double h1, double T1, double h2, double T2) {
  const auto g_from = [](double h, double T, double square) { return 4 * pi * pi * (h * h + square) / (h * T * T); };
  const auto surplus = [&](double square) { return g_from(h1, T1, square) - g_from(h2, T2, square); };
  double lower = 0, upper = 1e-6 * h1 * h2;
  while (surplus(lower) * surplus(upper) > 0 && upper < 1e12 * (h1 * h1 + h2 * h2)) upper *= 2;
  for (int step = 0; step < 200; ++step) {
    const double middle = (lower + upper) / 2;
    (surplus(lower) * surplus(middle) > 0 ? lower : upper) = middle;
  }
  return g_from(h1, T1, lower);
}

void judge_gravity_from_kater(Lecture& lecture) {
  auto& e = lecture.exercise(
      &gravity_from_kater,
      {{"h1", positive(metre)}, {"T1", positive(second)}, {"h2", positive(metre)}, {"T2", positive(second)}},
      {"g", m_per_s2});
  e.domain([](auto h1, auto T1, auto h2, auto T2) {
    const double g = gravity_from_kater(h1, T1, h2, T2);
    const double square_of_gyration = h1 * (g * T1 * T1 / (4 * pi * pi) - h1);
    return abs(h1 - h2) >= 0.1 * max(h1, h2) && g > 0 && square_of_gyration > 0;
  });
  e.worked("edges at 0.62 m and 0.2 m", 0.62, 1.7362, 0.2, 1.5539);
  e.special("equal periods, as Kater adjusted them", 0.7, 2, 0.29396, 2);
  e.special("the first edge close to the centre of mass", 0.05, 1.8495, 0.5, 1.5278);
  e.special("nearly all mass in one point", 1, 2.0001, 0.25, 1.0008);
  e.limit("equal periods, as Kater adjusted them", 4 * pi * pi * (0.7 + 0.29396) / 4,
          "The two edges are then as far apart as the simple pendulum of this period is long.");
  e.limit("nearly all mass in one point", pi * pi,
          "On each edge it is a simple pendulum, of the length of the distance.");
  e.random("a pendulum", 10, [](Random& random) {
    const double h1 = random.uniform(0.1, 0.9),
                 h2 = h1 * (random.sign() > 0 ? 1 / random.uniform(1.3, 3) : random.uniform(1.3, 3));
    const double k = random.uniform(0.1, 0.8), g = random.uniform(1.6, 25);
    return tuple(h1, period_on_edge(h1, k, g), h2, period_on_edge(h2, k, g));
  });
  e.sweep({"Edges at 0.62 m and 0.2 m, first period 1.7362 s", "second period, T2 (s)", "g (m/s²)"}, {{"g"}},
          {1.4, 1.7}, [](auto T2) { return tuple(0.62, 1.7362, 0.2, T2); });

  const char* const two_periods = "parallel_axis_pendulum";
  e.wrong("This takes the body for a simple pendulum of the length h1; its mass is spread out.", "simple_pendulum",
          [](auto h1, auto T1, auto, auto) { return 4 * pi * pi * h1 / (T1 * T1); });
  const Sentence only_if_equal = {
      "The sum of the distances is the length of a simple pendulum with the same period only where both periods are "
      "equal.",
      two_periods};
  e.wrong(only_if_equal, "sum_and_mean",
          [](auto h1, auto T1, auto h2, auto T2) { return 16 * pi * pi * (h1 + h2) / pow(T1 + T2, 2); });
  e.wrong(only_if_equal, "sum_and_mean_square",
          [](auto h1, auto T1, auto h2, auto T2) { return 8 * pi * pi * (h1 + h2) / (T1 * T1 + T2 * T2); });
  e.wrong(only_if_equal, "sum_and_weighted_mean_square", [](auto h1, auto T1, auto h2, auto T2) {
    return 4 * pi * pi * pow(h1 + h2, 2) / (h1 * T1 * T1 + h2 * T2 * T2);
  });
  e.wrong("This is the mean of what two simple pendulums would show; neither is one, and their errors do not cancel.",
          "mean_of_two",
          [](auto h1, auto T1, auto h2, auto T2) { return 2 * pi * pi * (h1 / (T1 * T1) + h2 / (T2 * T2)); });
  e.wrong_inputs(
      "Each period stands with the distance of the other edge; a difference with the wrong sign gives the same.",
      "periods_crossed", [](auto, auto& T1, auto, auto& T2) { swap(T1, T2); });
  e.wrong("Two equations are added where one is to be subtracted from the other; the unknown moment stays in.",
          "same_side", [](auto h1, auto T1, auto h2, auto T2) {
            return 4 * pi * pi * (h1 * h1 + h2 * h2) / (h1 * T1 * T1 + h2 * T2 * T2);
          });
  e.wrong_output("This is a quarter of the right result, as if each period were the time of half a swing.",
                 "half_swing", times(0.25));
  e.property(Is::nonnegative, "The acceleration of free fall is positive here.");
  e.route("Bessel's formula", [](auto h1, auto T1, auto h2, auto T2) {
    const double sum = T1 * T1 + T2 * T2, difference = (T1 - T2) * (T1 + T2);
    return 8 * pi * pi / (sum / (h1 + h2) + difference / (h1 - h2));
  });
  e.route("two linear equations", [](auto h1, auto T1, auto h2, auto T2) {
    // T² h = 4π² (h² x + y) with x = 1/g and y = k²/g.
    const Eigen::Matrix2d A{{h1 * h1, 1}, {h2 * h2, 1}};
    const Vector2d b(T1 * T1 * h1, T2 * T2 * h2);
    return 4 * pi * pi / (A.inverse() * b)[0];
  });
  e.route("bisection for the radius of gyration", by_bisection);
  e.survivor("turn = -", "It is squared.");
}
