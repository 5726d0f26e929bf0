#include "solutions/09_heavy_top/shared.hpp"

namespace {

Vector3d turning_axes(const Vector3d& q, const Vector3d& v) { return derivative_along(q, v, rate_axes<Complex>) * v; }

Vector3d torque_on_body(double mgl, const Vector3d& q) { return mgl * cross(attitude(q).transpose() * z_axis, z_axis); }

/// B⁻¹ (ω̇ − Ḃ q̇) with the torque in body components.
Vector3d under_torque(const Vector3d& I, const Vector3d& torque, const Vector3d& q, const Vector3d& v) {
  const Vector3d omega_rate = (torque + cross(L_body(I, q, v), omega_body(q, v))).cwiseQuotient(I);
  return rate_axes(q).inverse() * (omega_rate - turning_axes(q, v));
}

/// What a torque with generalised components Q adds to the accelerations.
Vector3d by_torque(const Vector3d& I, const Vector3d& q, const Vector3d& Q) {
  return mass_matrix<double>(I, q).inverse() * Q;
}

Vector3d weightless(const Vector3d& I, const Vector3d& q, const Vector3d& v) { return under_torque(I, zero, q, v); }

/// The wrong answers that are known.
template <class Exercise>
void mistakes_of_heavy_top_accelerations(Exercise& e) {
  e.wrong_terms("The torque of the weight is missing.", "weightless", {0, 1, -1});
  e.wrong_terms("The torque of the weight has the wrong sign: it drives the axis away from the upward vertical.",
                "weight_sign", {-1, 1, -1});
  e.wrong_terms("This leaves out that the matrix between the rates of the angles and ω changes with the angles.",
                "no_E_rate", {1, 1, 0});
  e.wrong_terms("The gyroscopic term is missing.", "no_gyroscopic_term", {1, 0, -1});
  e.wrong("The weight acts on θ̈ alone, as for a symmetric top; where the moments differ it has a part in all three.",
          "theta_only",
          [](auto& I, auto mgl, auto& q, auto& v) { return weightless(I, q, v) + mgl * sin(q[1]) / I[0] * y_axis; });
  e.wrong("The torque of the weight is not divided by a moment of inertia.", "torque_as_acceleration",
          [](auto& I, auto mgl, auto& q, auto& v) { return weightless(I, q, v) + mgl * sin(q[1]) * y_axis; });
  e.template wrong_input<0>("I₁ and I₂ are replaced by their mean, as if the top were symmetric.", "mean_moment",
                            [](Vector3d& I) { I[0] = I[1] = (I[0] + I[1]) / 2; });
  e.wrong(
      "The torque of the weight contains a cosine where the sine belongs: its lever is the level distance of the "
      "centre of mass.",
      "cosine", [](auto& I, auto mgl, auto& q, auto& v) {
        return weightless(I, q, v) + by_torque(I, q, mgl * cos(q[1]) * y_axis);
      });
  e.wrong("Sine and cosine of ψ are exchanged in the torque; look up the line of nodes on the axes of the body.",
          "nodes_exchanged", [](auto& I, auto mgl, auto& q, auto& v) {
            return under_torque(I, mgl * sin(q[1]) * Vector3d(cos(q[2]), sin(q[2]), 0), q, v);
          });
  e.wrong("The torque of the weight acts across the line of nodes here; it acts about this line.", "across_nodes",
          [](auto& I, auto mgl, auto& q, auto& v) {
            return under_torque(I, mgl * sin(q[1]) * Vector3d(cos(q[2]), -sin(q[2]), 0), q, v);
          });
  e.wrong("The torque of the weight acts about axis 2 of the body here; its axis is the line of nodes.", "about_axis_2",
          [](auto& I, auto mgl, auto& q, auto& v) { return under_torque(I, mgl * sin(q[1]) * y_axis, q, v); });
  e.wrong("The weight turns φ here; its torque is about the line of nodes, and its work is done on θ.",
          "about_vertical", [](auto& I, auto mgl, auto& q, auto& v) {
            return weightless(I, q, v) + by_torque(I, q, mgl * sin(q[1]) * x_axis);
          });
  e.wrong("The momentum of ψ is constant here; with different moments across the axis the energy depends on ψ.",
          "psi_cyclic", [](auto& I, auto mgl, auto& q, auto& v) {
            const auto M = [&](const Eigen::Vector3cd& ahead) { return mass_matrix(I, ahead); };
            const Vector3d along_theta = derivative_along(q, y_axis, M) * v;
            return by_torque(I, q,
                             (mgl * sin(q[1]) + 0.5 * v.dot(along_theta)) * y_axis - derivative_along(q, v, M) * v);
          });
  e.wrong("The derivative of the energy with respect to the angles is twice too large: its factor of one half is lost.",
          "energy_twice", [](auto& I, auto mgl, auto& q, auto& v) {
            const auto M = [&](const Eigen::Vector3cd& ahead) { return mass_matrix(I, ahead); };
            Vector3d force = mgl * sin(q[1]) * y_axis;
            for (int i = 0; i < 3; ++i) force[i] += v.dot(derivative_along(q, Vector3d::Unit(i), M) * v);
            return by_torque(I, q, force - derivative_along(q, v, M) * v);
          });
  e.template wrong_input<0>(exchanged_moments.text, "zxz", exchange(0, 1));
  e.template wrong_input<2>(phi_for_psi.text, "phi_for_psi", exchange(0, 2));
}

}  // namespace

