#include "solutions/05_euler_equations/shared.hpp"

#include <numeric>

/// A quantity followed by the classical Runge-Kutta method, one column per time.
template <class State, class RateOf>
static auto follow(const State& start, const VectorXd& times, const RateOf& rate) {
  Eigen::Matrix<double, State::RowsAtCompileTime, -1> states(start.size(), times.size());
  for (int k = 0; k < times.size(); ++k)
    states.col(k) = followed(start, times[k], 1 + static_cast<int>(abs(times[k]) / 0.01), rate);
  return states;
}

/// One step of the explicit Euler method from each given time to the next, the first one from time 0.
static Matrix3Xd euler_steps(const Vector3d& I, Vector3d omega, const VectorXd& times) {
  Matrix3Xd columns(3, times.size());
  for (int k = 0; k < times.size(); ++k) {
    omega += (times[k] - (k > 0 ? times[k - 1] : 0)) * euler_equations(I, omega, zero);
    columns.col(k) = omega;
  }
  return columns;
}

/// Four times in no order, of both signs, none of them a whole number, neighbours and zero kept apart.
static auto scattered(double longest) {
  return [longest](Random& random) {
    VectorXd moments(4);
    for (int k = 0; k < 4; ++k) {
      const double share = (k + random.uniform(0.3, 0.7)) / 4;
      moments[k] = longest * share * (k % 2 == 0 ? 1 : -1);
    }
    for (int k = 3; k > 0; --k) swap(moments[k], moments[random.whole(0, k)]);
    return moments;
  };
}

static void sort(VectorXd& numbers) { std::sort(numbers.begin(), numbers.end()); }

static void add_cases(auto& e) {
  // The expected numbers are exact: elliptic functions, no integration.
  e.judge_by(exact_free_rotation);
  // Right integrators take steps of their own choice; what turns fast or for long is beyond some of them.
  e.generated([](auto& I, auto& start, auto& times) {
    const double longest = times.size() > 0 ? times.cwiseAbs().maxCoeff() : 0;
    return I.maxCoeff() < 10 * I.minCoeff() && start.norm() < 3 && longest < 100 && start.norm() * longest < 40;
  });
  const Vector3d omega0(0.1, 1, 0.1);
  e.worked("moments 1, 2, 3 after 20 s", example_moments, omega0, VectorXd{{20}});
  e.worked("moments 1, 2, 3, a faster start", example_moments, {1, 0.5, 0.25}, VectorXd{{5, 10, 20}});
  // A number of steps that does not grow with the time is too small here; steps of a fixed length are not.
  e.special("a minute", example_moments, {1, 0.5, 0.25}, VectorXd{{60}});
  e.special("no times", example_moments, omega0, VectorXd(0));
  e.special("time 0", example_moments, omega0, VectorXd{{0}});
  e.special("only the past", example_moments, omega0, VectorXd{{-3, -8}});
  e.special("the same time twice", example_moments, omega0, VectorXd{{4, 4, -1, 4}});
  e.special("a sphere", {2, 2, 2}, example_omega, VectorXd{{-5, 1, 10}});
  e.special("a symmetric body", {1, 1, 1.8}, {0.4, 0, 2}, VectorXd{{0.7, 3, -2}});
  e.special("a symmetric body, its axis first", {0.6, 1, 1}, {1.5, -0.3, 0.8}, VectorXd{{6, -6}});
  e.special("rotation about the middle axis", example_moments, {0, 1, 0}, VectorXd{{2, 9}});
  e.special("no rotation", example_moments, zero, VectorXd{{1, 2}});
  e.special("almost about the middle axis", example_moments, {0, 1, 0.01}, VectorXd{{10, 14, 20}});
  e.special("on the separatrix", {3, 5, 6}, {0.5, 0.25, 0.5}, VectorXd{{-4, 4, 8}});
  e.special("two moments nearly equal", {1, 1 + 1e-7, 1.5}, {0.3, 0.5, 0.8}, VectorXd{{3, 12}});
  e.random("times in no order", 6, &Random::principal_moments, any::vector(1.5), scattered(4));
  e.random("a longer run", 3, &Random::principal_moments, any::vector(0.8), [](Random& random) {
    VectorXd moments = scattered(14)(random).cwiseAbs();
    sort(moments);
    return moments;
  });
  e.tolerance(1e-6,
              "The answer is integrated in steps: a method of fourth order with steps of some hundredths of a second "
              "stays within a millionth of the exact solution by elliptic functions.");
  // Of this the error of a thousand or two steps, whatever the time, is fifty or three times too large.
  e.special("two hundred seconds", example_moments, {0.5, 0.3, 0.8}, VectorXd{{200}});
  e.tolerance_of_last_case(
      1e-5, "After two hundred seconds a controlled integration with the tolerance 1e-8 is off by a few millionths.");
  e.random("one long time", 2, &Random::principal_moments, any::vector(1),
           [](Random& random) { return VectorXd{{random.uniform(20, 24)}}; });
  e.tolerance_of_last_case(1e-6);
  e.scale([](auto&, auto& start, auto&) { return max(start.norm(), 1e-3); });
  e.template sweep<2>({"Free rotation with moments 1, 2, 3 kg m² from ω = (0.1, 1, 0.1) rad/s", "time (s)",
                       "body component of ω (rad/s)"},
                      {"ω_1", "ω_2", "ω_3"}, {-5, 25, 91}, [](auto t) { return VectorXd{{t}}; });
}

