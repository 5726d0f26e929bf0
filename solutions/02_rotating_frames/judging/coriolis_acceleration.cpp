#include "solutions/02_rotating_frames/shared.hpp"

void judge_coriolis_acceleration(Lecture& lecture) {
  auto& e = lecture.exercise(&coriolis_acceleration,
                             {{"v_enu", m_per_s}, {"latitude", latitude_angle}, {"earth_rate", earth_rate}},
                             {"a_enu", m_per_s2});
  const Vector3d v0(30, -20, 10);
  e.worked("a flight over 40° north", v0, 40 * degree, our_earth_rate);
  e.special("at the north pole", v0, pi / 2, our_earth_rate);
  e.special("at the south pole", v0, -pi / 2, our_earth_rate);
  e.special("on the equator", v0, 0, our_earth_rate);
  e.special("at 45°, where sine and cosine are equal", v0, pi / 4, our_earth_rate);
  e.special("along the Earth's axis", {0, 30 * cos(0.7), 30 * sin(0.7)}, 0.7, our_earth_rate);
  e.special("at rest", zero, 0.7, our_earth_rate);
  e.random("a random velocity on a planet", 10, any::vector(100), generic_latitude, any::uniform(3e-5, 2e-4));
  e.scale([](auto& v, auto, auto rate) { return 2 * rate * max(v.norm(), 1.0); });
  e.sweep<1>({"A velocity of (30, −20, 10) m/s east, north, up, from pole to pole", "latitude (°)",
              "Coriolis acceleration (m/s²)"},
             {"east", "north", "up"}, {-90, 90}, [](auto degrees) { return degrees * degree; });

  e.term("Ω sin λ ẑ × v", -2, [](auto& v, auto lat, auto rate) { return rate * sin(lat) * cross(z_axis, v); });
  e.term("Ω cos λ ŷ × v", -2, [](auto& v, auto lat, auto rate) { return rate * cos(lat) * cross(y_axis, v); });
  e.wrong_terms("The sign is wrong: it is −2 Ω × v, to the right of a level velocity in the north.", "sign", {2, 2});
  e.wrong_terms("The factor 2 is missing: −2 Ω × v.", "no_two", {-1, -1});
  e.wrong_input<1>("Sine and cosine of the latitude are exchanged: at the pole the axis points up, by sin 90°.",
                   "sine_and_cosine_exchanged", complement);
  e.wrong_terms("Only the vertical part Ω sin λ of the rotation enters; velocities east and up need Ω cos λ too.",
                "vertical_rotation_only", {-2, 0});
  e.wrong_terms("Only the northward part Ω cos λ of the rotation enters; its vertical part Ω sin λ is missing.",
                "horizontal_rotation_only", {0, -2});
  e.wrong_input<1>("The Earth's axis points up here, as only at the north pole.", "axis_always_up", fixed(pi / 2));
  e.wrong("The Earth's axis leans to the east here, not north.", "axis_to_the_east", [](auto& v, auto lat, auto rate) {
    return -2 * rate * cross({cos(lat), 0, sin(lat)}, v);
  });
  e.wrong_terms("The Earth's axis leans to the south here; in either hemisphere its level part points north.",
                "axis_to_the_south", {-2, 2});
  e.wrong_terms("The vertical part of the rotation has the wrong sign: it is +Ω sin λ, with λ < 0 in the south.",
                "southern_sign", {2, -2});
  e.wrong_input<1>("Your answer is the same at −λ as at λ; the vertical part Ω sin λ changes sign at the equator.",
                   "always_northern", without_sign);
  e.wrong_output("The vertical component is missing: motion to the east makes a body lighter by 2 Ω cos λ v_east.",
                 "horizontal_result_only", zeroed(2));
  e.wrong_input<2>("Your answer does not follow the argument earth_rate; it is right only for our Earth.",
                   "earth_rate_fixed", fixed(our_earth_rate));
  e.angles_read_as_degrees();
  e.perpendicular_to(0, "The Coriolis acceleration is perpendicular to the velocity: it does no work.");
  e.route("component by component", [](auto& v, auto latitude, auto rate) {
    const double vertical = 2 * rate * sin(latitude), northward = 2 * rate * cos(latitude);
    return Vector3d(vertical * v[1] - northward * v[2], -vertical * v[0], northward * v[0]);
  });
  e.route("on axes along the Earth's axis", [](auto& v, auto latitude, auto rate) {
    // Tilt the local axes about east until "up" is the Earth's axis, take the simple product there, tilt back.
    const Matrix3d tilt = turn(x_axis, pi / 2 - latitude);
    const Vector3d u = tilt * v;
    return tilt.transpose() * Vector3d(2 * rate * u.y(), -2 * rate * u.x(), 0);
  });
  e.route("with the cross matrix", [](auto& v, auto latitude, auto rate) {
    return 2 * skew(rate * Vector3d(0, cos(latitude), sin(latitude))).transpose() * v;
  });
}
