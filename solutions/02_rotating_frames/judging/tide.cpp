#include "solutions/02_rotating_frames/shared.hpp"

namespace {

/// The height on a level of −1/r − (potential of the moon and the moving origin), by bisection, in units of radius.
template <class Potential>
auto level_of(const Potential& moon, double from_quarter = 1) {
  return [moon, from_quarter](auto ratio, auto R, auto d, auto angle) {
    const double x = R / d;
    const auto gain = [&](double h) {  // of −potential, over that a quarter round
      return -h / (1 + h) + ratio * x * (moon(x * (1 + h), cos(angle)) - from_quarter * moon(x, 0));
    };
    double below = -0.1, above = 0.1;
    for (int i = 0; i < 70; ++i) {
      const double middle = (below + above) / 2;
      (gain(middle) > 0 ? below : above) = middle;
    }
    return R * (below + above) / 2;
  };
}

double moon_in_full(double x, double c) { return 1 / sqrt(1 - 2 * x * c + x * x) - 1 - x * c; }

/// Σ xⁿ Pₙ(c) from n = 2 to the last one.
auto legendre_series(int last) {
  return [last](double x, double c) {
    double before = 1, now = c, power = x, sum = 0;
    for (int n = 2; n <= last; ++n) {
      const double next = ((2 * n - 1) * c * now - (n - 1) * before) / n;
      before = now;
      now = next;
      power *= x;
      sum += power * now;
    }
    return sum;
  };
}

/// Along the surface from a quarter round, at right angles to the force.
double along_the_surface(double ratio, double R, double d, double angle) {
  using Place = Vector2d;  // height and angle, in units of radius
  const double start = pi / 2, x = R / d;
  const Place end = followed(Place(0, start), angle - start, 600, [&](const Place& place) {
    const double r = 1 + place[0], c = cos(place[1]), s = sin(place[1]);
    // Moon at distance 1/x along the first axis; q is its distance from the place. What it adds at the centre goes off.
    const double q2 = 1 - 2 * x * r * c + x * x * r * r, excess = std::expm1(-1.5 * std::log1p(q2 - 1));
    const Vector2d force = ratio * x * x * (Vector2d(1, 0) * excess - x * r * Vector2d(c, s) * (1 + excess));
    const double down = 1 / (r * r) - force.dot(Vector2d(c, s)), along = force.dot(Vector2d(-s, c));
    return Place(r * along / down, 1);
  });
  return R * end[0];
}

double first_order(double ratio, double R, double d) { return 1.5 * ratio * pow(R / d, 3) * R; }

}  // namespace

