#include "checker/report/reports.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace workbook {

namespace {

using Numbers = std::vector<double>;

// Okabe and Ito's colours: told apart by the colour-blind, and by lightness in print.
constexpr std::array reference_colors = {"#56B4E9", "#F0B040", "#66C2A5"};
constexpr std::array student_colors = {"#004B7A", "#A04000", "#00604A"};
constexpr std::array letter_colors = {"#3794D0", "#C8781E", "#3A9E6B"};  // they read on black and on white
constexpr std::array point_types = {7, 5, 9};

constexpr std::array reference_letters = {'.', ':', '+'};
constexpr char misconception_letter = '~';
char student_letter(std::size_t component) { return static_cast<char>('A' + component % 26); }

bool is_sign_free(const ExerciseReference& reference) {
  return reference.comparison == Comparison::eigenvectors || reference.comparison == Comparison::up_to_sign;
}

/// "omega_1" as the axes have it: "ω₁".
std::string as_symbol(std::string name) {
  constexpr std::array<std::array<const char*, 2>, 3> letters = {{{"omega", "ω"}, {"Omega", "Ω"}, {"sigma", "σ"}}};
  for (const auto& [word, letter] : letters) name = replaced(name, fmt::format("\\b{}(?![a-zA-Z])", word), letter);
  constexpr std::array digits = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  for (std::size_t digit = 0; digit < digits.size(); ++digit)
    name = replaced(name, fmt::format("_{}(?![0-9])", digit), digits[digit]);
  return name;
}

/// Every component along the sweep.
Overlay::Curves curves_of(const ExerciseReference& reference, const std::vector<Value>& values) {
  Overlay::Curves curves;
  for (const PlotComponent& component : reference.sweep.components) {
    Numbers& curve = curves.emplace_back();
    for (const Value& value : values) {
      const bool is_there = component.row < value.rows && component.col < value.cols && value.is_complete();
      const double number = is_there ? value.at(component.row, component.col) / reference.sweep.y_unit : std::nan("");
      curve.push_back(is_sign_free(reference) ? std::abs(number) : number);
    }
  }
  return curves;
}

/// Text inside gnuplot's single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? "''" : std::string(1, letter);
  return result + "'";
}

/// Data and how to draw it, gathered into one command. A line without a number breaks the curve.
class PlotCommand {
 public:
  PlotCommand(const Overlay& overlay, std::string name) : overlay_(overlay), name_(std::move(name)) {}

  /// @param steps  so many points along each piece of the curve, for letters that follow it without gaps
  void add(const Numbers& y, const std::string& style, std::size_t steps = 1) {
    const std::string block = fmt::format("${}{}", name_, ++count_);
    data_ += block + " << END\n";
    const Numbers& x = overlay_.sweep->x;
    for (std::size_t i = 0; i < y.size(); ++i) {
      data_ += std::isfinite(y[i]) ? fmt::format("{} {}\n", x[i], y[i]) : fmt::format("{} NaN\n", x[i]);
      if (i + 1 == y.size()) break;
      const bool is_gap = std::abs(x[i + 1] - x[i]) > 1.5 * std::abs(x[1] - x[0]);
      const bool is_joined = !is_gap && std::abs(y[i + 1] - y[i]) <= overlay_.jump;
      if (!is_joined) data_ += fmt::format("{} NaN\n", x[i]);
      for (std::size_t k = 1; is_joined && k < steps; ++k) {
        const double part = static_cast<double>(k) / static_cast<double>(steps);
        data_ += fmt::format("{} {}\n", std::lerp(x[i], x[i + 1], part), std::lerp(y[i], y[i + 1], part));
      }
    }
    data_ += "END\n";
    plots_ += (count_ == 1 ? "plot " : ", ") + block + " " + style;
  }
  /// An entry of the legend alone.
  void explain(const std::string& style) { plots_ += ", NaN " + style; }
  std::string script() const { return data_ + plots_ + "\n"; }

 private:
  const Overlay& overlay_;
  std::string name_;
  std::size_t count_ = 0;
  std::string data_;
  std::string plots_;
};

std::string student_style(std::size_t k) {
  return fmt::format("with linespoints lw 1.5 pt {} ps 0.6 pointinterval 4 lc rgb '{}' title ''", point_types[k % 3],
                     student_colors[k % 3]);
}

std::string upper_panel(const Overlay& overlay) {
  PlotCommand plot(overlay, "curve");
  for (std::size_t k = 0; k < overlay.labels.size(); ++k) {
    // Ever narrower, so that equal ones are all seen.
    plot.add(overlay.reference[k], fmt::format("with lines lw {} lc rgb '{}' title {}",
                                               k == 0   ? 7.0
                                               : k == 1 ? 4.5
                                                        : 2.5,
                                               reference_colors[k % 3], quoted(overlay.labels[k])));
    if (!overlay.student.empty()) plot.add(overlay.student[k], student_style(k));
    if (!overlay.misconception.empty())
      plot.add(overlay.misconception[k],
               fmt::format("with lines lw 2 dt (8,6) lc rgb '{}' title ''", student_colors[k % 3]));
  }
  if (!overlay.misconception.empty())
    plot.explain(fmt::format("with lines lw 2 dt (8,6) lc rgb '#444444' title {}", quoted(overlay.misconception_name)));
  if (!overlay.student.empty()) {
    plot.explain("with lines lw 6 lc rgb '#BBBBBB' title 'reference'");
    plot.explain("with linespoints lw 1.5 pt 7 ps 0.6 lc rgb '#444444' title 'yours'");
  }
  return plot.script();
}

