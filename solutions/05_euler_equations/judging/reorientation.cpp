#include "solutions/05_euler_equations/shared.hpp"

namespace {

using Wheels = Vector3d;  // J₁ Δα₁ and J₂ Δα₂ of one leg, and 0
std::vector<Wheels> legs_of(const Vector2d& J, const VectorXd& wheel1, const VectorXd& wheel2) {
  std::vector<Wheels> legs;
  for (Eigen::Index k = 1; k < wheel1.size(); ++k)
    legs.emplace_back(J[0] * (wheel1[k] - wheel1[k - 1]), J[1] * (wheel2[k] - wheel2[k - 1]), 0);
  return legs;
}

/// The attitude from what a leg makes of it.
template <class Leg>
auto leg_by_leg(const Leg& leg) {
  return [leg](auto& I, auto& J, auto& wheel1, auto& wheel2) {
    Matrix3d A = Matrix3d::Identity();
    for (const Wheels& wheels : legs_of(J, wheel1, wheel2)) A = leg(A, I, J, wheels);
    return A;
  };
}

Matrix3d rotation_by(const Vector3d& vector) { return turn(vector, vector.norm()); }
Matrix3d tensor_of_wheels(const Vector2d& J) { return Vector3d(J[0], J[1], 0).asDiagonal(); }

/// With the torques of the motors: wheels that start and stop smoothly on a leg of one second.
Matrix3d by_torques(const Matrix3d& A, const Matrix3d& I, const Vector2d&, const Wheels& wheels) {
  using State = Eigen::Matrix<double, 3, 5>;  // ω, the attitude, and the time in a corner
  State now = State::Zero();
  now.middleCols<3>(1) = A;
  const State end =
      followed(now, 1, 100 + static_cast<int>(200 * (I.inverse() * wheels).norm()), [&](const State& state) {
        const double t = state(0, 4), rest = t * (1 - t);
        const Vector3d w = state.col(0), h = 30 * rest * rest * wheels, h_rate = 60 * rest * (1 - 2 * t) * wheels;
        State rates = State::Zero();
        rates.col(0) = euler_equations_general(I, w, -h_rate - cross(w, h));
        rates.middleCols<3>(1) = Matrix3d(state.middleCols<3>(1)) * skew(w);
        rates(0, 4) = 1;
        return rates;
      });
  return end.middleCols<3>(1);
}

/// How far the body would turn by each wheel alone, at most.
double turned_by_wheels(const Matrix3d& I, const Vector2d& J, const VectorXd& wheel1, const VectorXd& wheel2) {
  Vector3d run = zero;
  for (const Wheels& wheels : legs_of(J, wheel1, wheel2)) run += wheels.cwiseAbs();
  const Matrix3d inverse = I.inverse();
  return max((inverse.col(0) * run[0]).norm(), (inverse.col(1) * run[1]).norm());
}

const Matrix3d cat{{4.3, -0.4, -0.4}, {-0.4, 3.6, -0.4}, {-0.4, -0.4, 1.7}};
const Matrix3d principal = Vector3d(2, 3, 4).asDiagonal();

}  // namespace

