#include "solutions/11_measured/shared.hpp"

namespace {

/// The length of the simple pendulum with this period.
double length_of(double g, double P) { return g * P * P / (4 * pi * pi); }
double moment(double M, double g, double d, double P) { return M * d * (length_of(g, P) - d); }

/// What the errors of d and of P contribute to that of the moment.
Vector2d contributions(double M, double g, double d, double P, double d_error, double P_error) {
  return {M * (length_of(g, P) - 2 * d) * d_error, 2 * M * d * length_of(g, P) / P * P_error};
}

/// The right moment with another error.
template <class Error>
auto with_error(const Error& error) {
  return [error](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
    return Vector2d(moment(M, g, d, P), error(M, g, d, P, d_error, P_error));
  };
}

/// The wrong answers that are known.
template <class Exercise>
void mistakes_of_moment_from_pendulum(Exercise& e) {
  e.wrong("This is the moment about the axis on which the body hangs; asked for is that about the centre of mass.",
          "about_the_end", [](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
            const double about_end = M * d * length_of(g, P);
            return Vector2d(about_end, about_end * hypot(d_error / d, 2 * P_error / P));
          });
  e.wrong("The part of the parallel axis is added; from the axis to the centre of mass it is subtracted.", "added",
          [](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
            const double of_d = M * (length_of(g, P) + 2 * d) * d_error;
            return Vector2d(M * d * (length_of(g, P) + d), hypot(of_d, contributions(M, g, d, P, d_error, P_error)[1]));
          });
  e.wrong(
      "The error of the distance enters twice here, as if the two parts of the moment were measured independently; it "
      "is the same distance in both.",
      "independent_parts", with_error([](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
        const double about_end = M * d * length_of(g, P);
        const double of_end = about_end * hypot(d_error / d, 2 * P_error / P), of_parallel = 2 * M * d * d_error;
        return hypot(of_end, of_parallel);
      }));
  e.wrong(
      "The relative error of the distance is added to that of the period squared, as if the moment were a product "
      "of the two; it is a difference of two terms, and the distance stands in both.",
      "relative_errors", with_error([](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
        return abs(moment(M, g, d, P)) * hypot(d_error / d, 2 * P_error / P);
      }));
  e.wrong("The two contributions to your error are added; independent ones add as squares.", "linear",
          with_error([](auto M, auto g, auto d, auto P, auto d_error, auto P_error) -> double {
            return contributions(M, g, d, P, d_error, P_error).cwiseAbs().sum();
          }));
  e.wrong("The error of the period counts once here; the period enters by its square.", "period_once",
          with_error([](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
            const Vector2d both = contributions(M, g, d, P, d_error, P_error);
            return hypot(both[0], both[1] / 2);
          }));
  e.wrong("The error of the distance is missing in yours.", "period_alone",
          with_error([](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
            return abs(contributions(M, g, d, P, d_error, P_error)[1]);
          }));
  e.wrong("The error of the period is missing in yours.", "distance_alone",
          with_error([](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
            return abs(contributions(M, g, d, P, d_error, P_error)[0]);
          }));
  e.wrong_inputs("The period counts here as that of half a swing; it is a full one, to and fro.", "half_swing",
                 [](auto&, auto&, auto&, auto& P, auto&, auto& P_error) {
                   P *= 2;
                   P_error *= 2;
                 });
  e.wrong_output("Your error is a square: the root is missing.", "no_root", [](auto& both) { both[1] *= both[1]; });
}

}  // namespace

