// The figures of a lecture with the student's own functions, and every picture at once.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

const char* const with_stand_ins = "PATH=\"$PWD/stand-ins:$PATH\"";

/// A program that stands in for one of the system's.
void stand_in(const CourseCopy& course, const std::string& name, const std::string& script) {
  const fs::path file = course.root() / "stand-ins" / name;
  write(file, "#!/bin/sh\n" + script + "\n");
  fs::permissions(file, fs::perms::owner_all);
}

/// As if the build had made the program of the lecture's figures.
void give_figures(const CourseCopy& course) {
  stand_in(course, "cmake", "exit 0");
  fs::create_directories(course.root() / "build/lectures");
  fs::copy_file(WORKBOOK_TEST_FIGURES, course.root() / "build/lectures/draw_of_the_student_01_springs");
}

}  // namespace

TEST_CASE("each figure is tried on its own, and says how it came out") {
  const CourseCopy course;
  give_figures(course);
  const Outcome outcome = course.run("figures springs --out pictures --seconds 2", with_stand_ins);
  CAPTURE(outcome.out);
  CAPTURE(outcome.err);
  CHECK(outcome.status == 1);
  CHECK(has(outcome.out, "✓ sound: pictures/sound.svg\n"));
  CHECK(has(outcome.out, "· idle: needs a function that is not started"));
  CHECK(has(outcome.out, "✗ refused: failed: no such ?[31mangle"));
  CHECK(has(outcome.out, "✗ thrown: failed: something was thrown that is no std::exception"));
  CHECK(has(outcome.out, "✗ not_finite: failed: gnuplot could not draw not_finite.svg: is it installed,"));
  CHECK(has(outcome.out, "✗ half_drawn: failed: gnuplot could not draw half_drawn.svg"));
  CHECK(has(outcome.out, "✗ crashing: a function of yours crashed (Aborted)"));
  CHECK(has(outcome.out, "✗ leaving: a function of yours ended the program"));
  CHECK(has(outcome.out, "✗ endless: not ready after 2 s: a loop of yours may never end"));
  CHECK(has(outcome.out, "✓ last: pictures/last.svg\n"));
  CHECK(has(outcome.out, "2 of 10 figures of 01_springs are drawn with your functions."));
  CHECK(read(course.root() / "pictures/sound.png").substr(1, 3) == "PNG");
  CHECK_FALSE(fs::exists(course.root() / "pictures/not_finite.svg"));
  CHECK_FALSE(fs::exists(course.root() / "pictures/sound.svg.complete"));
}

TEST_CASE("figures without their tools, their folder or their program are told in one sentence") {
  const CourseCopy course;
  const Outcome no_gnuplot = course.run("figures springs", "PATH=/nowhere");
  CHECK(no_gnuplot.status == 3);
  CHECK(no_gnuplot.err == "Figures need gnuplot, which is not installed (on Debian: apt-get install gnuplot-nox).\n");

  write(course.root() / "pictures", "a file where the folder should be");
  const Outcome no_folder = course.run("figures springs --out pictures");
  CHECK(no_folder.status == 3);
  CHECK_MESSAGE(has(no_folder.err, "Pictures cannot be written into pictures ("), no_folder.err);

  const Outcome not_built = course.run("figures springs");  // the course has no build of its own
  CHECK(not_built.status == 3);
  CHECK_MESSAGE(has(not_built.err, "The figures of 01_springs could not be built."), not_built.err);

  stand_in(course, "cmake", "echo '../lectures/01_springs/exercises/spring_energy.cpp:3:4: error: no'; exit 1");
  const Outcome not_compiled = course.run("figures springs", with_stand_ins);
  CHECK(not_compiled.status == 1);
  CHECK_MESSAGE(has(not_compiled.out, "These files do not compile"), not_compiled.out);
  CHECK_MESSAGE(has(not_compiled.out, "  lectures/01_springs/exercises/spring_energy.cpp\n"), not_compiled.out);

  stand_in(course, "cmake", "exit 0");
  write(course.root() / "build/lectures/draw_of_the_student_01_springs", "#!/bin/sh\nkill -SEGV $$\n");
  fs::permissions(course.root() / "build/lectures/draw_of_the_student_01_springs", fs::perms::owner_all);
  const Outcome not_listed = course.run("figures springs", with_stand_ins);
  CHECK(not_listed.status == 1);
  CHECK_MESSAGE(has(not_listed.out, "The program of the figures ends before it draws anything"), not_listed.out);

  CHECK(has(course.run("figures sprigs").err, "Did you mean 'springs'?"));
}

