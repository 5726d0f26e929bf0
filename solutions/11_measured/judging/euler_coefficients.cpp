#include "solutions/11_measured/shared.hpp"

namespace {

VectorXd product(const Matrix3Xd& omega, int first, int other) {
  return omega.row(first % 3).cwiseProduct(omega.row(other % 3)).transpose();
}

/// The running sum of a rate; in each step the earlier value counts with this weight, the later one with the rest.
VectorXd running_sum(const VectorXd& t, const VectorXd& rate, double weight_of_earlier = 0.5) {
  VectorXd sum = VectorXd::Zero(t.size());
  for (Eigen::Index k = 1; k < t.size(); ++k)
    sum[k] = sum[k - 1] + (t[k] - t[k - 1]) * (weight_of_earlier * rate[k - 1] + (1 - weight_of_earlier) * rate[k]);
  return sum;
}

VectorXd centred(const VectorXd& x) { return x.array() - x.mean(); }
double slope(const VectorXd& x, const VectorXd& y) { return centred(x).dot(centred(y)) / centred(x).squaredNorm(); }

/// One number per axis, from the sum of the axis and its component of ω.
template <class Fit>
Vector3d for_each_axis(const VectorXd& t, const Matrix3Xd& omega, const Fit& fit, double weight_of_earlier = 0.5) {
  Vector3d found;
  for (int axis = 0; axis < 3; ++axis) {
    const VectorXd sum = running_sum(t, product(omega, axis + 1, axis + 2), weight_of_earlier);
    const VectorXd rates = omega.row(axis).transpose();
    found[axis] = fit(sum, rates);
  }
  return found;
}

/// The least spread of a sum beside the sizes of its steps.
double least_spread(const VectorXd& t, const Matrix3Xd& omega) {
  double least = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const VectorXd rate = product(omega, axis + 1, axis + 2);
    const double all = running_sum(t, rate.cwiseAbs())[t.size() - 1];
    least = min(least, all > 0 ? centred(running_sum(t, rate)).cwiseAbs().maxCoeff() / all : 0.0);
  }
  return least;
}

}  // namespace

