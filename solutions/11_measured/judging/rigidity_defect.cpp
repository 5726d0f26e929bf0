#include "solutions/11_measured/shared.hpp"

static double defect(const Vector3d& k) { return k.sum() + k.prod(); }
/// How D changes with each of the coefficients.
static Vector3d derivatives(const Vector3d& k) { return {1 + k[1] * k[2], 1 + k[2] * k[0], 1 + k[0] * k[1]}; }

void judge_rigidity_defect(Lecture& lecture) {
  auto& e = lecture.exercise(&rigidity_defect, {{"coefficients", none}, {"errors", not_negative(none)}},
                             {"defect_and_error", none});
  e.worked("a racket", {-0.992, 0.971, 0.852}, {0.003, 0.009, 0.004});
  e.worked("a brick", {-1.0 / 2, 2.0 / 3, -1.0 / 4}, {0.02, 0.01, 0.03});
  e.special("no errors", {-0.99, 0.97, 0.85}, zero);
  e.special("a sphere", zero, {0.01, 0.02, 0.03});
  e.special("a flat body", {-1, 1, 0.5}, {0.01, 0.02, 0.03});
  e.random("measured coefficients", 10, any::vector(0.9), [](Random& random) {
    return Vector3d(random.uniform(0.01, 0.05), random.uniform(0.01, 0.05), random.uniform(0.01, 0.05));
  });
  e.measured("the coefficients of throw 3", {}, euler_coefficients(throw_3.t, throw_3.omega), errors_of_throw_3());
  e.scale([](auto& k, auto& errors) {
    const double size = 1 + k.cwiseAbs().sum() + abs(k.prod());  // the coefficients stand beside ones
    const double spread = errors.dot(Vector3d(1 + abs(k[1] * k[2]), 1 + abs(k[2] * k[0]), 1 + abs(k[0] * k[1])));
    return Vector2d(size, or_one(spread));
  });
  e.sweep({"b = 0.971 ± 0.009, c = 0.852 ± 0.004, a measured to 0.003", "a", "defect, its error"}, {"defect", "error"},
          {-1.2, -0.8}, [](auto a) { return tuple(Vector3d(a, 0.971, 0.852), Vector3d(0.003, 0.009, 0.004)); });

  const auto with_error = [](auto error) {
    return [error](auto& k, auto& errors) { return Vector2d(defect(k), error(k, errors)); };
  };
  e.wrong("The product abc enters with a minus; D holds a plus.", "product_subtracted", [](auto& k, auto& errors) {
    const Vector3d slopes = 2 * Vector3d::Ones() - derivatives(k);
    return Vector2d(k.sum() - k.prod(), slopes.cwiseProduct(errors).norm());
  });
  e.wrong("The product abc is missing; the sum of the coefficients alone does not vanish.", "sum_alone",
          [](auto& k, auto& errors) { return Vector2d(k.sum(), errors.norm()); });
  e.wrong("Your error is that of a + b + c; the product abc has an error too.", "error_of_the_sum",
          with_error([](auto&, auto& errors) -> double { return errors.norm(); }));
  e.wrong("The contributions to your error are added; independent errors add as squares.", "added",
          with_error([](auto& k, auto& errors) -> double { return derivatives(k).cwiseAbs().dot(errors); }));
  e.wrong("The derivatives stand in your error as they are; each is squared with the error that it belongs to.",
          "derivatives_not_squared", with_error([](auto& k, auto& errors) -> double {
            return sqrt(derivatives(k).cwiseAbs().dot(errors.cwiseAbs2()));
          }));
  e.wrong("Your error is a square: the root is missing.", "no_root", with_error([](auto& k, auto& errors) -> double {
            return derivatives(k).cwiseProduct(errors).squaredNorm();
          }));
  e.wrong("Your error adds the squares of four summands, as if that of abc were independent of those of a, b and c.",
          "four_summands", with_error([](auto& k, auto& errors) -> double {
            const Vector3d others(k[1] * k[2], k[2] * k[0], k[0] * k[1]);
            return sqrt(errors.squaredNorm() + others.cwiseProduct(errors).squaredNorm());
          }));
  e.route("a determinant, and differences", [](auto& k, auto& errors) {
    const auto determinant = [](const Vector3d& x) {
      return Matrix3d{{x[0], -1, 1}, {1, x[1], -1}, {-1, 1, x[2]}}.determinant();
    };
    double squares = 0;
    for (int i = 0; i < 3; ++i) {  // D is linear in each coefficient: any step gives the derivative
      const double change = (determinant(k + Vector3d::Unit(i)) - determinant(k - Vector3d::Unit(i))) / 2;
      squares += change * change * errors[i] * errors[i];
    }
    return Vector2d(determinant(k), sqrt(squares));
  });
  e.route("two factors", [](auto& k, auto& errors) {
    const double bc = k[1] * k[2], ca = k[2] * k[0], ab = k[0] * k[1];
    return Vector2d(k[0] * (1 + bc) + k[1] + k[2],
                    hypot((1 + bc) * errors[0], (1 + ca) * errors[1], (1 + ab) * errors[2]));
  });
  e.route("a covariance matrix", [](auto& k, auto& errors) {
    const Vector3d slopes = derivatives(k);
    const Matrix3d covariance = errors.cwiseAbs2().asDiagonal();
    return Vector2d(k[0] + (k[1] + (k[2] + k[0] * k[1] * k[2])), sqrt(slopes.dot(Vector3d(covariance * slopes))));
  });
  e.survivor("-errors", "Only the length of the product enters.");
}