void judge_reorientation(Lecture& lecture) {
  auto& e = lecture.exercise(
      &reorientation, {{"I", regular_tensor}, {"J", positive(kg_m2)}, {"wheel1", rad}, {"wheel2", rad}}, {"A", none});
  e.domain([](auto& I, auto& J, auto& wheel1, auto& wheel2) {
    return wheel1.size() > 0 && wheel1.size() == wheel2.size() &&
           PrincipalFrame(I - tensor_of_wheels(J)).moments[0] > 0 && turned_by_wheels(I, J, wheel1, wheel2) <= 8;
  });
  e.generated([](auto& I, auto& J, auto& wheel1, auto& wheel2) { return turned_by_wheels(I, J, wheel1, wheel2) <= 4; });
  const VectorXd on_1{{0, 60, 60, 0, 0}}, on_2{{0, 0, 80, 80, 0}};
  e.worked("around a rectangle, on principal axes", principal, {0.05, 0.04}, on_1, on_2);
  e.worked("around a rectangle, with products of inertia", cat, {0.02, 0.03}, VectorXd{{0, 150, 150, 0, 0}},
           VectorXd{{0, 0, 100, 100, 0}});
  e.special("one wheel alone", principal, {0.05, 0.04}, VectorXd{{0, 60, 20}}, VectorXd{{3, 3, 3}});
  e.special("one leg, both wheels at once", cat, {0.02, 0.03}, VectorXd{{0, 150}}, VectorXd{{0, -100}});
  e.special("there and back on the same way", cat, {0.02, 0.03}, VectorXd{{0, 150, 150, 150, 0}},
            VectorXd{{0, 0, 100, 0, 0}});
  e.special("around a triangle", principal, {0.05, 0.04}, VectorXd{{0, 60, 0, 0}}, VectorXd{{0, 80, 80, 0}});
  e.special("a pause in between", principal, {0.05, 0.04}, VectorXd{{0, 60, 60, 60}}, VectorXd{{0, 0, 0, 80}});
  e.special("no path", principal, {0.05, 0.04}, VectorXd{{7}}, VectorXd{{-2}});
  e.special("a small loop", principal, {0.05, 0.04}, 0.01 * on_1, 0.01 * on_2);
  e.special("the first wheel hardly moves", principal, {0.05, 0.04}, VectorXd{{0, 9e-4, 2e-4}}, VectorXd{{0, 10, 50}});
  e.special("corners close together", principal, {0.05, 0.04}, VectorXd{{5, 5.005, 5.002, 5.008}},
            VectorXd{{0, 60, 20, 80}});
  e.limit("one wheel alone", turn(x_axis, -20 * 0.05 / 2),
          "About the one axis the angles divide in the ratio of the moments: what the wheel has gained, the satellite "
          "turns back.");
  e.limit("there and back on the same way", Matrix3d::Identity(),
          "Each step is undone by the step back; a loop must enclose an area.");
  e.random("a random path", 8, [](Random& random) {
    const Matrix3d I = random.inertia_tensor();
    const Vector2d J(random.uniform(0.02, 0.06), random.uniform(0.02, 0.06));
    const int corners = random.whole(4, 6);
    VectorXd one(corners), other(corners);
    for (int k = 0; k < corners; ++k) {
      one[k] = (k % 2 == 0 ? 1 : -1) * random.uniform(5, 12);
      other[k] = (k / 2 % 2 == 0 ? 1 : -1) * random.uniform(5, 12);
    }
    return tuple(I, J, one, other);
  });
  e.tolerance(1e-6, "The answer may be integrated in steps, as that of free_attitude.");
  e.scale(1);
  e.sweep(
      {"Once around a square of wheel angles: how far each axis has moved", "side of the square (rad)",
       "cosine of the angle"},
      {{"axis 1", 0, 0}, {"axis 2", 1, 1}, {"axis 3", 2, 2}}, {0, 120}, [](auto side) {
        return tuple(principal, Vector2d(0.05, 0.04), VectorXd{{0, side, side, 0, 0}}, VectorXd{{0, 0, side, side, 0}});
      });

  e.wrong({"These are rotations about axes at rest: the axes of the wheels go with the body, so each leg multiplies on "
           "the other side.",
           "euler_equations_attitude"},
          "left_product",
          leg_by_leg([](auto& A, auto& I, auto&, auto& wheels) { return rotation_by(-(I.inverse() * wheels)) * A; }));
  e.wrong("This is a single rotation, from where the wheels began and ended; on the way the axes turn.", "ends_only",
          [](auto& I, auto& J, auto& wheel1, auto& wheel2) {
            Vector3d sum = zero;
            for (const Wheels& wheels : legs_of(J, wheel1, wheel2)) sum += wheels;
            return rotation_by(-(I.inverse() * sum));
          });
  e.wrong("The body turns with its wheels here; what the wheels have, it must have with the opposite sign.", "sense",
          leg_by_leg([](auto& A, auto& I, auto&, auto& wheels) { return A * rotation_by(I.inverse() * wheels); }));
  e.wrong("The wheels are counted twice in the inertia; the tensor of the whole contains them.", "wheels_twice",
          leg_by_leg([](auto& A, auto& I, auto& J, auto& wheels) {
            return A * rotation_by(-((I + tensor_of_wheels(J)).inverse() * wheels));
          }));
  e.wrong("The wheels are taken out of the inertia; they are carried round with the body too.", "wheels_left_out",
          leg_by_leg([](auto& A, auto& I, auto& J, auto& wheels) {
            return A * rotation_by(-((I - tensor_of_wheels(J)).inverse() * wheels));
          }));
  e.wrong("On each leg the second wheel starts after the first one has stopped; both run at once.",
          "one_after_the_other", leg_by_leg([](auto& A, auto& I, auto&, auto& wheels) {
            const Vector3d first(wheels[0], 0, 0), second(0, wheels[1], 0);
            return A * rotation_by(-(I.inverse() * first)) * rotation_by(-(I.inverse() * second));
          }));
  e.wrong("The angles of the first corner count as a leg; there the body is still as it was.", "from_angle_zero",
          [](auto& I, auto& J, auto& wheel1, auto& wheel2) {
            const Vector3d before(J[0] * wheel1[0], J[1] * wheel2[0], 0);
            return rotation_by(-(I.inverse() * before)) * reorientation(I, J, wheel1, wheel2);
          });
  e.wrong_input<0>(products_missing, "diagonal_only", diagonal_part);
  e.wrong_output("This is the transposed matrix: the body axes are its rows; they should be its columns.", "transposed",
                 transposed);
  e.wrong("The body does not turn at all here; without a torque it is L that stays zero, not ω.", "at_rest",
          [](auto&...) { return Matrix3d(Matrix3d::Identity()); });
  e.property(Is::rotation_matrix, "The body axes stay at right angles and of length 1, and right-handed.");
  e.route("quaternions", [](auto& I, auto& J, auto& wheel1, auto& wheel2) -> Matrix3d {
    Eigen::Quaterniond q(1, 0, 0, 0);
    for (const Wheels& wheels : legs_of(J, wheel1, wheel2)) {
      const Vector3d half = -(I.ldlt().solve(wheels)) / 2;
      const double angle = half.norm(), sinc = angle > 0 ? sin(angle) / angle : 1;
      q = q * Eigen::Quaterniond(cos(angle), sinc * half[0], sinc * half[1], sinc * half[2]);
    }
    return q.normalized().toRotationMatrix();
  });
  e.route("the torques of the motors, with starts and stops", leg_by_leg(by_torques));
  e.route("the way back, by the series of the exponential",
          [](auto& I, auto& J, auto& wheel1, auto& wheel2) -> Matrix3d {
            Matrix3d back = Matrix3d::Identity();
            for (const Wheels& wheels : legs_of(J, wheel1.reverse(), wheel2.reverse())) {
              const Matrix3d X = skew(I.inverse() * wheels) / -1024;
              Matrix3d less_one = X + X * X / 2 + X * X * X / 6 + X * X * X * X / 24;
              for (int i = 0; i < 10; ++i) less_one = 2 * less_one + less_one * less_one;
              back = back + back * less_one;
            }
            return back.transpose();
          });
}
