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
#include <stdexcept>
#include <utility>

namespace workbook {

namespace fs = std::filesystem;

namespace {

/// What all figures share: quiet axes, a light grid, lines that stay visible in print.
constexpr const char* common_style =
    "set encoding utf8\nset minussign\n"
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
    gnuplotio::Gnuplot gnuplot(
        fmt::format("if LC_ALL=C.UTF-8 gnuplot --default-settings; then : >{}; fi", shell_quoted(complete.string())));
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
  static const std::regex color(
      R"(rgb\( *(\d+), *(\d+), *(\d+)\)|((?:color|stroke|fill) *= *)(["'])(white|black)["'])");
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

/// A text with its symbols, single letters that are neither units nor words, in the letters of the formulas.
std::string with_symbols(const std::string& text) {
  // Latin and Greek letters, and a tilde over one.
  const std::string letter = "(?:[A-Za-z]|[\xCE\xCF][\x80-\xBF])", tilde = "\xCC\x83";
  static const std::regex letters("(?:" + letter + "|" + tilde + ")+"), symbol("(d?)(" + letter + ")(" + tilde + ")?");
  static const std::regex before_units("(^|.*[0-9] |.*kg |.*[(/'’])$"), not_symbols("[smJNSEW]"), words("[Aa]|do");
  std::string result;
  auto copied = text.begin();
  for (std::sregex_iterator run(text.begin(), text.end(), letters), end; run != end; ++run) {
    std::smatch parts;
    const std::string word = run->str(), before(text.begin(), text.begin() + run->position());
    if (!std::regex_match(word, parts, symbol) || (std::regex_match(word, words) && text != word)) continue;
    if (std::regex_match(word, not_symbols) && std::regex_match(before, before_units)) continue;
    result.append(copied, text.begin() + run->position());
    result += fmt::format("{}<tspan class=\"i\">{}</tspan>", parts[1].str(), parts[2].str());
    if (parts[3].matched) result += "<tspan class=\"r\" dx=\"-0.55em\">˜</tspan>";
    copied = text.begin() + run->position() + run->length();
  }
  return std::regex_replace(result.append(copied, text.end()), std::regex(R"((^|[ (])-(?=[0-9]))"), "$1−");
}

/// All texts of a picture so; vectors, which are bold, too, and unit vectors with their hats.
std::string typeset(const std::string& svg) {
  static const std::regex piece(R"re(<tspan ([^>]*)>([^<]+)</tspan>(?=(<tspan  font-size="12.8")?))re");
  std::string result;
  auto copied = svg.begin();
  for (std::sregex_iterator found(svg.begin(), svg.end(), piece), end; found != end; ++found) {
    const std::string style = (*found)[1], text = (*found)[2];
    result.append(copied, svg.begin() + found->position());
    copied = svg.begin() + found->position() + found->length();
    if (style.find("bold") == std::string::npos)
      result += fmt::format("<tspan {}>{}</tspan>", style, with_symbols(text));
    else
      result += fmt::format("<tspan {} class=\"b\">{}</tspan>{}", style, text,
                            text == "e" && (*found)[3].matched ? "<tspan class=\"r\" dx=\"-0.5em\">ˆ</tspan>" : "");
  }
  return result.append(copied, svg.end());
}

/// Without the marks and filters that gnuplot defines in every picture and this one does not use; a later one may use
/// one before it.
std::string without_unused_names(std::string svg) {
  for (std::size_t at = svg.find("</defs>"); (at = svg.rfind(" id='", at)) != std::string::npos;) {
    const std::string name = svg.substr(at + 5, svg.find('\'', at + 5) - at - 5);
    const std::size_t start = svg.rfind('<', at);
    const std::string end = svg.compare(start, 7, "<filter") == 0 ? "</filter>\n" : "/>\n";
    at = start;
    if (svg.find("#" + name + "'") == std::string::npos && svg.find("#" + name + ")") == std::string::npos)
      svg.erase(start, svg.find(end, start) + end.size() - start);
  }
  return svg;
}

/// The picture without what only a file of its own needs, and with names that no other picture of the page has.
std::string for_a_page(std::string svg, const std::string& name, FigureSize size) {
  svg.erase(0, svg.find("<svg"));
  const std::array<std::pair<const char*, std::string>, 10> changes{{
      {R"(<title>[^<]*</title>(\s*<desc>[^<]*</desc>)?)", ""},
      {R"( stroke-linecap="butt" stroke-linejoin="miter")", ""},
      {R"(<g [^>]*>\s*</g>)", ""},
      {R"re(<g id="[^"]*_plot_[^"]*" >)re", "<g>"},
      // Tenths of a pixel suffice; texts keep all their digits.
      {R"((>[^<]*<)|(\.\d)\d(?=[ ,']))", "$1$2"},
      {R"( L(?=[-\d]))", " "},
      {R"( font-family="[^"]*")", ""},
      {R"((id=['"]|href=['"]#|url\(#)(gp|textbox|greybox|gnuplot))", "$1" + name + "-$2"},
      {"^<svg",
       fmt::format(
           R"(<svg aria-hidden="true" style="max-width:{}px;min-width:{}px" font-family="Helvetica, Arial, sans-serif")",
           size.width, size.width * 6 / 10)},
      {R"(\n\s*)", "\n"},
  }};
  for (const auto& [pattern, text] : changes) svg = std::regex_replace(svg, std::regex(pattern), text);
  svg = without_unused_names(std::move(svg));
  return with_variables(typeset(svg));
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

std::string name_of_color(const std::string& color) {
  const auto name = names_of_colors.find(color.substr(std::min<std::size_t>(1, color.size())));
  return name == names_of_colors.end() ? color : name->second;
}

void draw_figure(const fs::path& directory, const std::string& name, FigureSize size,
                 const std::function<void(gnuplotio::Gnuplot&)>& draw, const std::string& description) {
  std::string svg = svg_for_page(directory, name, size, draw);
  if (!description.empty()) svg.insert(svg.find('>') + 1, "<metadata>" + description + "</metadata>");
  write_text(directory / (name + ".svg"), svg);
  draw_png(directory, name, size, draw);
}

}  // namespace workbook
