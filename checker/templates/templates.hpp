/// @file
/// Pages and files for other programs, made from templates of mustache: report/pages and grading/forms.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace workbook {

/// The template of mustache with that name, or what else a page holds. They are part of the program, which then works
/// wherever it is copied and never meets a template of another version.
const std::string& page_template(const std::string& name);

/// A page made from a template. All text of the document is text on the page, without control characters.
/// @param raw  what the template takes unescaped, by name. @throws std::logic_error if it is no template
std::string rendered_page(const std::string& page_template, const nlohmann::json& document,
                          const std::map<std::string, std::string>& raw = {});
/// The same for other files: text is escaped as JSON has it in strings, but for XML where the file's name says so.
std::string filled_text(const std::string& file_template, const std::filesystem::path& name,
                        const nlohmann::json& values);

}  // namespace workbook
