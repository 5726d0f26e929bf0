// Figures that come out in every way in which figures can.
#include "lectures/support/sketch.hpp"

#include <rigid/vocabulary.hpp>

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <vector>

namespace {

using Directory = std::filesystem::path;

void spring_force() { throw rigid::NotStarted{}; }

void draw_values(const Directory& directory, const std::string& name, double value) {
  workbook::draw_figure(directory, name, {320, 240}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "plot '-' with lines\n";
    gnuplot.send1d(std::vector<double>{value, value, value});
  });
}

}  // namespace

int main(int argc, char** argv) {
  return workbook::draw_figures(argc, argv,
                                {{"sound", [](const Directory& directory) { draw_values(directory, "sound", 1.0); }},
                                 {"idle", [](const Directory&) { spring_force(); }},
                                 {"refused",
                                  [](const Directory&) {
                                    std::puts("a printout of the student");
                                    throw std::runtime_error("no such \033[31mangle");
                                  }},
                                 {"thrown", [](const Directory&) { throw 3; }},
                                 {"not_finite",
                                  [](const Directory& directory) {
                                    draw_values(directory, "not_finite", std::numeric_limits<double>::quiet_NaN());
                                  }},
                                 {"left_handed",
                                  [](const Directory&) {
                                    workbook::Sketch sketch({1, -2, 1});
                                    for (const double side : {1.0, -1.0}) {
                                      sketch.arrow(workbook::origin, workbook::x_axis, "black", "e_1 = 1 m");
                                      sketch.arrow(workbook::origin, side * workbook::y_axis, "black", "e_2 = 2 m");
                                      sketch.arrow(workbook::origin, workbook::z_axis, "black", "e_3 = 3 m");
                                      std::puts("drawn");
                                    }
                                  }},
                                 {"half_drawn",
                                  [](const Directory& directory) {
                                    workbook::draw_figure(directory, "half_drawn", {320, 240},
                                                          [](gnuplotio::Gnuplot& gnuplot) {
                                                            gnuplot << "plot sin(x)\nplot no_such_function(x)\n";
                                                          });
                                  }},
                                 {"crashing", [](const Directory&) { std::abort(); }},
                                 {"leaving", [](const Directory&) { std::exit(0); }},
                                 {"endless",
                                  [](const Directory&) {
                                    for (volatile bool looping = true; looping;) {
                                    }
                                  }},
                                 {"ball", [](const Directory& directory) {
                                    workbook::Sketch sketch;  // its scale: 76 pixels
                                    sketch.ellipsoid(Eigen::Matrix3d::Identity(), workbook::colors::sky);
                                    sketch.text({0, 1.5, 0}, "1.234 m");
                                    for (const double z : {-2.0, 2.0})
                                      sketch.line({{-2, 0, z}, {2, 0, z}}, workbook::colors::blue);
                                    sketch.draw(directory, "ball", 320);
                                  }}});
}
