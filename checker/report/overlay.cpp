#include "checker/report/overlay.hpp"

#include "checker/messages/plotting.hpp"
#include "checker/report/overlay_script.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace workbook {

namespace fs = std::filesystem;

namespace {

constexpr const char* svg_terminal = "svg noenhanced size 800,640 font 'Helvetica,14' background rgb 'white'";

// Smaller, with letters that are large for their picture: a page is read on a telephone, too.
constexpr const char* page_terminal = "svg noenhanced size 640,512 font 'Helvetica,14' background rgb 'white'";

// Twice the pixels, for sharp text in print and on dense screens.
constexpr const char* png_terminal =
    "pngcairo noenhanced size 1600,1280 font 'Helvetica,24' linewidth 2 background rgb 'white'";

}  // namespace

Overlay overlay_of(const Checked& checked) {
  const ExerciseReference& reference = *checked.reference;
  Overlay overlay;
  overlay.sweep = &reference.sweep;
  overlay.magnitudes =
      reference.comparison == Comparison::eigenvectors || reference.comparison == Comparison::up_to_sign;
  if (checked.executable) {
    std::vector<PlannedCall> calls;
    for (std::size_t i = 0; i < reference.sweep.x.size(); ++i) {
      const Value& expected = reference.sweep.expected[i];
      calls.push_back({reference.sweep.inputs[i], expected.rows, expected.cols});
    }
    ExerciseRunner runner(*checked.executable);
    bool any = false;
    for (const Reply& reply : runner.evaluate(calls)) {
      any = any || reply.ending == Ending::returned;
      overlay.student.push_back(reply.ending == Ending::returned ? reply.value : Value{0, 0, {}});
    }
    if (!any) overlay.student.clear();
  }
  for (const Diagnosis& diagnosis : checked.judgement.diagnoses) {
    if (diagnosis.kind != DiagnosisKind::misconception) continue;
    for (const Misconception& misconception : reference.misconceptions) {
      if (misconception.name != diagnosis.name) continue;
      overlay.misconception = misconception.name;
      std::replace(overlay.misconception.begin(), overlay.misconception.end(), '_', ' ');
      overlay.misconception_outputs = &misconception.sweep_outputs;
    }
  }
  return overlay;
}

fs::path plots_directory(const Course& course) { return course.scratch() / "plots"; }

std::vector<fs::path> draw_overlay(const Overlay& overlay, const fs::path& directory, const std::string& name) {
  if (overlay.sweep->x.empty()) throw PlotError(messages::no_plot(name));
  const auto script = [&](gnuplotio::Gnuplot& gnuplot) { send_panels(gnuplot, overlay); };
  const std::vector<fs::path> files = {directory / (name + ".svg"), directory / (name + ".png")};
  draw_picture(svg_terminal, files[0], script);
  draw_picture(png_terminal, files[1], script);
  return files;
}

std::string overlay_as_svg(const Overlay& overlay, const fs::path& directory, const std::string& name) {
  if (overlay.sweep->x.empty()) throw PlotError(messages::no_plot(name));
  return drawn_picture(page_terminal, directory, [&](gnuplotio::Gnuplot& gnuplot) { send_panels(gnuplot, overlay); });
}

}  // namespace workbook
