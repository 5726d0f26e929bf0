#include "solutions/09_heavy_top/shared.hpp"

namespace {

/// The eccentric anomaly at a mean anomaly, by Newton's method.
double eccentric_anomaly(double mean, double e) {
  double E = mean + e * sin(mean);
  for (double change = 1; abs(change) > 1e-13;) E -= change = (E - e * sin(E) - mean) / (1 - e * cos(E));
  return E;
}

/// The true anomaly without jumps, and the distance in units of the half-axis.
Vector2d place(double E, double e) {
  const double f = E + 2 * atan2(e * sin(E), 1 + sqrt(1 - e * e) - e * cos(E));
  return {f, 1 - e * cos(E)};
}

/// For an angle of the orbit.
int steps_for(double angle) { return max(1200, static_cast<int>(120 * angle)); }

/// θ and its rate by Runge and Kutta over the time, under an acceleration that depends on θ and on the mean anomaly.
template <class Acceleration>
Vector2d over_time(double n, double theta0, double rate0, double t, const Acceleration& acceleration) {
  const Vector3d end =
      followed(Vector3d(theta0, rate0 / n, 0), n * t, steps_for(n * t), [&](const Vector3d& now) -> Vector3d {
        return {now[1], acceleration(now[0], now[2]), 1};
      });
  return {end[0], n * end[1]};
}

/// The same under −factor asymmetry (a/r)^power sin(multiple (θ − f)).
Vector2d with_torque(double asymmetry, double e, double n, double theta0, double rate0, double t, double factor,
                     int power, int multiple) {
  return over_time(n, theta0, rate0, t, [&](double theta, double mean) {
    const Vector2d at = place(eccentric_anomaly(mean, e), e);
    return -factor * asymmetry * sin(multiple * (theta - at[0])) / pow(at[1], power);
  });
}

/// With the true anomaly as the clock.
Vector2d over_true_anomaly(double asymmetry, double e, double n, double theta0, double rate0, double t) {
  const double end = place(eccentric_anomaly(n * t, e), e)[0], p = 1 - e * e;
  const Vector3d state =
      followed(Vector3d(theta0, rate0 / n, 0), end, steps_for(end), [&](const Vector3d& now) -> Vector3d {
        const double r = p / (1 + e * cos(now[2])), pace = r * r / sqrt(p);
        return {pace * now[1], -1.5 * asymmetry * pace * sin(2 * (now[0] - now[2])) / (r * r * r), 1};
      });
  return {state[0], n * state[1]};
}

/// The orbit is integrated as well, and the torque comes from the vector to the planet.
Vector2d with_the_orbit(double asymmetry, double e, double n, double theta0, double rate0, double t) {
  using Orbit = Eigen::Matrix<double, 6, 1>;  // place and velocity in the plane, θ and its rate
  Orbit start;
  start << 1 - e, 0, 0, sqrt((1 + e) / (1 - e)), theta0, rate0 / n;
  const Orbit end = followed(start, n * t, 3 * steps_for(n * t), [&](const Orbit& now) -> Orbit {
    const Vector2d r = now.head<2>(), axis(cos(now[4]), sin(now[4])), other(-axis[1], axis[0]);
    const double cube = pow(r.norm(), 3), along = r.dot(axis) / r.norm(), across = r.dot(other) / r.norm();
    Orbit rate;
    rate << now[2], now[3], -r / cube, now[5], 3 * asymmetry * along * across / cube;
    return rate;
  });
  return {end[4], n * end[5]};
}

}  // namespace