static void add_routes_of_free_rotation(auto& e) {
  e.route("a controlled integration of high order", free_rotation);
  e.route("the classical Runge-Kutta method", [](auto& I, auto& start, auto& moments) {
    return follow(start, moments, [&](const Vector3d& w) { return euler_equations(I, w, zero); });
  });
  e.route("L in the body, then divided", [](auto& I, auto& start, auto& moments) -> Matrix3Xd {
    const Matrix3Xd L =
        follow(L_of(I, start), moments, [&](const Vector3d& M) { return cross(M, M.cwiseQuotient(I)); });
    return I.cwiseInverse().asDiagonal() * L;
  });
  e.route("the attitude, with L at rest in space", [](auto& I, auto& start, auto& moments) {
    // A quaternion follows the body; ω is read off the constant L on the body's axes.
    const Vector3d L = L_of(I, start);
    const auto omega_at = [&](const Eigen::Vector4d& q) -> Vector3d {
      return (Eigen::Quaterniond(q).normalized().conjugate() * L).cwiseQuotient(I);
    };
    Matrix3Xd omega(3, moments.size());
    const auto attitudes =
        follow(Eigen::Vector4d(0, 0, 0, 1), moments, [&](const Eigen::Vector4d& q) -> Eigen::Vector4d {
          const Vector3d half = omega_at(q) / 2;
          return (Eigen::Quaterniond(q) * Eigen::Quaterniond(0, half[0], half[1], half[2])).coeffs();
        });
    for (int k = 0; k < moments.size(); ++k) omega.col(k) = omega_at(attitudes.col(k));
    return omega;
  });
  e.survivor("from == to", "An integration over no time changes nothing.");
  e.survivor("make_controlled(", "Tolerances nearby reach the accuracy that is asked for.");
  e.survivor("first_step = ", "The stepper corrects its first step.");
  e.survivor("std::abs(times[", "The order of the times saves work only.");
  e.survivor("std::sort(outwards", "The order of the times saves work only.");
  e.survivor("future) continue", "The order of the times saves work only.");
  e.survivor("double size = ", "ω and time are scaled by it in opposite ways.");
  e.survivor("-size == 0", "Zero has no sign.");
  e.survivor("advance( -I", "Only ratios of moments enter.");
}