std::string lower_panel(const Overlay& overlay) {
  PlotCommand plot(overlay, "difference");
  double largest = 0.0;
  double natural_size = 0.0;
  for (std::size_t k = 0; k < overlay.labels.size(); ++k) {
    Numbers difference = overlay.student[k];
    for (std::size_t i = 0; i < difference.size(); ++i) {
      difference[i] -= overlay.reference[k][i];
      if (overlay.has_turns) difference[i] = std::remainder(difference[i], 2 * std::numbers::pi);
      if (std::isfinite(difference[i])) largest = std::max(largest, std::abs(difference[i]));
      if (std::isfinite(overlay.reference[k][i]))
        natural_size = std::max(natural_size, std::abs(overlay.reference[k][i]));
    }
    plot.add(difference, student_style(k));
  }
  // Differences smaller than rounding would fill the panel with noise.
  largest = std::max(largest, 1e-9 * (natural_size > 0 ? natural_size : 1));
  return fmt::format(
             "set yrange [{}:{}]; set ytics {}; set format y '%.2g'; set xzeroaxis lt 1 lw 1 lc rgb '#888888'\n",
             -1.1 * largest, 1.1 * largest, largest) +
         plot.script();
}

std::string labels_of(const Sweep& sweep) {
  constexpr std::size_t title_width = 72;  // a longer line is cut off at the border of the picture
  std::vector<std::string> title;
  for (const std::string& line : wrapped_lines(sweep.title, title_width)) title.push_back(quoted(line));
  return fmt::format(
      "set xrange [{}:{}]\nset title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n",
      sweep.x.front(), sweep.x.back(), fmt::join(title, ".\"\\n\"."), quoted(sweep.x_label), quoted(sweep.y_label));
}

/// The curves, and below them the difference.
std::string panels(const Overlay& overlay) {
  const std::string script =
      "set grid lc rgb '#DDDDDD' lt 1\nset border lc rgb '#444444'\nset lmargin 13; set rmargin 5\nset format x '%g'\n"
      "set offsets 0, 0, graph 0.04, graph 0.04\n"
      "set key outside top center horizontal maxrows 4 width -1\n" +  // above the curves, where it covers none of them
      labels_of(*overlay.sweep) +
      (overlay.has_whole_numbers ? "set ytics 1\n" : "");
  if (overlay.student.empty()) return script + upper_panel(overlay);
  return script + "set multiplot\nset size 1,0.68; set origin 0,0.32; set bmargin 1; set format x ''; unset xlabel\n" +
         upper_panel(overlay) +
         "unset title; unset key; set offsets; set format x '%g'\n"
         "set size 1,0.32; set origin 0,0; set tmargin 0.5; set bmargin 3.5\n" +
         fmt::format("set xlabel {} noenhanced; set ylabel 'yours − reference'\n", quoted(overlay.sweep->x_label)) +
         lower_panel(overlay) + "unset multiplot\n";
}

std::string drawn(const std::string& script, const std::string& terminal, const fs::path& directory) {
  const std::string gnuplot = program_on_path("gnuplot");
  if (gnuplot.empty()) throw std::runtime_error(gnuplot_is_missing);
  const fs::path picture_file = directory / fmt::format(".picture-{}", getpid());
  const fs::path script_file = picture_file.string() + ".gp";
  const std::string problem =
      write_file(script_file, fmt::format("set encoding utf8\nset terminal {}\nset output {}\n{}set output\n", terminal,
                                          quoted(picture_file.string()), script));
  if (!problem.empty())
    throw std::runtime_error(fmt::format("Pictures cannot be written into {} ({}).", shown_path(directory), problem));
  Launch launch;
  launch.program = gnuplot;
  launch.arguments = {"--default-settings", script_file.string()};
  launch.environment = {"PATH=" + environment("PATH"), "HOME=" + environment("HOME"), "LC_ALL=C.UTF-8"};
  // After an error gnuplot leaves half a picture; only its exit status tells.
  const FinishedProgram ran = run_program(launch, std::chrono::minutes(1), std::size_t{1} << 20);
  std::string picture = ran.succeeded() ? read_file(picture_file).value_or("") : "";
  std::error_code ignored;
  fs::remove(script_file, ignored);
  fs::remove(picture_file, ignored);
  if (picture.empty())
    throw std::runtime_error("gnuplot could not draw the plot; perhaps the values are too large for a picture.");
  return picture;
}

}  // namespace

