#include "checker/messages/help.hpp"

#include "checker/messages/program.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>

namespace workbook::messages {

namespace {

const std::map<std::string, CommandHelp>& all_help() {
  static const std::map<std::string, CommandHelp> help = {
      {"check",
       {"Grade exercises and say what is wrong\n\nCompiles each exercise, runs it in a process of its own at the cases "
        "of the reference results, and compares. Of the first case that fails you see the inputs, the expected value "
        "and yours; then why, as far as that is certain, and where to read. Exercises and lectures are given by name "
        "or number; without any, the whole course is checked. Verdicts on the exercise's own file with the usual seed "
        "are remembered as your progress.",
        "check inertia_of_points\ncheck 03\ncheck 03 --started\ncheck inertia_of_points --case 'no mass at all'\n"
        "check inertia_of_points --file draft.cpp --plot\ncheck --seed 7 --json"}},
      {"watch",
       {"Check every file as you save it\n\nStarts at the next exercise, or at the one that is named, and waits. Each "
        "time an exercise file is saved, its verdict takes the place of the one before; when it passes, the next "
        "exercise is shown. Keys: h hint, l list, p plot, n next, c all that the compiler says, r again, q quit. Where "
        "the system reports no changes, or WORKBOOK_POLL is set, the files are looked at every second.",
        "watch\nwatch 03\nwatch inertia_of_points"}},
      {"list", {"Show every exercise with its state", ""}},
      {"hint",
       {"Show the next hint of an exercise\n\nEvery exercise has three hints, weakest first. Each call shows one more; "
        "the last one stays.",
        "hint inertia_of_points"}},
      {"plot",
       {"Draw your curve on the reference\n\nWrites an SVG and a PNG with your curve on the reference and the "
        "difference below, and shows the picture in the terminal where it can: as graphics in terminals that know the "
        "kitty or the sixel protocol, as text elsewhere. For instructors: --all --out DIR draws every exercise and "
        "every figure of the lectures.",
        "plot inertia_of_points\nplot 03\nplot --all --out pictures"}},
      {"figures",
       {"Redraw the figures of a lecture with your own functions\n\nA figure that needs a function you have not "
        "started is left out and named.",
        "figures 03"}},
      {"examples",
       {"Run the worked examples of a lecture on your own functions\n\nShows which of them come out by now, which need "
        "a function that is not started, and which come out otherwise.",
        "examples 03"}},
      {"report",
       {"Write one page about your work, to hand in or to read\n\nThe page is complete in itself: verdicts, "
        "diagnoses, plots, your files, and what to read next.",
        "report --html report.html\nreport --html inertia.html 03 --name 'YOUR NAME'"}},
      {"reset",
       {"Put an exercise back to the beginning\n\nYour version is kept in the folder .workbook/kept.",
        "reset inertia_of_points"}},
      {"handout",
       {"Write the copy of the workbook that students get\n\nThe copy has no solutions: reference results, printed "
        "numbers and figures come as data, and every exercise as at the beginning. Students type the same commands in "
        "it.",
        "handout ../phy711-students"}},
      {"doctor", {"Say what this machine offers", ""}},
      {"completion",
       {"Print what lets bash complete commands, options and names\n\nPut the line below into ~/.bashrc, with the "
        "path of your workbook.",
        "completion"}},
      {"self-check",
       {"Is the workbook itself in order?\n\nTries every stub, solution, right route, wrong answer, hint and pointer "
        "of the course, and names the file and the cure where something is amiss.",
        "self-check --seeds 20"}},
  };
  return help;
}

const std::map<std::string, std::string>& all_options() {
  static const std::map<std::string, std::string> options = {
      {"name", "exercises or lectures, by name or number"},
      {"exercise", "its name"},
      {"lecture", "its name, number or topic"},
      {"folder", "a new folder for the copy"},
      {"--plain", "words in place of marks, colours and drawings, for screen readers"},
      {"--course", "another course.json than the one that was built"},
      {"--file", "take this file in place of the exercise's own"},
      {"--seed", "draw other random cases"},
      {"--case", "show this case in full, whether it passes or not"},
      {"--started", "leave out what is not started"},
      {"--full", "show all that the compiler says, not only its first error"},
      {"--json", "print one JSON document and nothing else"},
      {"--plot", "draw your curve on the reference, as SVG and PNG"},
      {"--picture", "how to show the plot on the terminal: auto, kitty, sixel, text or none"},
      {"--all", "all hints; or all plots and the figures of every lecture"},
      {"--out", "the folder for the pictures"},
      {"--seconds", "the most that one figure may take"},
      {"--html", "the page to write; an older one is replaced"},
      {"--name", "whose page it is"},
      {"--seeds", "how many seeds to try, from 1 on"},
  };
  return options;
}

}  // namespace

std::string program_description() {
  return "The checker of the Rigid Body Workbook.\n\nIt compiles your functions, compares what they compute with "
         "reference results, and says what is wrong in the language of the lecture. Without a command it says where "
         "you stand and what is next.";
}

std::string program_footer() {
  return fmt::format(
      "Exit status:\n"
      "  0  all that was asked passed\n"
      "  1  something did not\n"
      "  2  wrong usage\n"
      "  3  the checker itself is in trouble (never counted as your zero)\n"
      "\n"
      "Environment:\n"
      "  NO_COLOR        no colour\n"
      "  CLICOLOR_FORCE  colour even where the output is no terminal\n"
      "  COLUMNS         the width of the output where it is no terminal\n"
      "  WORKBOOK_PLAIN  the same as --plain\n"
      "  WORKBOOK_POLL   watch looks at the files every second, without events\n"
      "\n"
      "Files:\n"
      "  lectures/NN_topic/exercises/*.cpp  what you write\n"
      "  .workbook/progress.json            your progress\n"
      "  .workbook/kept/                    what reset put aside\n"
      "  build/workbook/scratch/            plots and compiled exercises; may be deleted\n"
      "\n"
      "More about one command: {}",
      command("COMMAND --help"));
}

const CommandHelp& help_of(const std::string& name) { return all_help().at(name); }

std::string examples_of(const CommandHelp& help) {
  if (help.examples.empty()) return "";
  std::string text = "Examples:\n";
  std::istringstream lines(help.examples);
  for (std::string line; std::getline(lines, line);) text += "  " + command(line) + "\n";
  return text;
}

std::string arguments_heading() { return "Arguments"; }
std::string command_placeholder() { return "COMMAND"; }

const std::string& option_help(const std::string& option) { return all_options().at(option); }

std::string for_students() { return "For students"; }
std::string for_instructors() { return "For instructors"; }
std::string for_authors() { return "For authors"; }
std::string for_tests() { return "For tests of the checker"; }

}  // namespace workbook::messages
