#include "solutions/11_measured/shared.hpp"

static double sum_of_squares(const VectorXd& x) { return (x.array() - x.mean()).square().sum(); }

void judge_mean_and_error(Lecture& lecture) {
  auto& e = lecture.exercise(&mean_and_error, {{"values", none}}, {"mean_and_error", none});
  e.domain([](auto& x) { return x.size() >= 2; });
  e.worked("a coefficient of twelve throws", VectorXd{{-0.9912, -0.9946, -0.9983, -1.0005, -0.9967, -0.9910, -0.9937,
                                                       -0.9938, -0.9938, -0.9921, -0.9942, -0.9631}});
  VectorXd a(11);
  for (int k = 0; k < 11; ++k) {
    const measured::Flight& flight = throws.at(static_cast<std::size_t>(k));
    a[k] = euler_coefficients(flight.t, flight.omega)[0];
  }
  e.measured("the coefficient a of throws 1 to 11", {}, a);
  e.worked("two values", VectorXd{{1, 3}});
  e.special("equal values", VectorXd{{2, 2, 2}});
  e.special("about zero", VectorXd{{-1, 1, -2, 2}});
  e.random("some values", 10, [](Random& random) {
    VectorXd values(random.whole(3, 9));
    const double centre = random.sign() * random.uniform(0.3, 2);
    for (double& value : values) value = centre + random.uniform(-1, 1);
    return values;
  });
  e.scale([](auto& x) {
    const double size = or_one(x.cwiseAbs().maxCoeff()), spread = x.maxCoeff() - x.minCoeff();
    return Vector2d(size, spread > 1e-6 * size ? spread : size);
  });
  e.sweep({"The values 1, 2, 3 and a fourth one", "fourth value", "mean, standard error"}, {"mean", "error"}, {0, 8},
          [](auto fourth) {
            return VectorXd{{1, 2, 3, fourth}};
          });

  const auto with_error = [](auto error) {
    return [error](auto& x) { return Vector2d(x.mean(), error(x, static_cast<double>(x.size()))); };
  };
  e.wrong("Your error is the scatter of one measurement; that of the mean is smaller by the root of their number.",
          "of_one", with_error([](auto& x, auto n) { return sqrt(sum_of_squares(x) / (n - 1)); }));
  e.wrong("n stands where n − 1 belongs: the mean comes from the same values.", "n_squared",
          with_error([](auto& x, auto n) { return sqrt(sum_of_squares(x)) / n; }));
  e.wrong("This is the root of the mean square deviation, with n below the sum; divide by n (n − 1).", "population",
          with_error([](auto& x, auto n) { return sqrt(sum_of_squares(x) / n); }));
  e.wrong("Your error is a square: the root is missing.", "no_root",
          with_error([](auto& x, auto n) { return sum_of_squares(x) / (n * (n - 1)); }));
  e.wrong("Your error is half of the whole range of the values.", "half_range",
          with_error([](auto& x, auto) { return (x.maxCoeff() - x.minCoeff()) / 2; }));
  e.wrong("The squares in your error are those of the values, without the mean subtracted.", "about_zero",
          with_error([](auto& x, auto n) { return sqrt(x.squaredNorm() / (n * (n - 1))); }));
  e.route("pairs of values", with_error([](auto& x, auto n) {
            double sum = 0;
            for (Eigen::Index i = 0; i < x.size(); ++i)
              for (Eigen::Index k = 0; k < i; ++k) sum += (x[i] - x[k]) * (x[i] - x[k]);
            return sqrt(sum / (n - 1)) / n;
          }));
  e.route("one value after the other", [](auto& x) {
    double mean = 0, squares = 0;
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const double off = x[k] - mean;
      mean += off / static_cast<double>(k + 1);
      squares += off * (x[k] - mean);
    }
    const auto n = static_cast<double>(x.size());
    return Vector2d(mean, sqrt(squares / (n - 1) / n));
  });
  e.route("squares about the first value", [](auto& x) {
    const auto n = static_cast<double>(x.size());
    const VectorXd off = x.array() - x[0];
    const double excess = max(off.squaredNorm() - off.sum() * off.sum() / n, 0.0);
    return Vector2d(x[0] + off.sum() / n, sqrt(excess / (n * (n - 1))));
  });
}
