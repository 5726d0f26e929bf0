// The command that writes one student's page.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace workbook::testing;
namespace fs = std::filesystem;

TEST_CASE("report writes one page about all that was asked, and its status says only that") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  write(course.root() / "page.html", "an older page");
  const Outcome outcome = course.run("report --html page.html --name Ada");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  const std::string page = read(course.root() / "page.html");
  for (const char* part :
       {"<h1>Report for Ada</h1>", "The factor ½ is missing.", "the notes of lecture 01, “Energy”",
        "data:image/svg+xml;base64,", "“no half”", "return k * x.squaredNorm();", "spring_force"})
    CHECK_MESSAGE(has(page, part), part);
  CHECK_FALSE(has(page, course.root().string()));
  CHECK_FALSE(fs::exists(course.root() / ".workbook"));  // a page is no progress
  for (const auto& entry : fs::directory_iterator(course.root())) CHECK(entry.path().extension() != ".part");
}

TEST_CASE("report takes names, a seed and a file as check does, and makes the page's folder") {
  const CourseCopy course;
  fs::copy_file(course.solution("spring_energy"), course.root() / "elsewhere.cpp");
  CHECK(course.run("report --html new/page.html spring_energy --file elsewhere.cpp --seed 2").status == 0);
  const std::string page = read(course.root() / "new/page.html");
  CHECK(has(page, "2 of 2 points"));
  CHECK(has(page, "seed 2."));
  CHECK_FALSE(has(page, "spring_force"));
}

TEST_CASE("where nothing of a lecture is begun, its reference results are not made for the page") {
  const CourseCopy course;
  for (const char* exercise : {"spring_energy", "spring_force"})
    REQUIRE(course.run(std::string("reset ") + exercise).status == 0);
  fs::remove(course.reference());
  course.stand_in("setup.sh", "exit 1");
  CHECK(course.run("report --html page.html").status == 0);
  const std::string page = read(course.root() / "page.html");
  CHECK(has(page, "spring_force"));
  CHECK_FALSE(has(page, "could not be judged"));
  course.answer_energy("return k;");
  CHECK(course.run("report --html page.html").status == 0);
  CHECK(has(read(course.root() / "page.html"), "could not be judged"));
}

TEST_CASE("a student's file that is missing, or is no text, leaves a page all the same") {
  const CourseCopy course;
  fs::remove(course.exercise("spring_energy"));
  write(course.exercise("spring_force"), std::string("\xff\xfe\0\x01 int main", 13));
  CHECK(course.run("report --html page.html", without_programs).status == 0);
  const std::string page = read(course.root() / "page.html");
  CHECK(has(page, "rejected file"));
  CHECK(has(page, "gnuplot"));
  CHECK_FALSE(has(page, "<img"));
  CHECK_FALSE(has(page, std::string(1, '\0')));
}
