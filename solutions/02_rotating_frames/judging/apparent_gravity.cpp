#include "solutions/02_rotating_frames/shared.hpp"

/// The position of the ship at the time t in the inertial frame, on the local axes of the time 0.
static Vector3d ship_at(double t, double latitude, double radius, double rate, const Vector2d& v) {
  const Vector3d axis(0, cos(latitude), sin(latitude)), heading = Vector3d(v.x(), v.y(), 0).stableNormalized();
  const double angle = v.norm() * t / radius;
  return turn(axis, rate * t) * (radius * (cos(angle) * z_axis + sin(angle) * heading));
}

static void add_routes_of_apparent_gravity(auto& e) {
  e.route("the path in the inertial frame, differentiated twice", [](auto lat, auto R, auto g, auto rate, auto& v) {
    const double h = 2e-2 / (rate + v.norm() / R);
    const double weights[] = {-49. / 18, 3. / 2, -3. / 20, 1. / 90};
    Vector3d sum = weights[0] * ship_at(0, lat, R, rate, v);
    for (int k = 1; k <= 3; ++k)
      sum += weights[k] * (ship_at(k * h, lat, R, rate, v) + ship_at(-k * h, lat, R, rate, v));
    return -g * z_axis - sum / (h * h);
  });
  e.route("a point at rest in the frame of the ship", [](auto lat, auto R, auto g, auto rate, auto& v) {
    // This frame rotates with Ω and, about the axis of the great circle, with v/R, which Ω carries round.
    const Vector3d Omega = rate * Vector3d(0, cos(lat), sin(lat)), along = cross(z_axis, {v.x(), v.y(), 0}) / R;
    const Vector3d w = Omega + along, r = R * z_axis;
    return -g * z_axis - cross(cross(Omega, along), r) - cross(w, cross(w, r));
  });
  e.route("up from the speed among the stars", [](auto lat, auto R, auto g, auto rate, auto& v) {
    const double east = v.x() + rate * R * cos(lat), turning = rate * sin(lat);
    const double up = (east * east + v.y() * v.y()) / R - g;
    return Vector3d(2 * turning * v.y(), -turning * (east + v.x()), up);
  });
}

void judge_apparent_gravity(Lecture& lecture) {
  auto& e = lecture.exercise(&apparent_gravity,
                             {{"latitude", latitude_angle},
                              {"radius", positive(metre)},
                              {"g0", positive(m_per_s2)},
                              {"earth_rate", earth_rate},
                              {"v", m_per_s}},
                             {"g_apparent", m_per_s2});
  e.domain([](auto&... inputs) { return apparent_gravity(inputs...)[2] < 0; });
  const double our_radius = 6.371e6, g0 = 9.83;
  const Vector2d v0(180, -120), ashore(0, 0);
  e.worked("an aeroplane over 40° north", 40 * degree, our_radius, g0, our_earth_rate, v0);
  e.special("ashore at 45°, where the plumb line deviates most", pi / 4, our_radius, g0, our_earth_rate, ashore);
  e.special("ashore on the equator", 0, our_radius, g0, our_earth_rate, ashore);
  e.special("ashore at the north pole", pi / 2, our_radius, g0, our_earth_rate, ashore);
  e.special("northwards from the south pole", -pi / 2, our_radius, g0, our_earth_rate, {0, 100});
  e.special("westwards along the equator, against the rotation", 0, our_radius, g0, our_earth_rate,
            {-our_radius * our_earth_rate, 0});
  e.special("eastwards at 60° south", -60 * degree, our_radius, g0, our_earth_rate, {20, 0});
  e.limit("ashore at the north pole", {0, 0, -g0}, "On the axis nothing goes round: the attraction is all.");
  e.limit("westwards along the equator, against the rotation", {0, 0, -g0},
          "For somebody in space this ship stands still, so only the attraction is felt.");
  e.random("a random ship on a planet", 10, generic_latitude, any::uniform(2e6, 2e7), any::uniform(5, 15),
           any::uniform(3e-5, 2e-4), [](Random& random) -> Vector2d { return random.vector(300).head<2>(); });
  e.scale([](auto, auto, auto g, auto, auto&) { return g; });
  e.sweep({"Aboard a ship on our Earth's equator that sails east (or, with a negative speed, west)",
           "speed to the east (m/s)", "component up (m/s²)"},
          {{"up", 2}}, {-900, 900},
          [](auto east) { return tuple(0, 6.371e6, 9.83, our_earth_rate, Vector2d(east, 0)); });

  e.term("the attraction", 1, [](auto, auto, auto g, auto, auto&) -> Vector3d { return -g * z_axis; });
  e.term("the centrifugal term", 1, [](auto lat, auto R, auto, auto rate, auto&) {
    return rate * rate * R * cos(lat) * Vector3d(0, -sin(lat), cos(lat));
  });
  e.term("the Coriolis term", -2, [](auto lat, auto, auto, auto rate, auto& v) {
    return rate * cross({0, cos(lat), sin(lat)}, {v.x(), v.y(), 0});
  });
  e.term("the curvature of the track", 1,
         [](auto, auto R, auto, auto, auto& v) -> Vector3d { return v.squaredNorm() / R * z_axis; });
  e.wrong_terms("The ship has no acceleration relative to the planet here; but a great circle is curved.",
                "no_track_curvature", {1, 1, -2, 0});
  e.wrong_terms("The centrifugal term is missing; g0 is the attraction alone.", "no_centrifugal", {1, 0, -2, 1});
  e.wrong_terms("The Coriolis term lacks its factor 2.", "coriolis_without_two", {1, 1, -1, 1});
  e.wrong_terms("The Coriolis term has the wrong sign: what moves east becomes lighter.", "coriolis_sign",
                {1, 1, 2, 1});
  e.wrong_terms("The Coriolis term is missing; the ship moves relative to the planet.", "no_coriolis", {1, 1, 0, 1});
  e.wrong_terms("The curvature of the track has the wrong sign: a ship that accelerates downwards becomes lighter.",
                "track_sign", {1, 1, -2, -1});
  e.wrong_terms({"The centrifugal term has the wrong sign: it points away from the axis.", brackets},
                "centrifugal_inward", {1, -1, -2, 1});
  e.wrong_terms("The acceleration of the ship is added; what falls freely aboard lags behind it, so it is subtracted.",
                "acceleration_added", {1, -1, 2, -1});
  e.wrong_terms("The centrifugal term enters three times, twice from the inertial velocity in the Coriolis term.",
                "inertial_velocity", {1, 3, -2, 1});
  e.wrong_output("Only the vertical part of the centrifugal term enters; it points away from the axis, not upwards.",
                 "centrifugal_up_only", [](auto& g, auto lat, auto R, auto, auto rate, auto&) {
                   g[1] += rate * rate * R * cos(lat) * sin(lat);
                 });
  e.wrong_output("Your ship follows its circle of latitude, which bends towards the pole; a great circle does not.",
                 "circle_of_latitude",
                 [](auto& g, auto lat, auto R, auto, auto, auto& v) { g[1] -= v.x() * v.x() * tan(lat) / R; });
  e.wrong_output("The components east and north are missing; a plumb line does not point to the centre.",
                 "vertical_only", [](auto& g, auto&...) { g.template head<2>().setZero(); });
  e.wrong_output("This is the force per mass that holds a body aboard, upwards; free fall is the other way.", "upwards",
                 negated);
  e.angles_read_as_degrees();
  add_routes_of_apparent_gravity(e);
}
