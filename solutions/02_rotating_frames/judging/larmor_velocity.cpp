#include "solutions/02_rotating_frames/shared.hpp"

/// The velocity with a rotation and a transport of one's own, both in units of −qB/2m.
static auto carried(double turned, double transported) {
  return [=](auto& field, auto& r, auto& v, auto t) {
    const Vector3d omega = -field / 2;
    return turn(omega, turned * omega.norm() * t) * (v + transported * cross(omega, r));
  };
}

void judge_larmor_velocity(Lecture& lecture) {
  auto& e = lecture.exercise(&larmor_velocity,
                             {{"qB_over_m", rad_per_s}, {"r_free", metre}, {"v_free", m_per_s}, {"t", second}},
                             {"v", m_per_s});
  e.generated([](auto& field, auto&, auto&, auto t) { return field.norm() * abs(t) < 1e3; });
  const Vector3d downwards(0, 0, -0.4), start(1, 2, -1), start_velocity(0.4, -0.3, 0.6);
  e.worked("an electron, the field upwards", downwards, start, start_velocity, 5);
  e.worked("a positive charge, an oblique field", {0.3, -0.2, 0.5}, start, start_velocity, -3);
  e.special("at time 0", downwards, start, start_velocity, 0);
  e.special("no field", zero, start, start_velocity, 5);
  e.special("at rest on the rotating axes", downwards, start, zero, 5);
  e.special("on the axis through the centre along the field", downwards, {0, 0, 2}, {0, 0, -0.7}, 5);
  e.special("after a full rotation of the orbit", downwards, start, start_velocity, 10 * pi);
  e.random("a random orbit", 10, [](Random& random) {
    const Vector3d q = random.vector(0.8), place = random.vector(2), velocity = random.vector(1);
    return tuple(q, place, velocity, random.sign() * random.uniform(0.5, 1.2) * 2 / q.norm());
  });
  e.scale([](auto& field, auto& r, auto& v, auto) { return or_one(v.norm() + field.norm() * r.norm()); });
  e.sweep({"An electron on an ellipse that a field upwards rotates", "time (s)", "velocity (m/s)"}, {"x", "y"},
          {0, 40, 161}, [](auto t) {
            return tuple(Vector3d(0, 0, -0.1), Vector3d(cos(t), 0.2 * sin(t), 0), Vector3d(-sin(t), 0.2 * cos(t), 0),
                         t);
          });

  e.wrong("The orbit rotates with qB/m, the rate of a free charge; the Coriolis term has a 2, so half of it will do.",
          "cyclotron", carried(2, 2));
  e.wrong("This is the free orbit as seen from the rotating axes; it is the orbit in the field that looks free there.",
          "sense", carried(-1, -1));
  e.wrong({"The rotating axes carry the charge along: ω × r is missing.", "rotating_frames_derivation"}, "no_transport",
          carried(1, 0));
  e.wrong("ω × r has the wrong sign here: the axes carry the charge along.", "transport_sign", carried(1, -1));
  e.wrong("ω × r is right, and the rotation goes the wrong way: to the laboratory it goes with the rotating axes.",
          "rotated_back", carried(-1, 1));
  e.wrong("These are components on the rotating axes; the velocity is still to be rotated to the laboratory.",
          "rotating_axes", carried(0, 1));
  e.wrong("The rotation is cut off after its first order; the angle grows without bound.", "first_order",
          [](auto& field, auto& r, auto& v, auto t) -> Vector3d {
            const Vector3d omega = -field / 2, seen = v + cross(omega, r);
            return seen + t * cross(omega, seen);
          });
  e.route("the place in the laboratory, differentiated", [](auto& field, auto& r, auto& v, auto t) -> Vector3d {
    const auto place = [&](double later) { return turn(field, -field.norm() / 2 * (t + later)) * (r + later * v); };
    return derivative_at_0(place, 0.01 / or_one(field.norm()));
  });
  e.route("the parts along and across the field", [](auto& field, auto& r, auto& v, auto t) -> Vector3d {
    const Vector3d n = field.stableNormalized(), seen = v - cross(field, r) / 2;
    const Vector3d along = n * n.dot(seen), across = seen - along;
    const double angle = -field.norm() / 2 * t;
    return along + cos(angle) * across + sin(angle) * cross(n, across);
  });
  e.route("place and velocity by the exponential of a matrix", [](auto& field, auto& r, auto& v, auto t) -> Vector3d {
    const int halvings = 24;
    const Matrix3d W = skew(-field / 2), X = W * (t / std::exp2(halvings));
    Matrix3d less_one = X + X * X / 2 + X * X * X / 6;
    for (int i = 0; i < halvings; ++i) less_one = 2 * less_one + less_one * less_one;
    return W * (r + less_one * r) + v + less_one * v;
  });
}
