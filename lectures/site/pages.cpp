#include "lectures/site/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <regex>
#include <stdexcept>

namespace workbook::site {

namespace {

/// "03" of "03_inertia_tensor".
std::string number(const Card& card) { return card.lecture.substr(0, card.lecture.find('_')); }

std::string titled_link(const Card& card, const std::string& title) {
  return fmt::format("\\ref lecture_{} \"{}\"", card.lecture, title);
}

std::string link(const Card& card) { return titled_link(card, card.title); }

std::string titled_link(const CardExercise& exercise, const std::string& title) {
  return fmt::format("\\ref exercise_{} \"{}\"", exercise.name, title);
}

double points(const Card& card) {
  return std::accumulate(card.exercises.begin(), card.exercises.end(), 0.0,
                         [](double sum, const CardExercise& exercise) { return sum + exercise.points; });
}

std::string counted(double count, const std::string& singular) {
  return fmt::format("{} {}{}", count, singular, count == 1 ? "" : "s");
}

/// The lectures of the course on which a lecture builds.
std::vector<Card> foundations(const std::vector<Card>& course, const Card& card) {
  std::vector<Card> found;
  std::ranges::copy_if(course, std::back_inserter(found), [&](const Card& other) {
    return std::ranges::find(card.builds_on, other.lecture) != card.builds_on.end();
  });
  return found;
}

/// A foundation counts as implied when another foundation of the same lecture builds on it, near or far.
bool builds_on(const std::vector<Card>& course, const Card& card, const Card& foundation) {
  return std::ranges::any_of(foundations(course, card), [&](const Card& nearer) {
    return nearer.lecture == foundation.lecture || builds_on(course, nearer, foundation);
  });
}

/// A title in two lines of about the same length when it is long: boxes of like width make a map for small screens.
std::string in_lines(std::string title) {
  if (title.size() < 18) return title;
  const auto before = title.rfind(' ', title.size() / 2);
  const auto after = title.find(' ', title.size() / 2);
  if (before == std::string::npos && after == std::string::npos) return title;
  const bool take_after = before == std::string::npos || (after != std::string::npos && title.size() - after > before);
  title[take_after ? after : before] = '\n';
  return title;
}

/// A Markdown table's cell cannot hold the bar that ends it.
std::string cell(const std::string& text) { return std::regex_replace(text, std::regex(R"(\|)"), "&#124;"); }

std::string in_quotes(const std::string& text) {
  const std::string escaped = std::regex_replace(text, std::regex(R"(["\\])"), "\\$&");
  return '"' + std::regex_replace(escaped, std::regex("\n"), "\\n") + '"';
}

std::string table_of_exercises(const Card& card, const std::string& contract, const std::string& link_command) {
  std::string table = "| Exercise | Task | Points |\n|:---------|:-----|-------:|\n";
  for (const CardExercise& exercise : card.exercises) {
    table += fmt::format("| {0} exercise_{1} \"{1}\" | {2} | {3} |\n", link_command, exercise.name,
                         cell(first_sentence(card, exercise.name, contract)), exercise.points);
  }
  return table;
}

/// A line of links to the neighbours, as a landmark with a name of its own. Doxygen knows div, but not nav.
std::string navigation(const std::string& label, const std::vector<std::string>& links) {
  return fmt::format("<div class=\"neighbours\" role=\"navigation\" aria-label=\"{}\">\n{}\n</div>\n", label,
                     fmt::join(links, "\n"));
}

}  // namespace

std::string first_page(const std::vector<Card>& course) {
  std::string page = R"(# Rigid Body Workbook {#mainpage}

How does a body turn when nothing holds it, and how does one compute that? Each lecture of this workbook derives one
topic of the course, computes its numbers with code that you can read and run, and ends with small functions for you to
write. Together your functions are a library of rigid-body mechanics.

New symbols are explained where they first appear; all of them stand on the page \ref notation. Where the lectures come
from, and where they differ from their source, stands on the page \ref references.

## The course {#course_map}

An arrow leads from a lecture to the ones that build on it.

\htmlonly[block]<div class="course-map" role="group" aria-label="Course map">\endhtmlonly
\htmlinclude course_map.svg
\htmlonly[block]</div>\endhtmlonly

)";
  for (const Card& card : course) {
    page +=
        fmt::format("- {}: {} *{}, {}.*\n", titled_link(card, number(card) + " " + card.title), card.summary,
                    counted(static_cast<double>(card.exercises.size()), "exercise"), counted(points(card), "point"));
  }
  page += R"(
## How to work with it {#how_to_work}

Read a lecture, then write its functions one by one in `lectures/LECTURE/exercises/`; each file holds one function and a
`TODO`. The checker tells you where you stand and what to do next:

```
./checker/run
```

It compiles your function, compares what it computes with reference results, and says what is wrong in the words of the
lecture. The page \ref exercises lists all tasks.
)";
  return page;
}

std::string exercises_page(const std::vector<Card>& course, const std::vector<std::string>& contracts) {
  std::string page =
      "# Exercises {#exercises}\n\n"
      "One function each, in the order of the course. A page shows what the function means, its units and "
      "its errors, where the notes explain it, and how to check yours.\n";
  for (std::size_t lecture = 0; lecture < course.size(); ++lecture) {
    const Card& card = course[lecture];
    // Not a heading of Markdown: those would stand before the exercises in the navigation.
    page += fmt::format("\n<h2>{} {}</h2>\n\nNotes: {}\n\n{}", number(card), card.title, link(card),
                        table_of_exercises(card, contracts.at(lecture), "\\subpage"));
  }
  return page;
}