void judge_free_rotation(Lecture& lecture) {
  auto& e = lecture.exercise(&free_rotation, {{"I", positive(kg_m2)}, {"omega0", rad_per_s}, {"times", second}},
                             {"omega", rad_per_s});
  add_cases(e);
  e.wrong("Each column is one Euler step on from the last; between the times many small steps are needed.",
          "given_times_as_steps", euler_steps);
  e.wrong_input<2>(
      "A time before 0, or before one that stands to the left of it, gives the last state here; times come "
      "in any order.",
      "running_forwards", [](auto& times) {
        for (int k = 0; k < times.size(); ++k) times[k] = max(times[k], k > 0 ? times[k - 1] : 0.0);
      });
  e.wrong("Each column is one Euler step from t = 0; up to each time many small steps are needed.", "one_step_each",
          [](auto& I, auto& start, auto& moments) -> Matrix3Xd {
            return start.replicate(1, moments.size()) + euler_equations(I, start, zero) * moments.transpose();
          });
  e.wrong_input<2>(
      {"The motion runs backwards, as when ω × (Iω) has the wrong sign in I dω/dt = −ω × (Iω).", rate_notes},
      "sign_of_gyration", negated);
  e.wrong_input<2>("Every column repeats omega0: without a torque L is constant, but ω is not.", "no_motion",
                   [](auto& moments) { moments.setZero(); });
  e.wrong_input<2>("The times count here as steps of 0.01 s; they are in seconds.", "times_count_steps", times(0.01));
  e.wrong_input<2>("The times are cut to whole numbers here; they are moments in seconds, fractions included.",
                   "whole_seconds",
                   [](auto& moments) { moments = moments.template cast<int>().template cast<double>().eval(); });
  e.wrong_input<2>("Your column k holds ω at k seconds; it should hold ω at times[k].", "column_numbers",
                   [](auto& moments) { std::iota(moments.begin(), moments.end(), 0); });
  e.wrong_input<2>("Your columns follow the times in ascending order, not in the order given.", "sorted", sort);
  e.wrong_input<2>("Negative times run forwards here; at t = −3 s the body was where it came from.", "no_past",
                   [](auto& moments) { moments = moments.cwiseAbs().eval(); });
  e.wrong_input<2>("At negative times this is omega0; the integration runs into the past as well, with negative steps.",
                   "past_not_run", [](auto& moments) { moments = moments.cwiseMax(0).eval(); });
  e.wrong_input<2>("omega0 belongs to the first of the times here; it belongs to t = 0.", "starts_at_first_time",
                   [](auto& moments) { moments.array() -= moments.size() > 0 ? double(moments[0]) : 0; });
  e.wrong_input<2>("Each column runs on from the last by all of times[k]; only the difference is left to run.",
                   "each_from_the_last",
                   [](auto& moments) { std::partial_sum(moments.begin(), moments.end(), moments.begin()); });
  e.wrong({"Your rate is −ω × (Iω) without the division by the moments: that is I dω/dt, not dω/dt.",
           "euler_equations_principal"},
          "not_divided", [](auto& I, auto& start, auto& moments) {
            return follow(start, moments, [&](const Vector3d& w) { return -cross(w, L_of(I, w)); });
          });
  e.wrong({indices_shifted, "euler_equations_principal"}, "indices_shifted", [](auto& I, auto& start, auto& moments) {
    return follow(start, moments, [&](const Vector3d& w) -> Vector3d {
      return -L_of(shifted(differences(I)), products(w)).cwiseQuotient(I);
    });
  });
  e.wrong_output("Your columns hold L = Iω; asked for is ω.", "momentum_returned",
                 [](auto& omega, auto& I, auto&...) { omega.array().colwise() *= I.array(); });
  const char* const invariants = "euler_equations_invariants";
  e.conserves({"In free rotation the kinetic energy keeps its value from t = 0: Σ Iᵢωᵢ² stays the same.", invariants},
              [](auto& I, auto&, auto&) { return I; });
  e.conserves({"In free rotation L keeps its length from t = 0: Σ Iᵢ²ωᵢ² stays the same.", invariants},
              [](auto& I, auto&, auto&) { return Vector3d(I.cwiseAbs2()); });
  add_routes_of_free_rotation(e);
}
