// The general code below the judge: text, files, and work in a process of its own.
#include "checker/base/child_process.hpp"
#include "checker/base/files.hpp"
#include "checker/base/formulas.hpp"
#include "checker/base/text.hpp"
#include "tests/support/files.hpp"

#include <doctest/doctest.h>

#include <signal.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <thread>

namespace workbook::testing {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Lines = std::vector<std::string>;
using Texts = std::vector<std::pair<std::string, std::string>>;

/// An empty folder.
fs::path scratch() {
  fs::path folder = fs::path(WORKBOOK_TEST_SCRATCH) / "files";
  std::error_code ignored;
  fs::permissions(folder / "locked", fs::perms::owner_all, ignored);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// True if this process has no child, running or ended.
bool has_no_child() { return ::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD; }

/// A job inherits the handlers of signals, and those of doctest would report a failure.
void use_default_signals() {
  for (const int number : {SIGTERM, SIGSEGV}) ::signal(number, SIG_DFL);
}

std::string sleep_for_ever() {
  for (;;) std::this_thread::sleep_for(1s);
}

}  // namespace

TEST_CASE("Control and bidirectional characters, and what is no UTF-8, become question marks") {
  for (const auto& [text, shown] :
       Texts{{"ω = ½ “rad/s”\tα\n≠ 𝛼", "ω = ½ “rad/s”\tα\n≠ 𝛼"},
             {"\x1b[31mred\x07\b\x7f", "?[31mred???"},
             {std::string("a\0b", 3), "a?b"},
             {"a control character of two bytes: \xc2\x9b", "a control character of two bytes: ?"},
             {"\u202e\u202a\u2066\u2069\u200e\u200f\u061c", "???????"},
             {"overlong \xc0\xaf, half a pair \xed\xa0\x80", "overlong ??, half a pair ???"},
             {"\x80|\xff|\xe2|", "?|?|?|"},
             {"cut in a character \xe2\x89", "cut in a character "}}) {
    CHECK(printable(text) == shown);
    CHECK(printable(shown) == shown);
  }
}

TEST_CASE("A text is never cut inside a character") {
  const std::string text = "𝛼≠ωa";
  for (std::size_t bytes = 0; bytes <= text.size() + 1; ++bytes) {
    const std::string begin = cut(text, bytes);
    CHECK(begin.size() <= bytes);
    CHECK(begin.size() + 4 > std::min(bytes, text.size()));
    CHECK(text.starts_with(begin));
    CHECK(printable(begin) == begin);
  }
}

TEST_CASE("Widths are counted in columns, not in bytes; text is wrapped between words and at its line ends") {
  CHECK(display_width("≠ m²") == 4);
  CHECK(shortened("≠ m²", 4) == "≠ m²");
  CHECK(shortened("≠ m²/s", 4) == "≠ m…");
  CHECK(shortened("abc", 1) == "…");
  CHECK(shortened("abc", 0).empty());
  CHECK(padded("ω", 3) + padded_left("ω", 3) + padded("abc", 2) == "ω    ωabc");
  CHECK(lines_of("a\r\nb\n\nc") == Lines{"a", "b", "", "c"});
  CHECK(lines_of("a\n") == Lines{"a"});
  CHECK(wrapped_lines("", 10).empty());
  CHECK(wrapped_lines("one two  three", 7) == Lines{"one two", "three"});
  CHECK(wrapped_lines("ω ω ω ω", 3) == Lines{"ω ω", "ω ω"});
  CHECK(wrapped_lines("one\n\ntwo", 10, 2) == Lines{"  one", "", "  two"});
  CHECK(wrapped_lines("a word-that-does-not-fit b", 8, 2) == Lines{"  a", "  word-that-does-not-fit", "  b"});
}

TEST_CASE("Words are quoted so that a shell reads them back") {
  for (const char* word : {"lectures/01_frames/a-b.cpp", "", "my file", "it's", "''", "$HOME", "`id`", "a;b", "a&b",
                           "~", "*", "a\nb", "#", "ω", "!x", "\\", "\"", "(x)", "a|b>c"}) {
    const fs::path said = scratch() / "said";
    CHECK(run_in_shell("printf %s " + shell_quoted(word) + " > " + shell_quoted(said.string())) == 0);
    CHECK(read(said) == word);
  }
}

TEST_CASE("A fingerprint and base64 agree with their published test vectors") {
  CHECK(fingerprint("") == "cbf29ce484222325");
  CHECK(fingerprint("foobar") == "85944171f73967e8");
  CHECK(base64("") + base64("f") + base64("fo") + base64("foo") + base64("\xfb\xff\xfe") == "Zg==Zm8=Zm9v+//+");
}

TEST_CASE("A pattern fits within a line, and its ends are those of the text; what does not fit is no match") {
  CHECK(workbook::search("ab\ncd", "a.*d").groups.empty());
  CHECK(workbook::search("ab\ncd", "a[^]*d")[0] == "ab\ncd");
  CHECK(workbook::search_all("ab\nab", "^ab").size() == 1);
  CHECK(workbook::search("", "^x$").groups.empty());
  CHECK(workbook::search("aaaaaaa", "^(a)(b)?").groups == std::vector<std::string>{"a", "a", ""});
  CHECK(workbook::replaced("a\nb", "$", ".") == "a\nb.");
}

TEST_CASE("A file is written whole, over the old one, and its folder made") {
  const fs::path folder = scratch();
  const fs::path file = folder / "new" / "and newer" / "file.txt";
  const std::string bytes("a\0b\r\n\xff", 6);
  for (const std::string& content : {std::string("old"), bytes, std::string()}) {
    CHECK(write_file(file, content).empty());
    CHECK(read_file(file) == content);
    CHECK(file_fingerprint(file) == fingerprint(content));
  }
  CHECK(files_below(folder).size() == 1);
}

TEST_CASE("A file that cannot be written keeps its old content, and the reason is told") {
  const fs::path folder = scratch();
  write(folder / "file", "old");
  write(folder / "locked" / "file", "old");
  fs::create_directories(folder / "occupied" / "something");
  fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  CHECK_FALSE(write_file(folder / "file" / "below", "new").empty());
  CHECK_FALSE(write_file(folder / "occupied", "new").empty());
  CHECK_FALSE(write_file(folder / std::string(300, 'x'), "new").empty());
  if (::geteuid() != 0) CHECK_FALSE(write_file(folder / "locked" / "file", "new").empty());  // root may
  fs::permissions(folder / "locked", fs::perms::owner_all);
  for (const fs::path& file : files_below(folder)) {
    CHECK(file.filename() == "file");
    CHECK(read_file(file) == "old");
  }
}

TEST_CASE("A half-written file is removed when its writer is gone, and what looks alike stays") {
  const fs::path folder = scratch();
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  REQUIRE(::waitpid(gone, nullptr, 0) == gone);
  const auto named = [&](const auto& writer) { return folder / "below" / fmt::format("page.{}.unfinished", writer); };
  for (const fs::path& file : {named(gone), named(::getpid()), named("no number"), folder / "x.unfinished"})
    write(file, "half");
  remove_unfinished(folder);
  remove_unfinished(folder / "nowhere");
  CHECK(!fs::exists(named(gone)));
  for (const fs::path& file : {named(::getpid()), named("no number"), folder / "x.unfinished"}) CHECK(fs::exists(file));
}

TEST_CASE("Only regular files up to the limit are read") {
  const fs::path folder = scratch();
  write(folder / "ten", "0123456789");
  CHECK(read_file(folder / "ten", 10) == "0123456789");
  CHECK_FALSE(read_file(folder / "ten", 9).has_value());
  CHECK_FALSE(read_file(folder / "missing").has_value());
  CHECK_FALSE(read_file(folder).has_value());
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_FALSE(read_file(folder / "pipe").has_value());  // and nobody waits for a writer
  CHECK_FALSE(read_file("/dev/zero", 100).has_value());
  CHECK_FALSE(read_file("/proc/self/stat", 1).has_value());  // it says that it is empty, and is not
  CHECK(file_fingerprint(folder / "missing").empty());
}

TEST_CASE("A name that is taken is counted on, and shown from the current folder") {
  const fs::path file = scratch() / "mine.cpp";
  write(file, "");
  fs::create_symlink("nowhere", file.string() + ".2");
  CHECK(free_name(file) == file.string() + ".3");
  CHECK(shown_path(fs::current_path() / "a" / "b\x1b.cpp") == "a/b?.cpp");
}

TEST_CASE("A folder is newer by what is in it, not by its own time, which any file that came and went has set") {
  const fs::path folder = scratch() / "sources", source = folder / "below" / "source.cpp", made = scratch() / "made";
  write(source, "old");
  write(made, "of it");
  const auto now = fs::last_write_time(made);
  for (const fs::path& old : {source, folder / "below"}) fs::last_write_time(old, now - 60s);
  fs::last_write_time(folder, now + 60s);
  CHECK_FALSE(is_newer(folder, made));
  CHECK_FALSE(is_newer(source, made));
  fs::last_write_time(source, now + 60s);
  CHECK(is_newer(folder, made));
  CHECK(is_newer(source, made));
  CHECK(is_newer(source, scratch() / "missing"));
}

TEST_CASE("A folder below that may not be read, or is gone, is no newer one") {
  const fs::path folder = fs::temp_directory_path() / ("workbook-sources-" + std::to_string(::getpid()));
  write(folder / "locked" / "source.cpp", "");
  const fs::path made = write(folder / "made", "of it");
  fs::permissions(folder / "locked", fs::perms::none);
  ForkedJob job(
      [&]() -> std::string {
        if (::geteuid() == 0) become_user(65534);
        return is_newer(folder, made) ? "newer" : "not newer";
      },
      60s);
  CHECK(job.finish().empty());
  CHECK(job.output() == "not newer");
  CHECK_FALSE(is_newer(folder / "gone", made));
  fs::permissions(folder / "locked", fs::perms::owner_all);
  fs::remove_all(folder);
}

TEST_CASE("A job that gives up root still ends with its parent" * doctest::skip(::geteuid() != 0)) {
  ForkedJob job(
      [] {
        int signal = 0;
        const bool is_another = become_user(65534);
        ::prctl(PR_GET_PDEATHSIG, &signal);
        return is_another && ::getuid() == 65534 && signal == SIGTERM ? "tied" : "free";
      },
      60s);
  CHECK(job.finish().empty());
  CHECK(job.output() == "tied");
}

TEST_CASE("Formulas in TeX become text for a terminal") {
  const auto formula = [](const std::string& tex) { return with_readable_formulas("\\f$ " + tex + " \\f$"); };
  const std::vector<std::pair<const char*, const char*>> formulas = {
      {R"(T = \tfrac12\,\vec\omega\cdot\Inertia\cdot\vec\omega)", "T = (1/2) ω·I·ω\n"},
      {R"(\frac{a + b}{2c})", "(a + b)/2c\n"},
      {R"(\frac{a}{b}\sin\theta)", "(a/b) sin θ\n"},
      {R"(\dot{\tilde\omega}_1)", "\u03c9\u0303\u0307₁\n"},
      {R"(n^{-1} + x_{kl}^2 - e^{-\gamma t})", "n⁻¹ + x_kl² − e^(−γ t)\n"},
      {R"(\mat A\T\vec v\times\unit z)", "Aᵀv × z\u0302\n"},
      {R"(\begin{pmatrix} a & b \\[2pt] c & d \end{pmatrix})", "( a, b; c, d )\n"},
      {R"(\sqrt{a^2 + b^2}\le\ell)", "√(a² + b²) ≤ ℓ\n"},
      {R"(\ratein{\vec V}{\inertialframe})", "(dV/dt)_inertial\n"},
      {R"(\left[\text{a b}\right\}\!c)", "[a b}c\n"}};
  for (const auto& [tex, text] : formulas) CHECK_MESSAGE(formula(tex) == text, tex);
  CHECK(with_readable_formulas("# One\n\nA line\nand \\ref there \"another\":\n\\f[ a \\\\ b \\f]\n- a point\n") ==
        "# One\n\nA line and another:\n\n    a\n    b\n\n- a point\n");
}

TEST_CASE("The address of a file is one word, whatever its folders are called") {
  CHECK(file_address("/a folder/ü#1.html") == "file:///a%20folder/%C3%BC%231.html");
}

TEST_CASE("A job hands back its bytes, however many, and changes nothing here") {
  use_default_signals();
  int calls = 0;
  for (const std::string& bytes : {std::string(), std::string("a\0\n\xff", 4), std::string(1 << 22, 'x')}) {
    ForkedJob job([&] { return ++calls == 1 ? bytes : "again"; }, 60s);
    CHECK(job.finish().empty());
    CHECK(job.output() == bytes);
  }
  ForkedJob sleeping(sleep_for_ever, 60s);
  ForkedJob other([](const ForkedJob::Send& send) { return send("begin, "), "end"; }, 60s);  // does not wait for it
  CHECK(other.finish().empty());
  CHECK(other.output() == "begin, end");
  CHECK_FALSE(sleeping.collect());
}

TEST_CASE("A job that crashes, throws, exits or runs for too long says so, and none outlives its object") {
  use_default_signals();
  const std::vector<std::function<std::string()>> works = {
      [] { return ::raise(SIGSEGV), ""; }, []() -> std::string { throw std::runtime_error("no"); },
      []() -> std::string { throw 1; }, []() -> std::string { ::_exit(3); }, sleep_for_ever};
  for (const auto& work : works) {
    ForkedJob job(work, &work == &works.back() ? 50ms : 60s);
    CHECK_FALSE(job.finish().empty());
    CHECK(job.output().empty());
    CHECK(has_no_child());
  }
  for (const auto& handler : {SIG_DFL, SIG_IGN}) {  // the second refuses to be asked
    ::signal(SIGTERM, handler);
    { const ForkedJob job(sleep_for_ever, 60s); }
    CHECK(has_no_child());
  }
  use_default_signals();
}

}  // namespace workbook::testing
