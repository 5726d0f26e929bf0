#include "checker/commands/commands.hpp"

namespace workbook {

void print_update(const Release& now, const Release& before, const UpdateResult& result) {
  fmt::print("Release {}, before {}: {} written.\n", now.number, before.number, plural(result.written, "file"));
  for (const ReleaseChange& change : now.changes) {
    if (change.release <= before.number) continue;
    fmt::print("  {} ({})  {}\n", change.release, printable(change.date), printable(change.message));
    for (const std::string& file : change.files) fmt::print("    {}\n", printable(file));
  }
  for (const std::string& file : result.kept) fmt::print("Your version is kept as {}.\n", printable(file));
  for (const std::string& file : result.own)
    fmt::print("{} has changed, but yours is begun and stays; `{}` writes the new one.\n", printable(file),
               command("reset " + fs::path(file).stem().string()));
}

namespace {

int update(const Course& course, const std::optional<fs::path>& newer) {
  const Release now = read_release(*newer), before = read_release(course.root());
  if (now.number < before.number)
    throw UsageError(
        fmt::format("{} is release {}; yours is {} already.", shown_path(*newer), now.number, before.number));
  print_update(now, before, update_copy(*newer, now, course.root(), before));
  return all_passed;
}

}  // namespace

Command update_command() {
  const auto options = std::make_shared<std::optional<fs::path>>();
  return {
      "update",
      students,
      "Bring your copy of the workbook to a new release\n\nFOLDER is the newer copy, unpacked somewhere else. "
      "Exercises "
      "that you have begun and files of your own stay as they are; another file that you have changed is kept under "
      ".workbook/kept. What has changed is printed.",
      {"update ../phy711-release-2"},
      {place_parameter("FOLDER", "", *options, "the folder of the new release", true)},
      with_options(options, &update)};
}

}  // namespace workbook
