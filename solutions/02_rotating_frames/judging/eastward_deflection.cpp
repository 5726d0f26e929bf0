#include "solutions/02_rotating_frames/shared.hpp"

#include <boost/math/quadrature/gauss.hpp>

void judge_eastward_deflection(Lecture& lecture) {
  auto& e = lecture.exercise(&eastward_deflection,
                             {{"height", not_negative(metre)},
                              {"latitude", latitude_angle},
                              {"g", positive(m_per_s2)},
                              {"earth_rate", earth_rate}},
                             {"deflection", metre});
  e.worked("a tower of 110 m at 40° north", 110, 40 * degree, 9.81, our_earth_rate);
  e.special("the same tower at 45°, where sine and cosine are equal", 110, pi / 4, 9.81, our_earth_rate);
  e.special("on the equator", 110, 0, 9.81, our_earth_rate);
  e.special("at the pole", 110, pi / 2, 9.81, our_earth_rate);
  e.special("no height at all", 0, 40 * degree, 9.81, our_earth_rate);
  e.worked("the same tower at 40° south", 110, -40 * degree, 9.81, our_earth_rate);
  e.random("a random fall on a planet", 10, any::uniform(20, 300), generic_latitude, any::uniform(2, 15),
           any::uniform(3e-5, 2e-4));
  e.scale([](auto height, auto, auto g, auto rate) { return or_one(rate * sqrt(height * height * height / g)); });
  e.sweep<1>({"A fall of 110 m, from pole to pole", "latitude (°)", "deflection to the east (m)"}, {"east"}, {-90, 90},
             [](auto degrees) { return degrees * degree; });

  e.term("Ω g t³ cos λ", 1. / 3, [](auto&... inputs) { return 3 * eastward_deflection(inputs...); });
  e.wrong_input<1>("The latitude enters with its sine; across the fall it is Ω cos λ.", "sine", complement);
  e.wrong_output("This is half of the deflection: a 2 is lost, in the Coriolis term or in the time of the fall.",
                 "no_two", times(0.5));
  e.wrong_output({"This is 3/2 of it: ½ Ω g t³ cos λ, where two integrations of 2 Ω g t cos λ give ⅓ Ω g t³ cos λ.",
                  "rotating_frames_inertial_view"},
                 "excess_speed_kept", times(1.5));
  e.wrong_output("Your deflection is to the west: −2 Ω × v of a falling body points east.", "west", negated);
  e.wrong_output("This is 3 times too much, as with the final speed gt throughout.", "constant_acceleration", times(3));
  e.wrong_output("This is 6 times too much: 2Ωgt cos λ integrated twice has t³/6.", "integrated_once_short", times(6));
  e.wrong_input<1>("The latitude does not enter; the deflection shrinks with cos λ.", "no_latitude", fixed(0.0));
  e.wrong_output("This is what t = √(h/g) gives; h = ½ g t² gives t = √(2h/g).", "fall_time", times(1 / sqrt(8.0)));
  e.wrong_output("This is four times as far and west, as for a ball thrown up.", "thrown_up", times(-4));
  e.wrong_input<2>("Your answer does not follow the argument g.", "g_fixed", fixed(9.81));
  e.wrong_input<3>("Your answer does not follow the argument earth_rate; it is right only for our Earth.",
                   "earth_rate_fixed", fixed(our_earth_rate));
  e.angles_read_as_degrees();
  e.route("one formula",
          [](auto h, auto lat, auto g, auto rate) { return rate * cos(lat) / 3 * sqrt(8 * pow(h, 3) / g); });
  e.route("integrated twice by quadrature", [](auto h, auto latitude, auto g, auto rate) {
    // x(t) = ∫ (t − s) a(s) ds, a cubic polynomial in all: seven Gauss points are exact.
    const double t = sqrt(2 * h / g);
    const auto moved = [&](auto s) { return (t - s) * coriolis_acceleration({0, 0, -g * s}, latitude, rate).x(); };
    return t == 0 ? 0 : boost::math::quadrature::gauss<double, 7>::integrate(moved, 0.0, t);
  });
  e.route("steps of Runge and Kutta", [](auto h, auto latitude, auto g, auto rate) {
    // Position, velocity and time; a method of fourth order is exact for a cubic.
    const auto rates = [&](const Vector3d& now) { return Vector3d(now[1], 2 * rate * g * cos(latitude) * now[2], 1); };
    return followed(zero, sqrt(2 * h / g), 100, rates)[0];
  });
  e.route("seen from outside", [](auto h, auto latitude, auto g, auto rate) {
    // The top is ahead by Ωht cos λ, and the plumb line, turning with the Earth, pulls the body back by ⅙ g Ω t³ cos λ.
    const double t = sqrt(2 * h / g);
    return rate * cos(latitude) * (h * t - g * t * t * t / 6);
  });
}
