#include "checker/templates/templates.hpp"

#include "checker/base/text.hpp"
#include "checker/course/assignment.hpp"

#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace workbook {

namespace {

using kainjow::mustache::data;
using nlohmann::json;

/// Everything that goes into the template passes here: valid text without control characters. The template escapes it.
/// What is empty opens no section. Each object of a list but the first has a "comma".
data for_template(const json& value) {
  if (value.is_object()) {
    data object;
    for (const auto& [name, part] : value.items()) object.set(name, for_template(part));
    return object;
  }
  if (value.is_boolean()) return data(value.get<bool>());
  if (value.is_array()) {
    data list{data::type::list};
    for (const json& part : value) {
      data entry = for_template(part);
      if (part.is_object() && list.is_non_empty_list()) entry.set("comma", ", ");
      list << entry;
    }
    return list;
  }
  if (value.is_null()) return data(false);
  if (value.is_number()) return data(fmt::format("{:.10g}", value.get<double>()));
  std::string text = value.get<std::string>();
  std::erase(text, '\r');
  return text.empty() ? data(false) : data(printable(text));
}

std::string rendered(kainjow::mustache::mustache& form, const data& values) {
  std::string text = form.render(values);
  if (!form.is_valid()) throw std::logic_error("the page has no usable template: " + form.error_message());
  return text;
}

}  // namespace

std::string rendered_page(const std::string& page_template, const json& document,
                          const std::map<std::string, std::string>& raw) {
  data values = for_template(document);
  for (const auto& [name, text] : raw) values.set(name, text);
  kainjow::mustache::mustache form(page_template);
  return rendered(form, values);
}

std::map<std::filesystem::path, std::string> filled_texts(const std::map<std::filesystem::path, std::string>& templates,
                                                          const json& values) {
  const data filled_in = for_template(values);
  std::map<std::filesystem::path, std::string> texts;
  for (const auto& [name, file_template] : templates) {
    kainjow::mustache::mustache form(file_template);
    const bool is_table = name.extension() == ".csv";
    if (is_table)
      form.set_custom_escape([](const std::string& text) {
        const std::string row = write_csv({{text}});
        return row.substr(0, row.size() - 2);
      });
    else if (name.extension() != ".xml" && name.extension() != ".html")
      form.set_custom_escape([](const std::string& text) {
        const std::string quoted = json(text).dump();
        return quoted.substr(1, quoted.size() - 2);
      });
    std::string& text = texts[name] = rendered(form, filled_in);
    if (!is_table) continue;
    std::string rows;  // the template leaves empty lines
    for (const std::string& line : lines_of(text)) rows += line.empty() ? "" : line + "\r\n";
    text = rows;
  }
  return texts;
}

std::map<std::filesystem::path, std::string> filled_forms(const std::vector<const char*>& names, const json& values) {
  std::map<std::filesystem::path, std::string> templates;
  for (const char* name : names) templates[name] = page_template(name);
  return filled_texts(templates, values);
}

}  // namespace workbook