TEST_CASE("the program of the figures refuses a name that it does not know, and ends badly if a figure does") {
  const CourseCopy course;
  const auto run = [&](const std::string& arguments) {
    stand_in(course, "figures", std::string(WORKBOOK_TEST_FIGURES) + " " + arguments + "; echo status $? >ended");
    const std::string command = "cd '" + course.root().string() + "' && stand-ins/figures >said 2>&1";
    CHECK(std::system(command.c_str()) == 0);
    return read(course.root() / "ended");
  };
  CHECK(run("pictures sound") == "status 0\n");
  CHECK(run("pictures idle") == "status 3\n");
  CHECK(run("pictures refused") == "status 1\n");
  CHECK(run("pictures no_such_figure") == "status 2\n");
  CHECK(has(read(course.root() / "said"), "DIRECTORY [FIGURE], or --list"));
  CHECK(run("") == "status 2\n");
}

TEST_CASE("plot --all draws every overlay and brings the figures of every lecture") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  stand_in(course, "cmake", "exit 0");
  write(course.root() / "build/figures/01_springs/spring.svg", "<svg/>");
  write(course.root() / "build/figures/01_springs/spring.png", "png");
  write(course.root() / "build/figures/01_springs/drawn", "");
  const Outcome outcome = course.run("plot --all --out pictures", with_stand_ins);
  CAPTURE(outcome.out);
  CAPTURE(outcome.err);
  CHECK(outcome.status == 1);  // spring_force is not started
  for (const char* file :
       {"overlays/01_springs/spring_energy.svg", "overlays/01_springs/spring_energy.png",
        "overlays/01_springs/spring_force.svg", "figures/01_springs/spring.svg", "figures/01_springs/spring.png"}) {
    CAPTURE(file);
    CHECK(fs::exists(course.root() / "pictures" / file));
  }
  CHECK_FALSE(fs::exists(course.root() / "pictures/figures/01_springs/drawn"));
  CHECK(
      has(outcome.out, "The function gave no value in 1 exercise; there only the reference is drawn:\nspring_force."));
  CHECK(has(outcome.out, "2 overlays and 1 figure are in pictures, each as SVG and PNG.\n"));
}

TEST_CASE("plot --all says what is missing, and draws the rest") {
  const CourseCopy course;
  fs::copy_file(course.solution("spring_energy"), course.exercise("spring_energy"),
                fs::copy_options::overwrite_existing);
  fs::copy_file(course.solution("spring_force"), course.exercise("spring_force"), fs::copy_options::overwrite_existing);
  stand_in(course, "cmake", "exit 1");
  const Outcome not_built = course.run("plot --all --out pictures", with_stand_ins);
  CHECK(not_built.status == 3);
  CHECK_MESSAGE(has(not_built.err, "The figures of 01_springs could not be drawn; "), not_built.err);
  CHECK_MESSAGE(has(not_built.out, "2 overlays and 0 figures are in pictures"), not_built.out);

  fs::remove_all(course.root() / "solutions");  // what students are given
  const Outcome handed_out = course.run("plot --all --out pictures", with_stand_ins);
  CHECK(handed_out.status == 0);
  CHECK_MESSAGE(has(handed_out.err, "The figures of 01_springs are not in this copy of the workbook"), handed_out.err);

  CHECK(has(course.run("plot --all --out pictures", "PATH=/nowhere").err, "gnuplot is not installed"));
  CHECK(has(course.run("plot --all spring_energy").err, "leave the names or --all away"));
  CHECK(has(course.run("plot --all --file x.cpp").err, "--file needs the one exercise"));
  write(course.root() / "file", "a file where the folder should be");
  const Outcome no_folder = course.run("plot --all --out file/below");
  CHECK(no_folder.status == 3);
  CHECK_MESSAGE(has(no_folder.err, "Pictures cannot be written into file/below ("), no_folder.err);
}