void judge_moment_from_pendulum(Lecture& lecture) {
  auto& e = lecture.exercise(&moment_from_pendulum,
                             {{"M", positive(kg)},
                              {"g", positive(m_per_s2)},
                              {"d", positive(metre)},
                              {"P", positive(second)},
                              {"d_error", not_negative(metre)},
                              {"P_error", not_negative(second)}},
                             {"moment_and_error", kg_m2});
  e.domain([](auto, auto g, auto d, auto P, auto, auto) { return length_of(g, P) >= d * (1 - 1e-12); });
  e.worked("a racket", 0.457, 9.81, 0.413, 1.436, 0.005, 0.039);
  e.worked("a rod of 1 m", 2, 10, 0.5, 1.64, 0.01, 0.01);
  e.measured("the racket that swings about its end in its own plane", {}, 0.45728, 9.809, 0.413, 1.450, 0.005, 0.023);
  e.special("no errors", 0.457, 9.81, 0.413, 1.436, 0, 0);
  e.special("the distance alone has an error", 0.457, 9.81, 0.413, 1.436, 0.005, 0);
  e.special("the period alone has an error", 0.457, 9.81, 0.413, 1.436, 0, 0.039);
  e.special("a point mass", 2, 4 * pi * pi, 0.25, 0.5, 0.01, 0.01);
  e.special("the distance is half of the pendulum's length", 2, 4 * pi * pi, 0.5, 1, 0.01, 0.01);
  e.limit("a point mass", {0, sqrt(2) * 0.005},
          "All of the moment about the axis is Md²: nothing is left but the two errors.");
  e.limit("the distance is half of the pendulum's length", {0.5, 0.02},
          "The result is largest here as a function of d, so the error of d does not count to first order.");
  e.random("some body", 10, [](Random& random) {
    const double g = random.uniform(8, 11), d = random.uniform(0.2, 1.5), share = random.uniform(1.2, 1.7);
    const double P = 2 * pi * sqrt(d * share / g);
    const double M = random.uniform(0.3, 3), d_error = d * random.uniform(0.01, 0.03);
    return tuple(M, g, d, P, d_error, P * random.uniform(0.004, 0.01));
  });
  e.scale([](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
    const double size = M * d * length_of(g, P);
    const double spread = M * (length_of(g, P) + 2 * d) * d_error + 2 * size / P * P_error;
    return Vector2d(size, spread > 0 ? spread : size);
  });
  e.sweep<2>({"0.457 kg that swing with P = 1.436 ± 0.039 s: the nearer the axis, the smaller the error",
              "distance of the axis from the centre of mass (m)", "moment, its error (kg m²)"},
             {"moment", "error"}, {0.02, 0.51});
  mistakes_of_moment_from_pendulum(e);
  e.property(Is::nonnegative, "No moment of inertia is negative, and no error.");
  e.route("two parts, and the derivative of both", [](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
    const double restoring = M * g * d, about_end = restoring * P * P / (4 * pi * pi);
    const double of_d = about_end / d - 2 * M * d, of_T = 2 * about_end / P;
    return Vector2d(about_end - M * d * d, sqrt(of_d * of_d * d_error * d_error + of_T * of_T * P_error * P_error));
  });
  e.route("from the rate of the swing", [](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
    const double rate = 2 * pi / P, length = g / (rate * rate), rate_error = rate * P_error / P;
    return Vector2d(M * d * length - M * d * d,
                    M * hypot((length - 2 * d) * d_error, 2 * d * length / rate * rate_error));
  });
  e.route("differences, exact for squares", [](auto M, auto g, auto d, auto P, auto d_error, auto P_error) {
    // The moment is quadratic in d and in P, so that a central difference is its derivative.
    const double by_d = (moment(M, g, 1.5 * d, P) - moment(M, g, 0.5 * d, P)) / d;
    const double by_T = (moment(M, g, d, 1.5 * P) - moment(M, g, d, 0.5 * P)) / P;
    return Vector2d(moment(M, g, d, P), Vector2d(by_d * d_error, by_T * P_error).norm());
  });
  e.survivor("pi = -", "It enters squared.");
  e.survivor("from_distance = -", "It enters squared.");
  e.survivor("from_period = -", "It enters squared.");
  e.survivor("-from_distance", "It enters squared.");
  e.survivor("- from_period", "It enters squared.");
}