std::string exercise_page(const std::vector<Card>& course, std::size_t lecture, std::size_t exercise,
                          const std::string& contract) {
  const Card& card = course.at(lecture);
  const CardExercise& task = card.exercises.at(exercise);
  std::vector<std::string> neighbours;
  if (exercise > 0) {
    const CardExercise& before = card.exercises.at(exercise - 1);
    neighbours.push_back(titled_link(before, "← " + before.name));
  }
  neighbours.push_back("\\ref exercises \"All exercises\"");
  if (exercise + 1 < card.exercises.size()) {
    const CardExercise& after = card.exercises.at(exercise + 1);
    neighbours.push_back(titled_link(after, after.name + " →"));
  } else if (lecture + 1 < course.size()) {
    neighbours.push_back(titled_link(course.at(lecture + 1), course.at(lecture + 1).title + " →"));
  }
  return fmt::format(R"(# {name} {{#exercise_{name}}}

Exercise {position} of {count} in the lecture {lecture}, {points}.

```{{.cpp}}
{declaration}
```

\copydoc rigid::{name}

## Where to read {{#exercise_{name}_notes}}

\ref {notes} in the lecture {lecture}.

## How to check yours {{#exercise_{name}_check}}

Write it in `lectures/{folder}/exercises/{name}.cpp`, then

```
./checker/run check {name}
```

When you are stuck, `./checker/run hint {name}` helps a little, and more each time you ask.

{neighbours})",
                     fmt::arg("name", task.name), fmt::arg("position", exercise + 1),
                     fmt::arg("count", card.exercises.size()), fmt::arg("lecture", link(card)),
                     fmt::arg("points", counted(task.points, "point")),
                     fmt::arg("declaration", declaration(card, task.name, contract)), fmt::arg("notes", task.notes),
                     fmt::arg("folder", card.lecture), fmt::arg("neighbours", navigation("Exercises", neighbours)));
}

std::string lecture_card(const std::vector<Card>& course, std::size_t lecture) {
  const Card& card = course.at(lecture);
  std::string text = fmt::format("Slides: {}.", fmt::join(card.slides, "; "));
  std::vector<std::string> links;
  for (const Card& foundation : foundations(course, card)) links.push_back(link(foundation));
  if (!links.empty()) text += fmt::format(" Builds on: {}.", fmt::join(links, ", "));
  return fmt::format("<div class=\"lecture-card\">\n{} Contract: `rigid/{}.hpp`.\n</div>\n", text, card.contract);
}

std::string exercise_table(const Card& card, const std::string& contract) {
  // In a quoted part Doxygen no longer knows formulas: they reach MathJax as HTML.
  static const std::regex formula(R"(\\f\$(.*?)\\f\$)");
  return std::regex_replace(table_of_exercises(card, contract, "\\ref"), formula, R"(\htmlonly\($1\)\endhtmlonly)");
}

std::string lecture_links(const std::vector<Card>& course, std::size_t lecture) {
  std::vector<std::string> neighbours;
  if (lecture > 0) neighbours.push_back(titled_link(course.at(lecture - 1), "← " + course.at(lecture - 1).title));
  neighbours.push_back("\\ref course_map \"Course map\"");
  if (lecture + 1 < course.size())
    neighbours.push_back(titled_link(course.at(lecture + 1), course.at(lecture + 1).title + " →"));
  return navigation("Lectures", neighbours);
}

std::string course_map(const std::vector<Card>& course) {
  // Colours come from the style sheet, so that the map follows light and dark.
  std::string graph =
      "digraph course {\n"
      "  node [shape=box, style=rounded, fontname=\"Helvetica\", fontsize=13, margin=\"0.2,0.1\"];\n"
      "  edge [arrowsize=0.7];\n"
      "  nodesep=0.35; ranksep=0.4; bgcolor=transparent;\n";
  for (const Card& card : course) {
    graph += fmt::format("  {} [label={}, URL=\"lecture_{}.html\", tooltip={}];\n", in_quotes(card.lecture),
                         in_quotes(number(card) + "\n" + in_lines(card.title)), card.lecture, in_quotes(card.summary));
  }
  for (const Card& card : course) {
    const std::vector<Card> all = foundations(course, card);
    for (const Card& foundation : all) {
      if (std::ranges::any_of(all, [&](const Card& nearer) { return builds_on(course, nearer, foundation); })) continue;
      graph += fmt::format("  {} -> {};\n", in_quotes(foundation.lecture), in_quotes(card.lecture));
    }
  }
  return graph + "}\n";
}

std::string first_sentence(const Card& card, const std::string& function, const std::string& contract) {
  // A comment of full lines, then the declaration without an empty line between.
  const std::regex pattern(R"((?:^|\n\n)/// ([^\n]*(?:\n/// [^\n]*)*)(?:\n///[^\n]*)*\n[^/\n][^\n]*\b)" + function +
                           R"(\()");
  std::smatch match;
  if (!std::regex_search(contract, match, pattern)) {
    throw std::runtime_error(fmt::format(
        "include/rigid/{}.hpp says nothing about {}: write a comment with /// above it.", card.contract, function));
  }
  const std::string paragraph = std::regex_replace(match[1].str(), std::regex(R"(\n/// *)"), " ");
  const auto end = paragraph.find(". ");
  return end == std::string::npos ? paragraph : paragraph.substr(0, end + 1);
}

std::string declaration(const Card& card, const std::string& function, const std::string& contract) {
  // From the start of a line that holds "NAME(" and is no comment, to the semicolon.
  const std::regex pattern(R"((?:^|\n)([^/\n][^\n]*\b)" + function + R"(\([^;]*;))");
  std::smatch match;
  if (!std::regex_search(contract, match, pattern)) {
    throw std::runtime_error(fmt::format("include/rigid/{}.hpp does not declare {}, though the card of {} lists it.",
                                         card.contract, function, card.lecture));
  }
  return match[1];
}

}  // namespace workbook::site
