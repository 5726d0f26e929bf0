#include "lectures/support/figure.hpp"

#include <rigid/vocabulary.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <utility>

namespace workbook {

namespace fs = std::filesystem;

namespace {

/// What all figures share: quiet axes, a light grid, lines that stay visible in print.
constexpr const char* common_style =
    "set encoding utf8\n"
    "set border lc rgb '#444444'\n"
    "set grid lc rgb '#CFD8DD' lt 1\n"
    "set key opaque box lc rgb '#CFD8DD'\n"
    "set tics textcolor rgb '#222222'\n"
    "set style textbox opaque noborder fillcolor rgb 'white' margins 0.4,0.3\n";

/// The style sheet's name for each colour.
const std::map<std::string, std::string> names_of_colors{
    {"FFFFFF", "paper"}, {"000000", "ink"},       {"222222", "ink"},    {"333333", "ink"},
    {"444444", "ink"},   {"555555", "grey"},      {"5F6B73", "grey"},   {"CFD8DD", "pale"},
    {"DDDDDD", "pale"},  {"EEF1F3", "shade"},     {"0068A8", "blue"},   {"4C9FD0", "sky"},
    {"00734F", "green"}, {"B84300", "vermilion"}, {"8A5A00", "orange"}, {"A3427F", "purple"}};

/// Text inside the shell's single quotes.
std::string shell_quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? "'\\''" : std::string(1, letter);
  return result + "'";
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(fmt::format("{} cannot be written", file.string()));
}

void run_gnuplot(const fs::path& file, const std::string& terminal,
                 const std::function<void(gnuplotio::Gnuplot&)>& draw) {
  fs::remove(file);
  // After an error gnuplot goes on and leaves half a picture. Only its exit status tells, and the library drops it:
  // so the shell writes this file where all went well.
  const fs::path complete = file.string() + ".complete";
  {
    gnuplotio::Gnuplot gnuplot(fmt::format("if LC_ALL=C.UTF-8 gnuplot --default-settings; then : >{}; fi",
                                           shell_quoted(complete.string())));
    gnuplot << "set terminal " << terminal << "\nset output '" << file.string() << "'\n" << common_style;
    draw(gnuplot);
    gnuplot << "\nset output\n";
  }
  if (!fs::remove(complete) || !fs::exists(file) || fs::file_size(file) == 0) {
    fs::remove(file);
    throw std::runtime_error(fmt::format("gnuplot could not draw {}: is it installed, and is every number finite?",
                                         file.filename().string()));
  }
}

/// gnuplot's colours as variables of the page's style sheet, each with its light value for readers without one.
std::string with_variables(const std::string& svg) {
  static const std::regex color(R"(rgb\( *(\d+), *(\d+), *(\d+)\)|(color=|stroke=|fill=)(["'])(white|black)["'])");
  std::string result;
  auto copied = svg.begin();
  for (std::sregex_iterator match(svg.begin(), svg.end(), color), end; match != end; ++match) {
    const auto& part = *match;
    const std::string code = part[6] == "white"   ? "FFFFFF"
                             : part[6] == "black" ? "222222"
                                                  : fmt::format("{:02X}{:02X}{:02X}", std::stoi(part[1]),
                                                                std::stoi(part[2]), std::stoi(part[3]));
    const auto name = names_of_colors.find(code);
    if (name == names_of_colors.end()) continue;
    const std::string variable = fmt::format("var(--figure-{},#{})", name->second, code);
    result.append(copied, svg.begin() + part.position());
    result += part[6].matched ? part[4].str() + part[5].str() + variable + part[5].str() : variable;
    copied = svg.begin() + part.position() + part.length();
  }
  return result.append(copied, svg.end());
}