void judge_heavy_top_accelerations(Lecture& lecture) {
  auto& e =
      lecture.exercise(&heavy_top_accelerations,
                       {{"I", positive(kg_m2)}, {"mgl", not_negative(joule)}, {"angles", rad}, {"rates", rad_per_s}},
                       {"accelerations", rad_per_s2});
  e.domain([](auto&, auto, auto& q, auto&) { return abs(sin(q[1])) >= 0.05; });
  const Vector3d body(3.8e-4, 4.4e-4, 9e-5), angles(0.3, 0.7, 1.1), rates(5, -2, 150);
  e.worked("three moments", body, top_mgl, angles, rates);
  e.worked("a symmetric top", {top_I1, top_I1, top_I3}, top_mgl, angles, rates);
  e.special("let go at rest", body, top_mgl, angles, zero);
  e.special("without weight", body, 0, angles, rates);
  e.special("horizontal", body, top_mgl, {0.3, pi / 2, 1.1}, rates);
  e.special("hanging", body, top_mgl, {0.3, 2.8, 1.1}, rates);
  e.special("θ = −0.7", body, top_mgl, {0.3, -0.7, 1.1}, rates);
  const Vector2d steady = steady_precession(top_I1, top_I3, top_mgl, 150, 0.7);
  e.special("steady precession", {top_I1, top_I1, top_I3}, top_mgl, angles, {steady[0], 0, 150 - steady[0] * cos(0.7)});
  const double off_plane = top_mgl * sin(1.1) * cos(1.1) * (1 / body[1] - 1 / body[0]);
  const double falling = top_mgl * sin(0.7) * (pow(sin(1.1), 2) / body[0] + pow(cos(1.1), 2) / body[1]);
  e.limit("steady precession", zero, "The three rates stay.");
  e.limit("let go at rest", {off_plane, falling, -off_plane * cos(0.7)},
          "At rest no product of rates counts: the torque of the weight, along the line of nodes, is divided by the "
          "moments.");
  e.random("any body", 10, [](Random& random) {
    const Vector3d I = 1e-4 * random.principal_moments();
    const double mgl = random.uniform(0.02, 0.1);
    return tuple{I, mgl, random.euler_angles(), random.vector(2 * sqrt(mgl / I.maxCoeff()))};
  });
  e.scale([](auto& I, auto mgl, auto& q, auto& v) {
    return or_one((v.squaredNorm() + mgl / I.minCoeff()) / abs(sin(q[1])));
  });
  e.sweep({"A body of moments 3.8, 4.4 and 0.9·10⁻⁴ kg m², let go at rest, mgl = 0.06 J", "θ (rad)",
           "acceleration (rad/s²)"},
          {"φ̈", "θ̈", "ψ̈"}, {0.3, pi - 0.3},
          [](auto theta) { return tuple(Vector3d(3.8e-4, 4.4e-4, 9e-5), top_mgl, Vector3d(0.3, theta, 1.1), zero); });

  e.term("the torque of the weight", 1, [](auto& I, auto mgl, auto& q, auto&) -> Vector3d {
    return rate_axes(q).inverse() * torque_on_body(mgl, q).cwiseQuotient(I);
  });
  e.term("the gyroscopic term", 1, [](auto& I, auto, auto& q, auto& v) -> Vector3d {
    return rate_axes(q).inverse() * cross(L_body(I, q, v), omega_body(q, v)).cwiseQuotient(I);
  });
  e.term("the turning of the axes of the angles", -1,
         [](auto&, auto, auto& q, auto& v) -> Vector3d { return rate_axes(q).inverse() * turning_axes(q, v); });
  mistakes_of_heavy_top_accelerations(e);
  e.survivor("angles[2] taken modulo π",
             "Half a turn about axis 3 changes no moment: at thousands of turns, digits alone.");
  e.angles_read_as_degrees();
  e.route("Lagrange's equations by a complex step", [](auto& I, auto mgl, auto& q, auto& v) {
    const auto M = [&](const Eigen::Vector3cd& ahead) { return mass_matrix(I, ahead); };
    Vector3d force(0, mgl * sin(q[1]), 0);
    for (int i = 0; i < 3; ++i) force[i] += 0.5 * v.dot(derivative_along(q, Vector3d::Unit(i), M) * v);
    return by_torque(I, q, force - derivative_along(q, v, M) * v);
  });
  e.route("Euler's equations with the torque",
          [](auto& I, auto mgl, auto& q, auto& v) { return under_torque(I, torque_on_body(mgl, q), q, v); });
  e.route("the free body, and M⁻¹ of the torque", [](auto& I, auto mgl, auto& q, auto& v) {
    return weightless(I, q, v) + by_torque(I, q, mgl * sin(q[1]) * y_axis);
  });
  e.route("Hamilton's equations by a complex step", [](auto& I, auto mgl, auto& q, auto& v) {
    // q̇ = B⁻¹ I⁻¹ B⁻ᵀ p along the motion, with ṗ = ∂T/∂q + Q
    Vector3d p_rate(0, mgl * sin(q[1]), 0);
    for (int i = 0; i < 3; ++i)
      p_rate[i] += L_body(I, q, v).dot(derivative_along(q, Vector3d::Unit(i), rate_axes<Complex>) * v);
    const auto rates_at_p = [&](const Eigen::Vector3cd& ahead) {
      return mass_matrix(I, ahead).inverse() * (mass_matrix<double>(I, q) * v).template cast<Complex>();
    };
    return derivative_along(q, v, rates_at_p) + by_torque(I, q, p_rate);
  });
}