Overlay overlay_of(const CheckResult& checked) {
  const ExerciseReference& reference = *checked.reference;
  const Sweep& sweep = reference.sweep;
  if (sweep.x.empty()) throw std::runtime_error(fmt::format("{} has no plot.", checked.name()));
  Overlay overlay;
  overlay.sweep = &sweep;
  overlay.reference = curves_of(reference, sweep.expected);
  overlay.has_whole_numbers = reference.result_kind == Kind::integer;
  overlay.has_turns = reference.comparison == Comparison::attitude_by_angles ||
                      reference.comparison == Comparison::attitude_by_yaw_pitch_roll;
  if (overlay.has_whole_numbers) overlay.jump = 0.5;
  if (std::ranges::count(reference.result_units, units::radian) > 0) overlay.jump = std::numbers::pi / 2;
  for (const PlotComponent& component : sweep.components)
    overlay.labels.push_back(as_symbol(is_sign_free(reference) ? "|" + component.name + "|" : component.name));

  std::vector<Value> values;
  for (const Reply& reply : checked.observation.sweep)
    values.push_back(reply.ending == Ending::returned ? reply.value : Value{0, 0, {}});
  if (std::ranges::count(checked.observation.sweep, Ending::returned, &Reply::ending) > 0)
    overlay.student = curves_of(reference, values);
  for (const Reason& reason : checked.reasons) {
    const auto same = std::ranges::find(reference.misconceptions, reason.name, &Misconception::name);
    if (reason.kind != ReasonKind::misconception || same == reference.misconceptions.end()) continue;
    overlay.misconception = curves_of(reference, same->sweep_outputs);
    overlay.misconception_name = same->name;
    std::ranges::replace(overlay.misconception_name, '_', ' ');
  }
  return overlay;
}

std::vector<fs::path> draw_overlay(const Overlay& overlay, const fs::path& directory, const std::string& name) {
  std::vector<fs::path> files = {directory / (name + ".svg"), directory / (name + ".png")};
  const std::array terminals = {
      "svg noenhanced size 800,640 font 'Helvetica,14' background rgb 'white'",
      // Twice the pixels, for sharp text in print and on dense screens.
      "pngcairo noenhanced size 1600,1280 font 'Helvetica,24' linewidth 2 background rgb 'white'"};
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string problem = write_file(files[i], drawn(panels(overlay), terminals[i], directory));
    if (!problem.empty())
      throw std::runtime_error(fmt::format("{} cannot be written ({}).", shown_path(files[i]), problem));
  }
  return files;
}

void add_picture(CheckResult& checked, const fs::path& directory) {
  try {
    const Overlay overlay = overlay_of(checked);
    if (overlay.student.empty()) return;
    const std::string terminal = "svg noenhanced size 640,512 font 'Helvetica,14' background rgb 'white'";
    checked.picture = base64(drawn(panels(overlay), terminal, directory));
    checked.picture_description =
        fmt::format("Plot of {}: {}. The submitted function on the reference{}; below, the difference.", checked.name(),
                    overlay.sweep->title,
                    overlay.misconception.empty() ? "" : fmt::format(" and on “{}”", overlay.misconception_name));
  } catch (const std::runtime_error&) {  // there is none
  }
}

std::string drawn_letters(const Overlay& overlay, const std::string& terminal, std::size_t columns,
                          const fs::path& directory) {
  PlotCommand plot(overlay, "letters");
  const auto letters = [](char letter, const char* color) {
    return fmt::format("with points pt '{}' lc rgb '{}'", letter, color);
  };
  const std::size_t steps = 3 * columns / overlay.sweep->x.size() + 1;
  for (std::size_t k = 0; k < overlay.labels.size(); ++k)
    plot.add(overlay.reference[k], letters(reference_letters[k % 3], letter_colors[k % 3]), steps);
  for (const Numbers& curve : overlay.misconception)
    plot.add(curve, letters(misconception_letter, "#808080"), steps / 3 + 1);
  // The student's letters come last, so that nothing hides them, and apart, so that what is below them shows.
  const std::size_t stride = std::max<std::size_t>(1, 5 * overlay.sweep->x.size() / columns);
  for (std::size_t k = 0; k < overlay.student.size(); ++k)
    plot.add(overlay.student[k],
             fmt::format("every {} with points pt '{}' lc rgb '{}'", stride, student_letter(k), letter_colors[k % 3]));
  return drawn("unset key\nset border 3\nset tics nomirror out scale 0.5\n" + labels_of(*overlay.sweep) + plot.script(),
               terminal, directory);
}

std::string meaning_of_letters(const Overlay& overlay) {
  std::string text;
  for (std::size_t k = 0; k < overlay.labels.size(); ++k) {
    const std::string yours =
        overlay.student.empty() ? "" : fmt::format("{} your {}, ", student_letter(k), overlay.labels[k]);
    text += fmt::format("{}{}{} reference{}", k == 0 ? "" : ";  ", yours, reference_letters[k % 3],
                        yours.empty() ? " " + overlay.labels[k] : "");
  }
  if (!overlay.misconception.empty())
    text += fmt::format(";  {} “{}”", misconception_letter, overlay.misconception_name);
  return text;
}

}  // namespace workbook
