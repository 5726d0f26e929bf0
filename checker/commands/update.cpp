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

int update(const Course& course, const Options& options) {
  const Release now = read_release(*options.out), before = read_release(course.root());
  if (now.number < before.number)
    throw UsageError(
        fmt::format("{} is release {}; yours is {} already.", shown_path(*options.out), now.number, before.number));
  print_update(now, before, update_copy(*options.out, now, course.root(), before));
  return all_passed;
}

}  // namespace workbook
