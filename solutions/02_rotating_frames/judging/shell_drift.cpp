#include "solutions/02_rotating_frames/shared.hpp"

#include <boost/math/quadrature/gauss.hpp>

/// Level directions of fire and to its right: east, north, up.
static Vector3d line_of_fire(double azimuth) { return {sin(azimuth), cos(azimuth), 0}; }
static Vector3d to_the_right(double azimuth) { return {cos(azimuth), -sin(azimuth), 0}; }

static void add_routes_of_shell_drift(auto& e) {
  e.route("the Coriolis acceleration integrated twice",
          [](auto lat, auto azimuth, auto range, auto time, auto g, auto rate) {
            const auto moved = [&](double t) {
              const Vector3d v = range / time * line_of_fire(azimuth) + g * (time / 2 - t) * z_axis;
              return (time - t) * to_the_right(azimuth).dot(coriolis_acceleration(v, lat, rate));
            };
            return boost::math::quadrature::gauss<double, 7>::integrate(moved, 0.0, time);
          });
  e.route("the whole motion, differentiated with respect to the rate",
          [](auto lat, auto azimuth, auto range, auto time, auto g, auto rate) {
            using State = Eigen::Matrix<double, 6, 1>;
            const auto drift_at = [&](double slow) {
              State state;
              state << zero, range / time * line_of_fire(azimuth) + g * time / 2 * z_axis;
              const auto motion = [&](const State& s) -> State {
                const Vector3d v = s.tail<3>(), a = -2 * slow * cross({0, cos(lat), sin(lat)}, v) - g * z_axis;
                return (State() << v, a).finished();
              };
              return to_the_right(azimuth).dot(one_step_on(state, time, motion).template head<3>());
            };
            const double h = 1e-3 / time;
            return rate * (8 * (drift_at(h) - drift_at(-h)) - (drift_at(2 * h) - drift_at(-2 * h))) / (12 * h);
          });
  e.route("−2 Ω × the integral of the path over time",
          [](auto lat, auto azimuth, auto range, auto time, auto g, auto rate) {
            const double mean_height = g * time * time / 12;
            const Vector3d integral = range * time / 2 * line_of_fire(azimuth) + mean_height * time * z_axis;
            return -2 * rate * cross({0, cos(lat), sin(lat)}, integral).dot(to_the_right(azimuth));
          });
}

void judge_shell_drift(Lecture& lecture) {
  auto& e = lecture.exercise(&shell_drift,
                             {{"latitude", latitude_angle},
                              {"azimuth", rad},
                              {"range", not_negative(metre)},
                              {"time", positive(second)},
                              {"g", positive(m_per_s2)},
                              {"earth_rate", earth_rate}},
                             {"drift", metre});
  const double our_g = 9.81;
  e.worked("the gun that shelled Paris", 49.5 * degree, 232 * degree, 120e3, 176, our_g, our_earth_rate);
  e.worked("to the south at 35° south", -35 * degree, pi, 20e3, 60, our_g, our_earth_rate);
  e.special("northwards from the equator", 0, 0, 20e3, 60, our_g, our_earth_rate);
  e.special("eastwards along the equator", 0, pi / 2, 20e3, 60, our_g, our_earth_rate);
  e.special("westwards, where the climb does not matter", 40 * degree, -pi / 2, 20e3, 60, our_g, our_earth_rate);
  e.special("from the north pole", pi / 2, 1, 20e3, 60, our_g, our_earth_rate);
  e.special("from the south pole", -pi / 2, 1, 20e3, 60, our_g, our_earth_rate);
  e.special("at 45°, where sine and cosine are equal", pi / 4, 0.4, 20e3, 60, our_g, our_earth_rate);
  e.special("straight up", 40 * degree, 0, 0, 60, our_g, our_earth_rate);
  e.limit("eastwards along the equator", 0,
          "Path and weight stay in the plane of the equator, and nothing leads out of it.");
  e.limit("from the north pole", 20e3 * our_earth_rate * 60,
          "Seen from space the shell flies straight, and the ground turns to the left below it through the angle of "
          "the Earth's rotation.");
  e.random(
      "a random shot on a planet", 10, generic_latitude,
      [](Random& random) {
        const double off = random.uniform(0.2, 1.1);
        return random.whole(0, 3) * pi / 2 + off;
      },
      any::uniform(1e4, 1e5), any::uniform(50, 200), any::uniform(5, 15), any::uniform(3e-5, 2e-4));
  e.scale([](auto, auto, auto range, auto time, auto g, auto rate) {
    return rate * (range * time + g * time * time * time / 6);
  });
  e.sweep({"A shell that flies 20 km in a minute at 50° north", "direction of fire, from north over east (°)",
           "drift to the right (m)"},
          {"drift"}, {0, 360, 73},
          [](auto azimuth) { return tuple(50 * degree, azimuth * degree, 2e4, 60, 9.81, our_earth_rate); });

  e.term("the level flight", 1,
         [](auto lat, auto, auto range, auto time, auto, auto rate) { return rate * range * time * sin(lat); });
  e.term("climb and fall", -1. / 6, [](auto lat, auto azimuth, auto, auto time, auto g, auto rate) {
    return rate * g * pow(time, 3) * cos(lat) * cos(azimuth);
  });
  e.wrong_terms("Only the level flight is deflected here; a shell that climbs is pushed west, one that falls east.",
                "level_flight", {1, 0});
  e.wrong_terms("Climb and fall enter with the wrong sign: the climb pushes west and acts longer than the fall.",
                "climb_sign", {1, 1. / 6});
  e.wrong_terms("Climb and fall enter as for a stone dropped from rest; a shell arrives at the top drifting west.",
                "drop_from_rest", {1, 1. / 3});
  e.wrong_output(
      "This is twice the drift, as without the half that two integrations of the deflecting acceleration bring.",
      "without_half", times(2));
  e.wrong_output("This is half of the drift, as without the 2 of the Coriolis acceleration.", "no_two", times(0.5));
  e.wrong_output("Your drift is to the left; positive is to the right.", "to_the_left", negated);
  e.wrong_input<0>("Sine and cosine of the latitude are exchanged: at the pole the axis points up.", "sin_cos_swapped",
                   complement);
  e.wrong_input<0>("Your drift is the same south of the equator; the vertical part of the rotation changes sign there.",
                   "always_northern", without_sign);
  e.wrong_input<1>("Your azimuth is counted from the east, anticlockwise; it comes from north, clockwise.",
                   "azimuth_from_east", complement);
  e.wrong_input<1>("The azimuth does not enter; the climb matters most for a shot along the meridian.", "no_azimuth",
                   fixed(0.0));
  e.angles_read_as_degrees();
  add_routes_of_shell_drift(e);
}
