// Values of the problems of lecture 05 and of `spin_up`, from computations in 34 digits by two ways that share no
// formula.
#include "tests/cases/problems.hpp"

#include <rigid/euler_equations.hpp>

namespace problems_05 {

TEST_CASE("free_attitude: elliptic integrals, and a quaternion by collocation") {
  const Vector3d I(1.2, 2, 2.7), omega0(0.4, -0.9, 0.6);
  CHECK(agrees(free_attitude(I, omega0, 12),
               Matrix3d{{0.903616245476, -0.0809746932718, 0.420619519235},
                        {0.054871689972, 0.995761154657, 0.0738161263922},
                        {-0.424813816338, -0.0436213471304, 0.904229174227}},
               1e-11));
  CHECK(agrees(free_attitude(I, omega0, -7.5),
               Matrix3d{{0.0156270190734, 0.764962665057, -0.64388501873},
                        {-0.557927429639, -0.527718186669, -0.640492387711},
                        {-0.829742598359, 0.369250100242, 0.418546991316}},
               1e-11));
  CHECK(agrees(free_attitude({1, 1, 1.8}, {0.4 * std::cos(0.3), 0.4 * std::sin(0.3), 2}, 0.7),
               Matrix3d{{0.154717683703, -0.965464076229, 0.209622412591},
                        {0.98743533291, 0.158020420574, -0.00100498862213},
                        {-0.0321543413876, 0.207144066274, 0.977781894973}},
               1e-11));
  CHECK(agrees(free_attitude({1, 2, 3}, {0.1, 1, 0.1}, 20),
               Matrix3d{{0.783333794972, 0.187802631185, -0.592552392093},
                        {0.211169669902, 0.81617394454, 0.537835906915},
                        {0.584632821665, -0.546434135074, 0.5996784137}},
               1e-11));
}

TEST_CASE("splitting_step: turns, and each stage integrated") {
  CHECK(agrees(splitting_step({1, 2, 3}, {0.3, -0.2, 0.5}, 0.8),
               Vector3d(0.355120370036, -0.0642909893472, 0.51178947468), 1e-11));
  CHECK(agrees(splitting_step({2.7, 1.2, 2}, {1, 2, -3}, -0.3), Vector3d(0.506013942921, 1.87341111768, -3.24536095928),
               1e-11));
  CHECK(agrees(splitting_step({1, 2, 3}, {0, 0, 5}, 10), Vector3d(0, 0, 5), 1e-14));
}

TEST_CASE("bearing_forces: two equations of motion, and six masses on their circles") {
  const Matrix3d I{{0.05, 0.002, -0.004}, {0.002, 0.06, 0.003}, {-0.004, 0.003, 0.08}};
  const Matrix3d without_products = I.diagonal().asDiagonal();
  const Vector2d bearings(-0.1, 0.35);
  const Vector3d r(0.001, -0.002, 0.1), on_the_shaft(0, 0, 0.1);
  const auto forces = [](double x1, double y1, double x2, double y2) -> Matrix3Xd {
    return Eigen::Matrix<double, 3, 2>{{x1, x2}, {y1, y2}, {0, 0}};
  };
  CHECK(agrees(bearing_forces(I, 4, r, 300, bearings), forces(600, -200, -960, 920), 1e-12));
  CHECK(agrees(bearing_forces(I, 4, on_the_shaft, 300, bearings), forces(800, -600, -800, 600), 1e-12));
  CHECK(agrees(bearing_forces(without_products, 4, r, 300, bearings), forces(-200, 400, -160, 320), 1e-12));
  CHECK(bearing_forces(without_products, 4, on_the_shaft, 300, bearings).norm() == 0);
}

TEST_CASE("gyroscopic_torque: the transport theorem, and the tensor of the rotor in space") {
  CHECK(agrees(gyroscopic_torque(0.35, 0.6, 40, {0.3, -0.5, 2}), Vector3d(-12.25, -7.35, 0), 1e-13));
  CHECK(agrees(gyroscopic_torque(2.1, 4, 250, {0, 0.2, 0}), Vector3d(200, 0, 0), 1e-13));
  CHECK(agrees(gyroscopic_torque(0.35, 0.6, 0, {0.3, -0.5, 2}), Vector3d(-0.25, -0.15, 0), 1e-13));
  CHECK(gyroscopic_torque(0.35, 0.6, 40, {0, 0, 3}).norm() == 0);
}

TEST_CASE("gyrocompass_period: the axle integrated in space, its amplitude brought to zero") {
  CHECK(agrees(gyrocompass_period(0.07, 0.13, 25, 0.7, 2), 0.735256675693, 1e-11));
  CHECK(agrees(gyrocompass_period(0.07, 0.13, -25, 0.7, 2), 0.735256675693, 1e-11));
  CHECK(agrees(gyrocompass_period(0.07, 0.02, -10, -0.4, 2), 3.7288185300, 1e-11));
  CHECK(agrees(gyrocompass_period(0.012, 0.02, 2000, 0.3 * std::acos(-1), 7.292115e-5), 16.6228083079, 1e-11));
}

TEST_CASE("spin_up: the closed form, and Euler's equations by Taylor series") {
  CHECK(agrees(spin_up(1, 1.8, {0.4, 0, 2}, 0.9, 8), Vector3d(0.35712256070516, 0.18017623771016, 6), 1e-12));
  CHECK(agrees(spin_up(2, 0.5, {-0.7, 0.4, 1.5}, -0.1, 4), Vector3d(0.62813756127891, -0.50541389386382, 0.7), 1e-12));
}

TEST_CASE("ball_on_turntable: the closed form, and Newton's and Euler's laws by Taylor series") {
  CHECK(agrees(ball_on_turntable(0.4, 3, {0.4, -0.1}, {0.3, 0.5}, 4), Vector2d(-0.84187988128057, 0.42057028452975),
               1e-12));
  CHECK(agrees(ball_on_turntable(2. / 3, -2, {-0.2, 0.3}, {0.1, -0.6}, 7.5),
               Vector2d(-0.26479922228709, 0.50458290948049), 1e-12));
  CHECK(agrees(ball_on_turntable(0.4, 0, {0.4, -0.1}, {0.3, 0.5}, 4), Vector2d(1.6, 1.9), 1e-14));
}

TEST_CASE("reorientation: a product of exponentials, and the torques of motors that start and stop, by Taylor series") {
  const Matrix3d I{{4.3, -0.4, -0.4}, {-0.4, 3.6, -0.4}, {-0.4, -0.4, 1.7}};
  CHECK(agrees(reorientation(I, {0.02, 0.03}, VectorXd{{0, 150, 150, 0, 0}}, VectorXd{{0, 0, 100, 100, 0}}),
               Matrix3d{{0.88991710430591, -0.45462610951684, 0.036914062487988},
                        {0.40372322023017, 0.8227619590131, 0.40008789065393},
                        {-0.21226188756054, -0.34114199293917, 0.91573305703285}},
               1e-12));
}

}  // namespace problems_05
