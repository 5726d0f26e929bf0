#include "solutions/02_rotating_frames/shared.hpp"

/// The square of the angular velocity, in units of the critical one.
static double speed_ratio(double radius, double g, double rate) { return rate * rate * radius / g; }

static void add_routes_of_bead_on_hoop(auto& e) {
  e.route("root and slope of the force along the hoop", [](auto radius, auto g, auto rate) {
    const auto force = [&](double angle) { return (rate * rate * radius * cos(angle) - g) * sin(angle) / radius; };
    double low = 0, high = force(1e-4) > 0 ? pi / 2 : 0;
    if (high > 0) low = 1e-4;
    while (high - low > 1e-15) {
      const double middle = (low + high) / 2;
      if (middle <= low || middle >= high) break;
      (force(middle) > 0 ? low : high) = middle;
    }
    const double h = 1e-3, angle = (low + high) / 2;
    const double slope =
        (8 * (force(angle + h) - force(angle - h)) - force(angle + 2 * h) + force(angle - 2 * h)) / (12 * h);
    return Vector2d(angle, sqrt(-slope));
  });
  e.route("along the plumb line in the frame of the hoop", [](auto radius, auto g, auto rate) {
    const double ratio = speed_ratio(radius, g, rate);
    double angle = ratio > 1 ? pi / 2 : 0;
    for (int k = 0; k < 5000; ++k) angle = atan(ratio * sin(angle));
    // Gravity and centrifugal force along the rod to the centre, less the growth of the latter along the hoop.
    const double pull = g * cos(angle) / radius + pow(rate * sin(angle), 2);
    return Vector2d(angle, sqrt(pull - pow(rate * cos(angle), 2)));
  });
  e.route("half angles", [](auto radius, auto g, auto rate) {
    const double own = sqrt(g / radius), hoop = abs(rate);
    if (hoop < own) return Vector2d(0, sqrt((own - hoop) * (own + hoop)));
    const double difference = (hoop - own) * (hoop + own), sum = hoop * hoop + own * own;
    return Vector2d(2 * atan(sqrt(difference / sum)), sqrt(difference * sum) / hoop);
  });
  e.survivor("hoop <= pendulum", "At the critical rate both branches give 0.");
}

void judge_bead_on_hoop(Lecture& lecture) {
  auto& e =
      lecture.exercise(&bead_on_hoop, {{"radius", positive(metre)}, {"g", positive(m_per_s2)}, {"rate", rad_per_s}},
                       {"angle and frequency", none});
  e.result_units({rad, rad_per_s});
  e.domain([](auto radius, auto g, auto rate) { return abs(sqrt(speed_ratio(radius, g, rate)) - 1) >= 0.01; });
  e.worked("a hoop that rotates with 7 rad/s", 0.5, 9.81, 7);
  e.worked("the same hoop with 3 rad/s", 0.5, 9.81, 3);
  e.special("the hoop is at rest", 0.5, 9.81, 0);
  e.special("very fast, the other way", 0.5, 9.81, -60);
  e.special("2 % below the critical rate", 0.5, 9.81, 0.98 * sqrt(9.81 / 0.5));
  e.special("2 % above the critical rate", 0.5, 9.81, 1.02 * sqrt(9.81 / 0.5));
  e.limit("the hoop is at rest", {0, sqrt(9.81 / 0.5)},
          "A bead on a hoop at rest is a pendulum as long as the radius.");
  e.limit("very fast, the other way", {acos(9.81 / (0.5 * 60 * 60)), 60},
          "Fast rotation drives the bead nearly to the height of the centre; there it oscillates once in a rotation, "
          "and the sense does not matter.");
  const auto random_hoop = [](double slowest, double fastest) {
    return [=](Random& random) {
      const double radius = random.uniform(0.1, 2), g = random.uniform(2, 15);
      const double sign = random.sign();
      return tuple{radius, g, sign * random.uniform(slowest, fastest) * sqrt(g / radius)};
    };
  };
  e.random("a random hoop above the critical rate", 8, random_hoop(1.1, 3));
  e.random("a random hoop below the critical rate", 4, random_hoop(0.2, 0.9));
  e.scale([](auto radius, auto g, auto rate) { return Doubles{1, max(sqrt(g / radius), abs(rate))}; });
  e.sweep<2>({"A hoop of radius 0.5 m", "rate of the hoop (rad/s)", "frequency about rest (rad/s)"},
             {{"frequency", 1, 0}}, {0, 12, 121});

  e.wrong("The tilted position is taken at every rate; below the critical rate there is no such angle: not a number.",
          "always_tilted", [](auto radius, auto g, auto rate) {
            const double cosine = 1 / speed_ratio(radius, g, rate);
            return Vector2d(acos(cosine), abs(rate) * sqrt(1 - cosine * cosine));
          });
  e.wrong_input<2>("This is the lowest point on a hoop at rest; the centrifugal force pulls the bead outwards.",
                   "bottom", fixed(0.0));
  e.wrong("The lowest point is taken at every rate; above the critical rate it is a maximum of the potential.",
          "never_tilted", [](auto radius, auto g, auto rate) { return Vector2d(0, sqrt(g / radius - rate * rate)); });
  const auto tilted = [](auto change) {
    return [change](Vector2d& result, auto radius, auto g, auto rate) {
      if (const double ratio = speed_ratio(radius, g, rate); ratio > 1) change(result, ratio, rate);
    };
  };
  e.wrong_output("The frequency in the tilted position is that of the lowest point with the other sign of its square.",
                 "difference_frequency", tilted([](Vector2d& result, double ratio, double rate) {
                   result[1] = abs(rate) * sqrt(1 - 1 / ratio);
                 }));
  const char* const whole_radius =
      "The angle is that of a bead at the distance of the radius from the axis; on the hoop the distance depends on "
      "the angle.";
  e.wrong_output(whole_radius, "tangent",
                 tilted([](Vector2d& result, double ratio, double) { result[0] = atan(ratio); }));
  e.wrong(whole_radius, "tangent_at_every_rate", [](auto radius, auto g, auto rate) {
    const double angle = atan(speed_ratio(radius, g, rate));
    return Vector2d(angle, sqrt(g / radius * cos(angle) + rate * rate * sin(angle)));
  });
  e.wrong_output("The frequency has the curvature of gravity alone; the centrifugal force changes along the hoop too.",
                 "cosine_frequency",
                 tilted([](Vector2d& result, double ratio, double rate) { result[1] = abs(rate) / ratio; }));
  e.wrong_output("The bead swings as in the field of its place of rest; the centrifugal force changes along the hoop.",
                 "field_at_rest", [](Vector2d& result, auto radius, auto g, auto rate) {
                   result[1] = max(sqrt(g / radius), abs(rate));
                 });
  e.wrong_output("The angle is measured from the highest point.", "from_the_top",
                 [](auto& result) { result[0] = pi - result[0]; });
  e.wrong_output("This is the square of the frequency.", "squared", [](auto& result) { result[1] *= result[1]; });
  e.property(Is::nonnegative, "The angle is counted from 0 to π, and a frequency is not negative.");
  add_routes_of_bead_on_hoop(e);
}
