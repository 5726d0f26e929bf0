#include "solutions/11_measured/shared.hpp"

/// One step after the other, from the unit matrix; each is the product of what was there and the step's rotation
/// vector.
template <class Step>
static Matrix3d stepped(const VectorXd& t, const Matrix3Xd& omega, const Step& step) {
  Matrix3d A = Matrix3d::Identity();
  for (Eigen::Index k = 1; k < t.size(); ++k) {
    const Vector3d mean = (omega.col(k - 1) + omega.col(k)) / 2.0;
    const Vector3d vector = (t[k] - t[k - 1]) * mean;
    A = step(A, vector, k);
  }
  return A;
}

static Matrix3d rotation_by(const Vector3d& vector) { return turn(vector, vector.norm()); }

/// e^[Θ]× by its series for a small part of the angle, squared again and again.
static Matrix3d by_series(const Vector3d& vector) {
  const Matrix3d small = skew(vector / 1024.0);
  Matrix3d term = Matrix3d::Identity(), sum = term;
  for (int k = 1; k < 12; ++k) {
    term = term * small / static_cast<double>(k);
    sum = sum + term;
  }
  for (int k = 0; k < 10; ++k) sum = sum * sum;
  return sum;
}

void judge_attitude_from_rates(Lecture& lecture) {
  auto& e = lecture.exercise(&attitude_from_rates, {{"t", second}, {"omega", rad_per_s}}, {"A", none});
  e.domain([](auto& t, auto& omega) { return t.size() >= 1 && omega.cols() == t.size() && ascends(t); });
  e.generated([](auto& t, auto& omega) {
    return (t[t.size() - 1] - t[0]) * (omega.size() > 0 ? omega.cwiseAbs().maxCoeff() : 0.0) < 100;
  });
  e.worked("a thrown racket", racket_times, racket_rates);
  e.worked("two samples", VectorXd{{0, 0.5}}, Matrix3Xd{{0.2, 0.4}, {1, 0.6}, {-0.3, 0.5}});
  e.special("one sample", VectorXd{{2}}, Matrix3Xd{{1}, {2}, {3}});
  e.special("at rest", VectorXd{{0, 1, 2}}, Matrix3Xd::Zero(3, 3));
  e.special("about one axis", VectorXd{{0, 1, 3}}, Matrix3Xd{{0, 0, 0}, {0, 0, 0}, {0.5, 1, -0.5}});
  e.special("to and fro", VectorXd{{0, 1, 2}}, Matrix3Xd{{1, -1, 1}, {2, -2, 2}, {3, -3, 3}});
  e.random("a flight with noise", 10, noisy_flight(4, 7));
  e.measured("throw 3 of the racket, from its start to its end", {}, throw_3.t, throw_3.omega);
  e.scale(1);
  e.sweep({"A thrown racket, shown slower or faster", "time between two samples beside the measured one",
           "component on the inertial axes"},
          {{"x axis, x", 0, 0}, {"y axis, y", 1, 1}, {"z axis, z", 2, 2}}, {0.05, 1},
          [](auto pace) { return tuple(pace * racket_times, racket_rates); });

  e.wrong_output("This is the transpose of the attitude: it makes body components of inertial ones.", "transposed",
                 transposed);
  e.wrong("Your rotations stand on the left, as for axes at rest; the axis of each is fixed in the body.", "left",
          [](auto& t, auto& omega) {
            return stepped(t, omega, [](auto& A, auto& angle, auto) { return rotation_by(angle) * A; });
          });
  e.wrong("Each of your steps is the unit matrix and a small change, which is no rotation; the angles are finite.",
          "first_order", [](auto& t, auto& omega) {
            return stepped(t, omega, [](auto& A, auto& angle, auto) { return A + A * skew(angle); });
          });
  e.wrong(
      "Each of your steps is the unit matrix and a small change; to make a rotation of their product does not help.",
      "first_order_made_rotation", [](auto& t, auto& omega) {
        const Matrix3d A =
            stepped(t, omega, [](auto& so_far, auto& angle, auto) { return so_far + so_far * skew(angle); });
        const Eigen::JacobiSVD<Matrix3d> parts(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
        return Matrix3d(parts.matrixU() * parts.matrixV().transpose());
      });
  e.wrong(
      "Each of your steps is a series cut after the square of the angle, which is no rotation; the angles are finite.",
      "second_order", [](auto& t, auto& omega) {
        return stepped(t, omega, [](auto& A, auto& angle, auto) {
          const Matrix3d W = skew(angle);
          return A + A * W + A * W * W / 2;
        });
      });
  e.wrong(
      "Each of your steps turns by 2 atan(Θ/2), as the quaternion (1, Θ/2) does when its length is made 1; it turns by "
      "Θ.",
      "cayley", [](auto& t, auto& omega) {
        return stepped(t, omega,
                       [](auto& A, auto& angle, auto) { return A * turn(angle, 2 * atan(angle.norm() / 2)); });
      });
  e.wrong("Each of your steps takes the earlier of two rates; it takes their mean.", "earlier_rate",
          [](auto& t, auto& omega) {
            return stepped(t, omega, [&](auto& A, auto&, auto k) {
              return A * rotation_by((t[k] - t[k - 1]) * Vector3d(omega.col(k - 1)));
            });
          });
  e.wrong("Each of your steps takes the later of two rates; it takes their mean.", "later_rate",
          [](auto& t, auto& omega) {
            return stepped(t, omega, [&](auto& A, auto&, auto k) {
              return A * rotation_by((t[k] - t[k - 1]) * Vector3d(omega.col(k)));
            });
          });
  e.wrong("Each of your steps is two half ones, by the earlier rate and by the later; it is one by their mean.",
          "half_steps", [](auto& t, auto& omega) {
            return stepped(t, omega, [&](auto& A, auto&, auto k) {
              const double half = (t[k] - t[k - 1]) / 2;
              return A * rotation_by(half * Vector3d(omega.col(k - 1))) * rotation_by(half * Vector3d(omega.col(k)));
            });
          });
  e.wrong("The rotation vectors of all steps are added, and that is one rotation; rotations follow each other.",
          "angles_added", [](auto& t, auto& omega) {
            Vector3d sum = zero;
            stepped(t, omega, [&](auto& A, auto& angle, auto) {
              sum += angle;
              return A;
            });
            return rotation_by(sum);
          });
  e.wrong_input<0>("All of your steps are equally long; the times are not evenly spaced.", "mean_step", [](auto& t) {
    if (t.size() > 1) t = VectorXd::LinSpaced(t.size(), t[0], t[t.size() - 1]).eval();
  });
  e.wrong_input<0>("All of your steps are as long as the first one; the times are not evenly spaced.", "first_step",
                   [](auto& t) {
                     for (Eigen::Index k = 2; k < t.size(); ++k) t[k] = t[k - 1] + (t[1] - t[0]);
                   });
  e.wrong_input<1>("Your rotations run backwards.", "backwards", negated);
  e.wrong("Your angles are twice too large: the sum of two rates stands where their mean belongs.", "sum_of_rates",
          [](auto& t, auto& omega) {
            return stepped(t, omega, [](auto& A, auto& angle, auto) { return A * rotation_by(2 * angle); });
          });
  e.property(Is::rotation_matrix,
             "An attitude is a rotation matrix: its columns are unit vectors at right angles, a right-handed triad.");
  e.route("quaternions", [](auto& t, auto& omega) {
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    stepped(t, omega, [&](auto& A, auto& angle, auto) {
      q = q * Eigen::Quaterniond(Eigen::AngleAxisd(angle.norm(), angle.stableNormalized()));
      return A;
    });
    return q.normalized().toRotationMatrix();
  });
  e.route("the exponential series", [](auto& t, auto& omega) {
    return stepped(t, omega, [](auto& A, auto& angle, auto) { return A * by_series(angle); });
  });
  e.route("from the last step to the first", [](auto& t, auto& omega) {
    Matrix3d A = Matrix3d::Identity();
    for (Eigen::Index k = t.size() - 1; k > 0; --k) {
      const Vector3d mean = (omega.col(k - 1) + omega.col(k)) / 2.0;
      A = rotation_by((t[k] - t[k - 1]) * mean) * A;
    }
    return A;
  });
  e.survivor("0.5 * 1", "The index is cut to the same whole number.");
}
