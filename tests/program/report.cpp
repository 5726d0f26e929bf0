// The command that writes one student's page.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace workbook::testing;
namespace fs = std::filesystem;

TEST_CASE("report writes one page about all that was asked, and its status says only that") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  const Outcome outcome = course.run("report --html page.html --name Ada");
  CHECK(outcome.status == 0);
  CHECK(outcome.out == "The page is in page.html.\n");
  CHECK(outcome.err.empty());
  const std::string page = read(course.root() / "page.html");
  CHECK(has(page, "Report for Ada"));
  CHECK(has(page, "The factor ½ is missing."));
  CHECK(has(page, "Read lectures/01_springs/notes.md, “Energy”."));
  CHECK(has(page, "data:image/svg+xml;base64,"));
  CHECK(has(page,
            "alt=\"Plot of spring_energy: Energy. It shows the submitted function on the reference and on “no "
            "half”, and their difference below.\""));
  CHECK(has(page, "return k * x.squaredNorm();"));
  CHECK(has(page, "<dd>spring_force</dd>"));
  CHECK_FALSE(has(page, course.root().string()));
  CHECK_FALSE(fs::exists(course.root() / ".workbook"));  // a page is no progress
}

TEST_CASE("report replaces an older page, and takes names, a seed and a file as check does") {
  const CourseCopy course;
  write(course.root() / "page.html", "an older page");
  write(course.root() / "elsewhere.cpp", read(course.solution("spring_energy")));
  CHECK(course.run("report --html page.html spring_energy --file elsewhere.cpp --seed 2").status == 0);
  const std::string page = read(course.root() / "page.html");
  CHECK(has(page, "2 of 2 points"));
  CHECK(has(page, "with the cases of seed 2."));
  CHECK_FALSE(has(page, "spring_force"));
  for (const auto& entry : fs::directory_iterator(course.root())) CHECK(entry.path().extension() != ".part");

  const Outcome two_for_one = course.run("report --html page.html --file elsewhere.cpp");
  CHECK(two_for_one.status == 2);
  CHECK_MESSAGE(has(two_for_one.err, "--file needs the one exercise"), two_for_one.err);
  CHECK(has(course.run("report --html page.html sprigs").err, "Did you mean 'springs'?"));
  CHECK(course.run("report").status == 2);
}

TEST_CASE("a page that cannot be written is refused in one sentence, before the long work") {
  const CourseCopy course;
  const Outcome no_folder = course.run("report --html nowhere/page.html");
  CHECK(no_folder.status == 2);
  CHECK(no_folder.err ==
        "nowhere/page.html cannot be written, because there is no folder nowhere; make it first, or choose another "
        "place.\n");
  const Outcome folder = course.run("report --html lectures");
  CHECK(folder.status == 2);
  CHECK(folder.err ==
        "lectures is no ordinary file, and the page cannot take its place; give --html the name of a file.\n");
  CHECK(course.run("report --html /dev/null").status == 2);
  const Outcome no_write = course.run("report --html /proc/page.html spring_energy");
  CHECK(no_write.status == 3);
  CHECK_MESSAGE(has(no_write.err, "/proc/page.html could not be written ("), no_write.err);
}

TEST_CASE("without gnuplot the page has no plots and says why") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  const Outcome outcome = course.run("report --html page.html", "PATH=/nowhere");
  CHECK_MESSAGE(outcome.status == 0, outcome.err);
  const std::string page = read(course.root() / "page.html");
  CHECK(has(page, "This page has no plots: There is no plot, because gnuplot is not installed"));
  CHECK_FALSE(has(page, "<img"));
}

TEST_CASE("a student's file that is missing, or is no text, leaves a page all the same") {
  const CourseCopy course;
  fs::remove(course.exercise("spring_energy"));
  write(course.exercise("spring_force"), std::string("\xff\xfe\0\x01 int main", 14));
  const Outcome outcome = course.run("report --html page.html");
  CHECK_MESSAGE(outcome.status == 0, outcome.err);
  const std::string page = read(course.root() / "page.html");
  CHECK(has(page, "rejected file"));
  CHECK_FALSE(has(page, std::string(1, '\0')));
}
