#include "checker/messages/plotting.hpp"

#include "checker/messages/program.hpp"

#include <fmt/format.h>

namespace workbook::messages {

namespace {

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

std::string no_plot(const std::string& exercise) { return fmt::format("{} has no plot.", exercise); }

std::string gnuplot_missing_for_plot() {
  return "There is no plot, because gnuplot is not installed (on Debian: apt-get install gnuplot-nox); the verdict "
         "stands without it.";
}

std::string plot_not_written(const std::string& file) {
  return fmt::format("The plot could not be written to {}; make that folder writable, or free some space.", file);
}

std::string plot_not_drawn(const std::string& file) {
  return fmt::format(
      "gnuplot could not draw {}: perhaps the values are too large for a picture, or the disk is full; the verdict "
      "stands without it.",
      file);
}

std::string folder_not_usable(const std::string& folder, const std::string& reason) {
  return fmt::format("Pictures cannot be written into {} ({}); give another folder with --out.", folder, reason);
}

std::string say_what_to_plot(const std::string& example) {
  return fmt::format("Say which exercise to plot, for example `{}`, or --all.", command("plot " + example));
}

std::string all_takes_no_names() { return "--all draws the whole course: leave the names or --all away."; }

std::string only_reference_drawn(const std::string& exercise, const std::string& why) {
  return fmt::format("{}: only the reference is drawn, because your function gave no value. {}", exercise, why);
}

std::string letters_of_component(const std::string& component, char yours, char reference, bool has_yours) {
  if (!has_yours) return fmt::format("{} the reference of {}", reference, component);
  return fmt::format("{} your {}, {} its reference", yours, component, reference);
}

std::string letters_of_misconception(char letter, const std::string& misconception) {
  return fmt::format("{} what “{}” would give", letter, misconception);
}

std::string reference_label(const std::string& component) { return component + " reference"; }

std::string student_label(const std::string& component) { return component + " yours"; }

std::string difference_label() { return "yours − reference"; }

std::string overlay_description(const std::string& exercise, const std::string& title,
                                const std::string& misconception) {
  return fmt::format("Plot of {}: {}. It shows the submitted function on the reference{}, and their difference below.",
                     exercise, title, misconception.empty() ? "" : fmt::format(" and on “{}”", misconception));
}

std::string pictures_done(std::size_t overlays, std::size_t figures, const std::string& folder) {
  return fmt::format("{} and {} are in {}, each as SVG and PNG.", counted(overlays, "overlay"),
                     counted(figures, "figure"), folder);
}

std::string only_references_drawn(const std::vector<std::string>& exercises) {
  return fmt::format("The function gave no value in {}; there only the reference is drawn: {}.",
                     counted(exercises.size(), "exercise"), fmt::join(exercises, ", "));
}

std::string figures_of_lecture(const std::string& lecture) { return fmt::format("figures of {}", lecture); }

std::string no_lecture_figures(const std::string& lecture) {
  return fmt::format("The figures of {} are not in this copy of the workbook, so they are left out.", lecture);
}

std::string lecture_figures_not_built(const std::string& lecture) {
  return fmt::format("The figures of {} could not be drawn; `ninja -C build/workbook figures` says why.", lecture);
}

std::string gnuplot_missing_for_figures() {
  return "Figures need gnuplot, which is not installed (on Debian: apt-get install gnuplot-nox).";
}

std::string figures_need_compiling() {
  return fmt::format("These files do not compile, so the figures cannot be drawn; `{}` on each says why:",
                     command("check"));
}

std::string figures_not_built(const std::string& lecture) {
  return fmt::format("The figures of {} could not be built.", lecture);
}

std::string figures_not_listed(const std::string& lecture) {
  return fmt::format(
      "The program of the figures ends before it draws anything: a function of yours does so on being loaded; `{}` "
      "finds it.",
      command("check " + lecture));
}

std::string figure_not_started() { return "needs a function that is not started"; }

std::string figure_failed(const std::string& text) {
  return text.empty() ? "failed, and said nothing about it" : fmt::format("failed: {}", text);
}

std::string figure_crashed(const std::string& signal) {
  return fmt::format("a function of yours crashed ({}); `{}` on the lecture's exercises finds it", signal,
                     command("check"));
}

std::string figure_out_of_time(double seconds) {
  return fmt::format("not ready after {:g} s: a loop of yours may never end; `{}` on the lecture's exercises finds it",
                     seconds, command("check"));
}

std::string figure_ended_early() {
  return "a function of yours ended the program; remove calls of exit() from your files";
}

std::string figures_drawn(std::size_t drawn, std::size_t total, const std::string& lecture) {
  return fmt::format("{} of {} figures of {} are drawn with your functions.", drawn, total, lecture);
}

}  // namespace workbook::messages