/// The picture without what only a file of its own needs, and with names that no other picture of the page has.
std::string for_a_page(std::string svg, const std::string& name, FigureSize size) {
  svg.erase(0, svg.find("<svg"));
  const std::array<std::pair<const char*, std::string>, 7> changes{{
      {R"(<title>[^<]*</title>(\s*<desc>[^<]*</desc>)?)", ""},
      {R"( stroke-linecap="butt" stroke-linejoin="miter")", ""},
      {R"(<g [^>]*>\s*</g>)", ""},
      {R"( font-family="[^"]*")", ""},
      {R"((id=['"]|href=['"]#|url\(#)(gp|textbox|greybox|gnuplot))", "$1" + name + "-$2"},
      {"^<svg",
       fmt::format(
           R"(<svg aria-hidden="true" style="max-width:{}px;min-width:{}px" font-family="Helvetica, Arial, sans-serif")",
           size.width, size.width * 6 / 10)},
      {R"(\n\s*)", "\n"},
  }};
  for (const auto& [pattern, text] : changes) svg = std::regex_replace(svg, std::regex(pattern), text);
  return with_variables(svg);
}

/// One picture as SVG for a page.
std::string svg_for_page(const fs::path& directory, const std::string& name, FigureSize size,
                         const std::function<void(gnuplotio::Gnuplot&)>& draw) {
  const fs::path file = directory / (name + ".svg");
  run_gnuplot(file,
              fmt::format("svg enhanced size {},{} fixed font 'Helvetica,16' name '{}'", size.width, size.height, name),
              draw);
  return for_a_page(text_of(file), name, size);
}

/// The groups at the top level of a picture.
std::vector<std::string> groups_of(const std::string& picture) {
  std::vector<std::string> groups;
  int depth = 0;
  std::size_t start = 0;
  for (std::size_t at = picture.find('<'); at != std::string::npos; at = picture.find('<', at + 1)) {
    if (picture.compare(at, 3, "<g ") == 0) ++depth;
    if (picture.compare(at, 4, "</g>") != 0 || --depth > 0) continue;
    groups.push_back(picture.substr(start, at + 4 - start));
    start = at + 4;
  }
  return groups;
}

void draw_png(const fs::path& directory, const std::string& name, FigureSize size,
              const std::function<void(gnuplotio::Gnuplot&)>& draw) {
  // Twice the pixels, for sharp text in print and on dense screens; a point of a font has 4/3 pixels.
  run_gnuplot(directory / (name + ".png"),
              fmt::format("pngcairo enhanced size {},{} font 'Helvetica,12' fontscale 2 linewidth 2 pointscale 2 "
                          "background rgb 'white'",
                          2 * size.width, 2 * size.height),
              draw);
}

}  // namespace

int draw_figures(int argc, char** argv, const std::vector<Figure>& figures) {
  // gnuplot may end before we have told it everything; that is a figure that failed, not the end of the program.
  std::signal(SIGPIPE, SIG_IGN);
  const std::string first = argc > 1 ? argv[1] : "";
  if (argc == 2 && first == "--list") {
    for (const Figure& figure : figures) fmt::print("{}\n", figure.name);
    return figures_drawn;
  }
  const std::string wanted = argc == 3 ? argv[2] : "";
  const bool known = wanted.empty() || std::any_of(figures.begin(), figures.end(),
                                                   [&](const Figure& figure) { return figure.name == wanted; });
  if (argc < 2 || argc > 3 || !known) {
    fmt::print(stderr, "usage: {} DIRECTORY [FIGURE], or --list\nDraws the figures of the lecture into DIRECTORY.\n",
               argv[0]);
    return figure_wrong_usage;
  }
  FigureStatus worst = figures_drawn;
  const auto fails = [&](const Figure& figure, FigureStatus status, const std::string& why) {
    if (worst != figure_failed) worst = status;
    std::fflush(stdout);
    fmt::print(stderr, "{}: {}\n", figure.name, why);
  };
  for (const Figure& figure : figures) {
    if (!wanted.empty() && figure.name != wanted) continue;
    try {
      fs::create_directories(first);
      figure.draw(first);
    } catch (const rigid::NotStarted& missing) {
      fails(figure, figure_not_started, fmt::format("needs {} (not started)", missing.function));
    } catch (const std::exception& problem) {
      fails(figure, figure_failed, problem.what());
    } catch (...) {
      fails(figure, figure_failed, "something was thrown that is no std::exception");
    }
  }
  return worst;
}

void draw_figure(const fs::path& directory, const std::string& name, FigureSize size,
                 const std::function<void(gnuplotio::Gnuplot&)>& draw) {
  write_text(directory / (name + ".svg"), svg_for_page(directory, name, size, draw));
  draw_png(directory, name, size, draw);
}

void draw_animation(const fs::path& directory, const std::string& name, FigureSize size, int frames, int still,
                    const std::function<void(gnuplotio::Gnuplot&, int frame)>& draw) {
  std::string head;
  std::vector<std::vector<std::string>> pictures;
  std::map<std::string, int> frames_with;  // a group
  for (int frame = 0; frame < frames; ++frame) {
    const std::string svg =
        svg_for_page(directory, name, size, [&](gnuplotio::Gnuplot& gnuplot) { draw(gnuplot, frame); });
    // The canvas is opened before the definitions and closed at the end.
    const std::size_t body = svg.find("</defs>") + 7;
    head = svg.substr(0, body);
    // Elements of one frame need no name, and would have the same in every frame.
    pictures.push_back(
        groups_of(std::regex_replace(svg.substr(body, svg.rfind("</g>") - body), std::regex(R"( id="[^"]*")"), "")));
    for (const std::string& group : std::set(pictures.back().begin(), pictures.back().end())) ++frames_with[group];
  }
  const auto joined = [&](const std::vector<std::string>& groups, bool moving) {
    std::string text;
    for (const std::string& group : groups)
      if ((frames_with[group] < frames) == moving) text += group;
    return text;
  };
  std::string svg = head + joined(pictures.front(), false);
  for (int frame = 0; frame < frames; ++frame)
    svg += fmt::format("<g class=\"frame\"{}>{}</g>", frame == still ? "" : " style=\"display:none\"",
                       joined(pictures[static_cast<std::size_t>(frame)], true));
  write_text(directory / (name + ".svg"), svg + "</g></svg>\n");
  draw_png(directory, name, size, [&](gnuplotio::Gnuplot& gnuplot) { draw(gnuplot, still); });
}

}  // namespace workbook