void judge_moon_libration(Lecture& lecture) {
  auto& e = lecture.exercise(&moon_libration,
                             {{"asymmetry", not_negative(none)},
                              {"eccentricity", not_negative(none)},
                              {"orbital_rate", positive(rad_per_s)},
                              {"theta0", rad},
                              {"rate0", rad_per_s},
                              {"t", not_negative(second)}},
                             {"motion", none});
  e.result_units({rad, rad_per_s});
  e.domain([](auto asymmetry, auto eccentricity, auto n, auto, auto rate0, auto t) {
    return asymmetry <= 1 && eccentricity <= 0.6 && abs(rate0) <= 5 * n && n * t <= 40;
  });
  e.generated([](auto asymmetry, auto eccentricity, auto n, auto theta0, auto rate0, auto t) {
    return asymmetry <= 0.5 && eccentricity <= 0.4 && abs(rate0) <= 3 * n && n * t <= 12 && abs(theta0) < 100;
  });
  constexpr double month = 27.32 * 86400, year = 87.97 * 86400;
  e.worked("a moon like a potato, for two orbits", 0.25, 0.1, 2 * pi / 1.8e6, 0.3, 2 * pi / 1.8e6, 3.6e6);
  e.worked("the Moon, half an orbit", 2.28e-4, 0.0549, 2 * pi / month, 0, 2 * pi / month, month / 2);
  e.worked("Mercury, two orbits", 2.03e-4, 0.2056, 2 * pi / year, 0.1, 3 * pi / year, 2 * year);
  // A number of steps that does not grow with the time is too small here; a thousand in each orbit are not.
  e.special("six times round an orbit that is far from a circle", 0.03, 0.55, 1e-5, 0.3, 2e-5, 3.8e6);
  e.special("a round equator", 0, 0.2, 1e-5, 0.4, 1.5e-5, 3e5);
  e.special("a circle", 0.3, 0, 1e-5, 0.4, 1e-5, 7e5);
  e.special("at once", 0.3, 0.1, 1e-5, 0.4, 1e-5, 0);
  e.special("turned by half a turn", 0.25, 0.1, 1e-5, pi + 0.3, 1e-5, 7e5);
  e.special("rotating backwards", 0.25, 0.1, 1e-5, 0.3, -2e-5, 7e5);
  e.limit("a round equator", {0.4 + 1.5e-5 * 3e5, 1.5e-5}, "There is nothing to pull at, and it rotates steadily.");
  e.limit("at once", {0.4, 1e-5}, "No time has passed.");
  e.random("a moon that faces its planet", 6, [](Random& random) {
    const double n = random.uniform(2e-6, 4e-5), orbits = random.uniform(0.6, 1.8);
    return tuple{random.uniform(0.05, 0.2),    random.uniform(0.05, 0.2), n, random.sign() * random.uniform(0.2, 0.5),
                 n * random.uniform(0.9, 1.2), 2 * pi * orbits / n};
  });
  e.random("a moon that turns faster", 4, [](Random& random) {
    const double n = random.uniform(2e-6, 4e-5), orbits = random.uniform(0.6, 1.8);
    return tuple{random.uniform(0.1, 0.4), random.uniform(0.1, 0.3),     n,
                 random.uniform(0.2, 1.2), n * random.uniform(1.4, 2.5), 2 * pi * orbits / n};
  });
  e.tolerance(1e-6,
              "The answer may be integrated in steps: a thousand steps of fourth order in an orbit stay within a "
              "millionth.");
  e.scale([](auto, auto, auto n, auto theta0, auto rate0, auto t) {
    return Vector2d(1 + max(abs(theta0), abs(rate0) * t), max(n, abs(rate0)));
  });
  e.sweep<5>({"A moon with an asymmetry of 0.25 on an ellipse with e = 0.1", "time (s)", "θ (rad)"}, {{"θ", 0}},
             {0, 7.2e6, 121});

  e.wrong_input<1>("The orbit is a circle here.", "circle", fixed(0.0));
  e.wrong("The planet moves evenly in your sky, with the mean anomaly; near it a moon is faster.", "mean_anomaly",
          [](auto asymmetry, auto eccentricity, auto n, auto theta0, auto rate0, auto t) {
            return over_time(n, theta0, rate0, t, [&](double theta, double mean) {
              const double r = place(eccentric_anomaly(mean, eccentricity), eccentricity)[1];
              return -1.5 * asymmetry * sin(2 * (theta - mean)) / pow(r, 3);
            });
          });
  e.wrong("The planet stands in your sky at the eccentric anomaly, which is counted at the centre of the ellipse.",
          "eccentric_anomaly", [](auto asymmetry, auto eccentricity, auto n, auto theta0, auto rate0, auto t) {
            return over_time(n, theta0, rate0, t, [&](double theta, double mean) {
              const double E = eccentric_anomaly(mean, eccentricity);
              return -1.5 * asymmetry * sin(2 * (theta - E)) / pow(place(E, eccentricity)[1], 3);
            });
          });
  e.wrong("Both the direction and the distance of the planet take the mean anomaly here: Kepler's equation is missing.",
          "no_kepler", [](auto asymmetry, auto eccentricity, auto n, auto theta0, auto rate0, auto t) {
            return over_time(n, theta0, rate0, t, [&](double theta, double mean) {
              return -1.5 * asymmetry * sin(2 * (theta - mean)) / pow(1 - eccentricity * cos(mean), 3);
            });
          });
  e.wrong("The planet's place is taken to first order in the eccentricity only; Kepler's equation is to be solved.",
          "first_order", [](auto asymmetry, auto eccentricity, auto n, auto theta0, auto rate0, auto t) {
            return over_time(n, theta0, rate0, t, [&](double theta, double mean) {
              const double f = mean + 2 * eccentricity * sin(mean), inverse = 1 + eccentricity * cos(mean);
              return -1.5 * asymmetry * sin(2 * (theta - f)) * pow(inverse, 3);
            });
          });
  e.wrong("The torque is as strong at every distance here; it falls with the cube of the distance.", "no_distance",
          [](auto... inputs) { return with_torque(inputs..., 1.5, 0, 2); });
  e.wrong("The torque falls with the square of the distance here; the difference of two pulls falls with the cube.",
          "square_of_distance", [](auto... inputs) { return with_torque(inputs..., 1.5, 2, 2); });
  for (const auto& [name, factor] : {std::pair("needle", 3.0), std::pair("needle_half", 1.5)})
    e.wrong(
        "Your torque tells the two ends of the long axis apart, like that on a compass needle; both are pulled alike.",
        name, [factor = factor](auto... inputs) { return with_torque(inputs..., factor, 3, 1); });
  e.wrong_input<0>("Your torque is twice too strong: sine times cosine is half of the sine of the double angle.",
                   "no_half", [](double asymmetry) { return 2 * asymmetry; });
  e.wrong("Only small angles from the planet are right here; the torque goes with the sine.", "small_angle",
          [](auto asymmetry, auto eccentricity, auto n, auto theta0, auto rate0, auto t) {
            return over_time(n, theta0, rate0, t, [&](double theta, double mean) {
              const Vector2d at = place(eccentric_anomaly(mean, eccentricity), eccentricity);
              return -3 * asymmetry * (theta - at[0]) / pow(at[1], 3);
            });
          });
  e.wrong("This is the rotation without a torque.", "free",
          [](auto, auto, auto, auto theta0, auto rate0, auto t) { return Vector2d(theta0 + rate0 * t, rate0); });
  e.wrong_output("This is the angle from the direction of the planet; asked for is that from a direction at rest.",
                 "from_the_planet", [](auto& motion, auto, auto eccentricity, auto n, auto, auto, auto t) {
                   motion[0] -= place(eccentric_anomaly(n * t, eccentricity), eccentricity)[0];
                 });
  e.route("over the time, with Kepler's equation at every step",
          [](auto... inputs) { return with_torque(inputs..., 1.5, 3, 2); });
  e.route("with the true anomaly as the clock", over_true_anomaly);
  e.route("the orbit integrated too, and the torque from the vector to the planet", with_the_orbit);
  e.survivor("constexpr int steps", "More steps, or some fewer, reach the accuracy that is asked for.");
  e.survivor("i < 10", "Newton's method has converged long before.");
}
