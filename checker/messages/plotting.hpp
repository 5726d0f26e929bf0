/// @file
/// Everything that is said about plots and figures.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace workbook::messages {

// --- plots

std::string no_plot(const std::string& exercise);
std::string gnuplot_missing_for_plot();
std::string plot_not_written(const std::string& file);
std::string plot_not_drawn(const std::string& file);
std::string folder_not_usable(const std::string& folder, const std::string& reason);
std::string say_what_to_plot(const std::string& example);
std::string all_takes_no_names();

/// `why` is the verdict's own sentence.
std::string only_reference_drawn(const std::string& exercise, const std::string& why);

/// What a drawing made of letters shows, a line for each: "A your E, . the reference".
std::string letters_of_component(const std::string& component, char yours, char reference, bool has_yours);
std::string letters_of_misconception(char letter, const std::string& misconception);

/// The label of a component in a picture.
std::string reference_label(const std::string& component);
std::string student_label(const std::string& component);
std::string difference_label();

/// What a picture shows, for those who do not see it.
std::string overlay_description(const std::string& exercise, const std::string& title,
                                const std::string& misconception);

// --- all pictures at once

std::string pictures_done(std::size_t overlays, std::size_t figures, const std::string& folder);
std::string only_references_drawn(const std::vector<std::string>& exercises);
std::string figures_of_lecture(const std::string& lecture);
std::string no_lecture_figures(const std::string& lecture);
std::string lecture_figures_not_built(const std::string& lecture);

// --- the lecture's figures with the student's own functions

std::string gnuplot_missing_for_figures();
std::string figures_need_compiling();
std::string figures_not_built(const std::string& lecture);
std::string figures_not_listed(const std::string& lecture);
std::string figure_not_started();
std::string figure_failed(const std::string& text);
std::string figure_crashed(const std::string& signal);
std::string figure_out_of_time(double seconds);
std::string figure_ended_early();
std::string figures_drawn(std::size_t drawn, std::size_t total, const std::string& lecture);

}  // namespace workbook::messages