void judge_euler_coefficients(Lecture& lecture) {
  auto& e = lecture.exercise(&euler_coefficients, {{"t", second}, {"omega", rad_per_s}}, {"coefficients", none});
  const auto spread = [](double least) {
    return [least](auto& t, auto& omega) {
      return t.size() >= 3 && omega.cols() == t.size() && ascends(t) && least_spread(t, omega) > least;
    };
  };
  e.domain(spread(1e-9));
  e.generated(spread(1e-3));
  e.worked("a thrown racket", racket_times, racket_rates);
  e.special("three samples", VectorXd{{0, 0.1, 0.3}}, Matrix3Xd{{1, 2, 1}, {-1, 1, 2}, {3, 1, 2}});
  e.special("one component stays", VectorXd{{-1, 0, 1, 3}}, Matrix3Xd{{2, 2, 2, 2}, {1, 2, 3, 1}, {-1, 1, 1, 2}});
  e.random("a flight with noise", 10, noisy_flight(8, 12));
  const Vector3d errors = errors_of_throw_3();
  e.measured("throw 3 of the racket (errors: the noise of the gyroscope)", {errors.begin(), errors.end()}, throw_3.t,
             throw_3.omega);
  e.scale([](auto& t, auto& omega) {
    return for_each_axis(t, omega, [](const VectorXd& sum, const VectorXd& rates) {
      return or_one(rates.norm()) / centred(sum).norm();
    });
  });
  e.sweep({"A thrown racket, ω_x of whose first sample is wrong", "error of the first ω_x (rad/s)", "coefficient"},
          {"a", "b", "c"}, {-5, 5}, [](auto error) {
            Matrix3Xd omega = racket_rates;
            omega(0, 0) += error;
            return tuple(racket_times, omega);
          });

  e.wrong("Your lines pass through the origin; the intercept is free.", "through_the_origin", [](auto& t, auto& omega) {
    return for_each_axis(t, omega, [](auto& x, auto& y) { return x.dot(y) / x.squaredNorm(); });
  });
  e.wrong("Your lines pass through the first sample, as if it had no error; the intercept is free.",
          "through_the_first", [](auto& t, auto& omega) {
            return for_each_axis(t, omega,
                                 [](auto& x, auto& y) { return (x.dot(y) - y[0] * x.sum()) / x.squaredNorm(); });
          });
  e.wrong("Each step of your sums takes the earlier value alone; the trapezoidal rule takes the mean of both ends.",
          "earlier_value", [](auto& t, auto& omega) { return for_each_axis(t, omega, slope, 1); });
  e.wrong("Each step of your sums takes the later value alone; the trapezoidal rule takes the mean of both ends.",
          "later_value", [](auto& t, auto& omega) { return for_each_axis(t, omega, slope, 0); });
  e.wrong("Each step of your sums takes the product of two means; the trapezoidal rule takes the mean of two products.",
          "product_of_means", [](auto& t, auto& omega) {
            const Matrix3Xd means = (omega.leftCols(omega.cols() - 1) + omega.rightCols(omega.cols() - 1)) / 2;
            Vector3d found;
            for (int axis = 0; axis < 3; ++axis) {
              VectorXd rate(t.size());  // which the later end of each step has
              rate << 0, product(means, axis + 1, axis + 2);
              found[axis] = slope(running_sum(t, rate, 0), VectorXd(omega.row(axis).transpose()));
            }
            return found;
          });
  e.wrong_input<0>("All steps count as equally long here; t tells how long each is.", "equal_steps", [](auto& t) {
    if (t.size() > 1) t = VectorXd::LinSpaced(t.size(), t[0], t[t.size() - 1]).eval();
  });
  e.wrong("The sums come without the lengths of their steps: these are seconds.", "no_time", [](auto& t, auto& omega) {
    return for_each_axis(VectorXd::LinSpaced(t.size(), 0, static_cast<double>(t.size() - 1)), omega, slope);
  });
  e.wrong("These are slopes of the sums over ω; asked for are those of ω over the sums.", "axes_exchanged",
          [](auto& t, auto& omega) { return for_each_axis(t, omega, [](auto& x, auto& y) { return slope(y, x); }); });
  e.wrong("The slope is that of the line with the least deviations in the sums; the deviations in ω count.",
          "deviations_of_the_sum", [](auto& t, auto& omega) {
            return for_each_axis(
                t, omega, [](auto& x, auto& y) { return centred(y).squaredNorm() / centred(x).dot(centred(y)); });
          });
  e.wrong("Your lines join the first sample to the last; all samples between them count too.", "ends_alone",
          [](auto& t, auto& omega) {
            return for_each_axis(t, omega, [](auto& x, auto& y) {
              const Eigen::Index last = x.size() - 1;
              return (y[last] - y[0]) / (x[last] - x[0]);
            });
          });
  e.wrong("The product in your sums holds the component itself and the next one; it holds the two others.",
          "neighbouring_product", [](auto& t, auto& omega) {
            Vector3d found;
            for (int axis = 0; axis < 3; ++axis)
              found[axis] =
                  slope(running_sum(t, product(omega, axis, axis + 1)), VectorXd(omega.row(axis).transpose()));
            return found;
          });
  e.route("pairs of samples", [](auto& t, auto& omega) {
    return for_each_axis(t, omega, [](auto& x, auto& y) {
      double above = 0, below = 0;
      for (Eigen::Index j = 0; j < x.size(); ++j) {
        for (Eigen::Index k = 0; k < j; ++k) {
          above += (x[j] - x[k]) * (y[j] - y[k]);
          below += (x[j] - x[k]) * (x[j] - x[k]);
        }
      }
      return above / below;
    });
  });
  e.route("projected on what of the sums is orthogonal to a constant", [](auto& t, auto& omega) {
    return for_each_axis(t, omega, [](auto& x, auto& y) {
      const VectorXd across = centred(x);
      return across.dot(y) / across.dot(x);
    });
  });
  e.route("sums alone", [](auto& t, auto& omega) {
    return for_each_axis(t, omega, [](auto& x, auto& y) {
      const auto n = static_cast<double>(x.size());
      return (n * x.dot(y) - x.sum() * y.sum()) / (n * x.squaredNorm() - x.sum() * x.sum());
    });
  });
  const char* const tiny =
      "No gyroscope gives such small numbers, and a fit by orthogonal matrices takes their sums for zero.";
  e.survivor("below 1e-09 taken for zero", tiny);
  e.survivor("below 1e-06 taken for zero", tiny);
  e.survivor("(axis + 4)", "The remainder is the same.");
  e.survivor("(axis + 8)", "The remainder is the same.");
  e.survivor("% -3", "The remainder is the same.");
  e.survivor("without the transpose", "Eigen makes a column of a row here.");
  e.survivor("0.5 * 1", "The index is cut to the same whole number.");
}
