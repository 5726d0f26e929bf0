#include "tests/site/browser.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <thread>

namespace workbook::site {

using nlohmann::json;

namespace {

constexpr std::chrono::seconds patience{300};  // on a busy machine too: only what hangs is ended

/// The two descriptors at which Chromium expects its commands and writes its answers.
constexpr int commands = 3;
constexpr int answers = 4;

/// In the child: never returns.
[[noreturn]] void become_chromium(const std::filesystem::path& chromium, const std::filesystem::path& profile,
                                  int read_end, int write_end) {
  // A group of its own, so that all of its processes can be ended.
  ::setpgid(0, 0);
  // Out of the way first: either end may happen to be 3 or 4.
  const int from = ::fcntl(read_end, F_DUPFD, 10);
  const int to = ::fcntl(write_end, F_DUPFD, 10);
  ::dup2(from, commands);
  ::dup2(to, answers);
  ::closefrom(5);
  const int null = ::open("/dev/null", O_RDWR);
  for (int standard : {0, 1, 2}) ::dup2(null, standard);
  const std::string profile_option = "--user-data-dir=" + profile.string();
  const std::array<const char*, 15> arguments{
      chromium.c_str(), "--headless", "--remote-debugging-pipe", profile_option.c_str(),
      // Chromium's sandbox does not work for root in a container; the pages are our own.
      "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--no-first-run", "--disable-extensions",
      // What is drawn in space is drawn by the processor.
      "--enable-unsafe-swiftshader", "--disable-background-networking", "--disable-component-update", "--disable-sync",
      // Whatever a page asks for, no other machine is found.
      "--host-resolver-rules=MAP * ~NOTFOUND", nullptr};
  ::execv(chromium.c_str(), const_cast<char* const*>(arguments.data()));
  ::_exit(127);
}

}  // namespace

Browser::Browser(const std::filesystem::path& chromium) {
  if (::access(chromium.c_str(), X_OK) != 0) {
    throw BrowserError(fmt::format("{} cannot be started: install the package chromium.", chromium.string()));
  }
  // A browser that dies while we write is an error to report, not the end of the test.
  ::signal(SIGPIPE, SIG_IGN);
  std::string profile = (std::filesystem::temp_directory_path() / "notes-browser-XXXXXX").string();
  int to[2], from[2];
  if (::mkdtemp(profile.data()) == nullptr || ::pipe2(to, O_CLOEXEC) != 0 || ::pipe2(from, O_CLOEXEC) != 0) {
    throw BrowserError("No temporary folder or no pipe for Chromium.");
  }
  profile_ = profile;
  process_ = ::fork();
  if (process_ == 0) become_chromium(chromium, profile_, to[0], from[1]);
  ::close(to[0]);
  ::close(from[1]);
  to_browser_ = to[1];
  from_browser_ = from[0];
  try {
    const std::string target = send("Target.createTarget", {{"url", "about:blank"}}, "")["targetId"];
    session_ = send("Target.attachToTarget", {{"targetId", target}, {"flatten", true}}, "")["sessionId"];
    for (const char* domain : {"Page", "Network", "Runtime", "Log"}) call(fmt::format("{}.enable", domain));
  } catch (...) {
    stop();
    throw;
  }
}

Browser::~Browser() { stop(); }

void Browser::stop() {
  // The end of its input ends a browser on a pipe; the signal is for one that hangs.
  ::close(to_browser_);
  ::close(from_browser_);
  int status = 0;
  for (int tries = 0; tries < 30 && ::waitpid(process_, &status, WNOHANG) == 0; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  if (::kill(-process_, SIGKILL) == 0) ::waitpid(process_, &status, 0);
  std::error_code ignored;
  std::filesystem::remove_all(profile_, ignored);
}

json Browser::receive(const std::string& awaited) {
  std::size_t end;
  while ((end = unread_.find('\0')) == std::string::npos) {
    pollfd ready{from_browser_, POLLIN, 0};
    const int count = ::poll(&ready, 1, static_cast<int>(std::chrono::milliseconds(patience).count()));
    if (count < 0 && errno == EINTR) continue;
    if (count == 0)
      throw BrowserError(fmt::format("Chromium did not answer {} within {} seconds.", awaited, patience.count()));
    std::array<char, 65536> buffer;
    const ssize_t length = count < 0 ? -1 : ::read(from_browser_, buffer.data(), buffer.size());
    if (length <= 0) throw BrowserError("Chromium ended unexpectedly.");
    unread_.append(buffer.data(), static_cast<std::size_t>(length));
  }
  json message = json::parse(unread_.begin(), unread_.begin() + static_cast<std::ptrdiff_t>(end));
  unread_.erase(0, end + 1);
  return message;
}

json Browser::send(const std::string& method, const json& parameters, const std::string& session) {
  json request{{"id", ++last_id_}, {"method", method}, {"params", parameters}};
  if (!session.empty()) request["sessionId"] = session;
  const std::string text = request.dump();
  // The terminating zero belongs to the message.
  for (std::size_t sent = 0; sent < text.size() + 1;) {
    const ssize_t length = ::write(to_browser_, text.c_str() + sent, text.size() + 1 - sent);
    if (length < 0 && errno == EINTR) continue;
    if (length < 0) throw BrowserError("Chromium ended unexpectedly.");
    sent += static_cast<std::size_t>(length);
  }
  while (true) {
    json message = receive(method);
    if (!message.contains("id")) {
      events_.push_back(std::move(message));
    } else if (message["id"] == last_id_) {
      if (message.contains("error")) {
        throw BrowserError(
            fmt::format("Chromium refused {}: {}", method, message["error"]["message"].get<std::string>()));
      }
      return message["result"];
    }
  }
}

json Browser::call(const std::string& method, const json& parameters) { return send(method, parameters, session_); }

json Browser::evaluate(const std::string& expression) {
  const json result =
      call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
  if (result.contains("exceptionDetails")) {
    const json& details = result["exceptionDetails"];
    throw BrowserError("The script in the page failed: " +
                       details.value("/exception/description"_json_pointer, details.value("text", "no reason given")));
  }
  return result["result"].value("value", json());
}

bool Browser::happened(const std::string& event) const {
  return std::ranges::any_of(events_, [&](const json& happening) { return happening["method"] == event; });
}

void Browser::open(const std::string& url) {
  std::erase_if(events_, [](const json& event) { return event["method"] == "Page.loadEventFired"; });
  const json result = call("Page.navigate", {{"url", url}});
  if (result.contains("errorText")) {
    throw BrowserError(fmt::format("{} cannot be opened: {}", url, result["errorText"].get<std::string>()));
  }
  while (!happened("Page.loadEventFired")) {
    json message = receive("the opening of " + url);
    if (!message.contains("id")) events_.push_back(std::move(message));
  }
}

std::vector<json> Browser::take_events() { return std::exchange(events_, {}); }

}  // namespace workbook::site
