#include "solutions/07_euler_angles/shared.hpp"

void judge_line_of_nodes(Lecture& lecture) {
  auto& e = lecture.exercise(&line_of_nodes, {{"psi", rad}}, {"e2'", none});
  e.worked("ψ of the lecture", 1.1);
  e.special("ψ = 0", 0);
  e.special("ψ = π", pi);
  e.special("ψ = π/4, where sine and cosine agree", pi / 4);
  e.special("a tiny ψ", 1e-8);
  e.random("any ψ", 8, oblique_angle);
  e.sweep<0>({"The line of nodes seen from the body", "ψ (rad)", "component on the body axis"},
             {"along ê_1", "along ê_2"}, {0, 2 * pi});

  e.term("sin ψ ê₁", 1, [](auto psi) { return sin(psi) * x_axis; });
  e.term("cos ψ ê₂", 1, [](auto psi) { return cos(psi) * y_axis; });
  e.wrong_output({"This is ê₁′, as for z–x–z angles; on the slides the second turn is about ê₂′.", zxz_notes}, "x_axis",
                 quarter_turn);
  e.wrong_input<0>("ê₂′ is turned the wrong way: the axes turn by ψ, it goes back.", "turned_backwards", negated);
  e.wrong_output("(cos ψ, sin ψ, 0) is at ψ from ê₁; the nodes are at ψ from ê₂.", "polar_angle", exchange(0, 1));
  e.wrong_output("Your arrow points the opposite way: at ψ = 0 the line of nodes is ê₂, not −ê₂.", "opposite", negated);
  e.wrong_input<0>("ψ does not enter: (0, 1, 0) are the components before the last turn.", "not_turned", fixed(0.0));
  e.wrong("This is ê₃, the axis of the third turn, across the nodes.", "body_axis", [](auto) { return z_axis; });
  e.angles_read_as_degrees(turns_notes);
  e.property(Is::unit_norm, "ê₂′ is a unit vector.");
  e.route("R_ψ (0, 1, 0)", [](auto psi) { return about_z(psi) * y_axis; });
  e.route("i exp(−iψ)", [](auto psi) {
    const auto node = std::complex(0.0, 1.0) * polar(1.0, -psi);
    return Vector3d(node.real(), node.imag(), 0);
  });
  e.route("across the two vertical axes",
          [](auto psi) { return cross(about_z(psi) * about_y(1.0) * z_axis, z_axis).normalized(); });
}
