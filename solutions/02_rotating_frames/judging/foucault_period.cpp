#include "solutions/02_rotating_frames/shared.hpp"

void judge_foucault_period(Lecture& lecture) {
  auto& e = lecture.exercise(&foucault_period, {{"latitude", latitude_angle}, {"sidereal_day", positive(second)}},
                             {"period", second});
  e.domain([](auto latitude, auto) { return latitude > 0; });
  e.worked("Paris", 48.8462 * degree, our_sidereal_day);
  e.special("at the pole", pi / 2, our_sidereal_day);
  e.special("30°, where a turn takes two days", pi / 6, our_sidereal_day);
  e.special("45°, where sine and cosine are equal", pi / 4, our_sidereal_day);
  e.special("half a degree from the equator", 0.5 * degree, our_sidereal_day);
  e.random("a random place on a planet", 10, [](auto& r) {
    return tuple{abs(generic_latitude(r)), r.uniform(3e4, 2e5)};
  });
  e.sweep<0>({"The turn of a Foucault pendulum, from 20° to the pole", "latitude (°)", "time of a full turn (h)", 3600},
             {"period"}, {20, 90, 71}, [](auto degrees) { return degrees * degree; });

  e.term("T / sin λ", 1, [](auto latitude, auto day) { return day / sin(latitude); });
  e.wrong("The latitude enters with its cosine; the vertical part of the rotation is Ω sin λ, largest at the pole.",
          "cosine", [](auto latitude, auto day) { return day / cos(latitude); });
  const Sentence solar =
      "This comes out with the solar day of 86400 s; the pendulum follows the stars, by the argument sidereal_day.";
  e.wrong_output(solar, "solar_day", times(86400 / our_sidereal_day));
  e.wrong_input<1>(solar, "solar_day_fixed", fixed(86400.0));
  e.wrong_input<1>("Your answer does not follow the argument sidereal_day; it is right only for our Earth.",
                   "earth_fixed", fixed(our_sidereal_day));
  e.wrong(
      "This is how far the plane turns against the stars; the floor has made a whole turn, and the difference counts.",
      "against_the_stars", [](auto latitude, auto day) { return day / (1 - sin(latitude)); });
  e.wrong("This is T sin λ; the plane turns more slowly away from the pole, so the time is longer than a day: divide.",
          "times_sine", [](auto latitude, auto day) { return day * sin(latitude); });
  e.wrong("The latitude enters with its tangent; the vertical part of the rotation is Ω sin λ.", "tangent",
          [](auto latitude, auto day) { return day / tan(latitude); });
  e.wrong_input<0>("This is the sidereal day, right only at the pole.", "no_latitude", fixed(pi / 2));
  e.wrong_output("This is half of the time: the plane stands as it began, but a turn by 360° is asked for.",
                 "half_a_turn", times(0.5));
  e.wrong_output("A factor 2π is lost: this is the time of a turn by one radian.", "two_pi", times(1 / (2 * pi)));
  e.wrong_output("Your answer is in hours; seconds are asked for.", "hours", times(1 / 3600.0));
  e.angles_read_as_degrees();
  e.survivor("|latitude| below 1e-09", "6 mm from the equator a right route by 1 − sin λ has lost all digits.");
  e.property(Is::nonnegative, "A time is not negative.");
  e.route("from the angular velocity", [](auto latitude, auto day) { return 2 * pi / (2 * pi / day * sin(latitude)); });
  e.route("from the colatitude", [](auto latitude, auto day) { return day / cos(pi / 2 - latitude); });
  e.route("from the angle that parallel transport leaves", [](auto latitude, auto day) {
    // Carried once round the circle of latitude, a direction kept parallel comes back turned by 2π less the solid angle
    // of the cap.
    const double solid_angle = 2 * pi * (1 - sin(latitude));
    return day * 2 * pi / (2 * pi - solid_angle);
  });
  e.route("with the tangent", [](auto latitude, auto day) { return day * sqrt(1 + 1 / pow(tan(latitude), 2)); });
}