void judge_tide(Lecture& lecture) {
  auto& e = lecture.exercise(
      &tide,
      {{"mass_ratio", positive(none)}, {"radius", positive(metre)}, {"distance", positive(metre)}, {"angle", rad}},
      {"height", metre});
  e.domain([](auto ratio, auto R, auto d, auto angle) {
    const double x = R / d, strength = ratio * x * x * x;
    return x >= 2e-5 && x <= 0.3 && strength >= 1e-9 && strength <= 0.005 && angle >= 0 && angle <= pi;
  });
  const double earth = 6.371e6, to_moon = 3.844e8, moon = 0.0123;
  e.worked("a moon as near as those of Mars, and heavier", 0.12, 1.2e6, 6e6, 2.2);
  e.worked("our Moon overhead", moon, earth, to_moon, 0);
  e.special("our Moon on the other side", moon, earth, to_moon, pi);
  e.special("our Moon a quarter round", moon, earth, to_moon, pi / 2);
  e.special("nearly a quarter round", moon, earth, to_moon, pi / 2 - 0.008);
  e.special("the Sun", 332946, earth, 1.496e11, 0.5);
  e.special("a moon that nearly grazes", 0.01, 1, 3.4, 0.3);
  e.limit("our Moon a quarter round", 0, "Heights are counted from there.");
  e.limit("the Sun", 1.5 * 332946 * pow(earth / 1.496e11, 3) * earth * pow(cos(0.5), 2),
          "So far away only the lowest order in R/d counts, and both high waters are alike.");
  e.random("a heavy moon nearby", 10, [](Random& random) {
    const double x = random.uniform(0.1, 0.28), R = random.uniform(1e6, 8e6);
    const double angle = random.sign() > 0 ? random.uniform(0.2, 0.6) : pi - random.uniform(0.2, 0.6);
    return tuple(random.uniform(1e-3, 4e-3) / (x * x * x), R, R / x, angle);
  });
  e.tolerance(1e-6, "In the sum of the three potentials, written out, up to seven digits cancel.");
  e.scale([](auto ratio, auto R, auto d, auto) { return first_order(ratio, R, d); });
  e.sweep<3>({"A heavy moon at five radii: the water all around", "angle from the moon (rad)", "height (m)"},
             {{"height"}}, {0, pi});

  e.wrong({"Your planet is held fast: its centre falls as well, which takes the uniform part of the attraction away.",
           "rotating_frames_origin"},
          "held_fast", level_of([](double x, double c) { return moon_in_full(x, c) + x * c; }));
  e.wrong("Your two high waters are equal; the attraction grows towards the moon, and faster than in proportion.",
          "two_equal_bulges", level_of([](double x, double c) { return legendre_series(2)(x, c); }));
  e.wrong("The height is that of a distant moon, to lowest order; this moon is near.", "lowest_order",
          [](auto ratio, auto R, auto d, auto angle) { return first_order(ratio, R, d) * cos(angle) * cos(angle); });
  e.wrong("Your water is high below the moon only; on the far side it lags behind the planet, and is high as well.",
          "one_high_water",
          [](auto ratio, auto R, auto d, auto angle) { return first_order(ratio, R, d) * cos(angle); });
  e.wrong(
      "Heights are counted from the mean level, and to lowest order; asked for are those above a quarter round, "
      "exactly.",
      "mean_level", [](auto ratio, auto R, auto d, auto angle) {
        return first_order(ratio, R, d) * (cos(angle) * cos(angle) - 1. / 3);
      });
  e.wrong("The height is that of the first two terms of a series; this moon is near, and the next ones count.",
          "two_terms", [](auto ratio, auto R, auto d, auto angle) {
            const auto terms = legendre_series(3);
            return R * ratio * R / d * (terms(R / d, cos(angle)) - terms(R / d, 0));
          });
  e.wrong("The uniform field has the wrong sign: the planet falls towards the moon, so its water lags behind.",
          "sign_of_the_fall", level_of([](double x, double c) { return moon_in_full(x, c) + 2 * x * c; }));
  e.wrong("The forces are those at the planet's surface without a tide; the water stands in another field, higher up.",
          "field_of_the_sphere", [](auto ratio, auto R, auto d, auto angle) {
            const double x = R / d;
            return R * ratio * x * (moon_in_full(x, cos(angle)) - moon_in_full(x, 0));
          });
  e.wrong("A quarter round your water is not at 0: the potential that the moon has there is not subtracted.",
          "level_of_planet_alone", level_of(moon_in_full, 0));
  e.wrong_input<3>("The angle is taken from a quarter round; it is counted from the direction of the moon.", "altitude",
                   complement);
  e.wrong_inputs("The distance is taken from the surface; it is that from the centre of the planet to the moon.",
                 "from_the_surface", [](auto, auto R, auto& d, auto) { d += R; });
  e.wrong_output(
      "Your water is low where it is high: the surface is a level of the potential, which falls towards the moon.",
      "sign", negated);
  e.angles_read_as_degrees();
  e.route("the level of the three potentials by bisection", level_of(moon_in_full));
  e.route("a series of Legendre polynomials", level_of(legendre_series(40)));
  e.route("along the surface, at right angles to the force", along_the_surface);
}
