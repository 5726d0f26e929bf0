/// @file
/// A headless Chromium, driven over a pipe by the DevTools protocol: no port, no driver, no server.
#pragma once

#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace workbook::site {

struct BrowserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Browser {
 public:
  /// Starts Chromium with an empty profile and no way to any other machine.
  /// @throws BrowserError when it does not start.
  explicit Browser(const std::filesystem::path& chromium);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Calls a method of the one tab and returns its result.
  /// @throws BrowserError when Chromium refuses, dies or does not answer.
  nlohmann::json call(const std::string& method, const nlohmann::json& parameters = nlohmann::json::object());

  /// The value of a JavaScript expression in the page; a promise is awaited.
  nlohmann::json evaluate(const std::string& expression);

  /// Opens a page and waits until it has loaded.
  void open(const std::string& url);

  /// What happened in the tab since the last call: events as the protocol words them.
  std::vector<nlohmann::json> take_events();

 private:
  nlohmann::json send(const std::string& method, const nlohmann::json& parameters, const std::string& session);
  nlohmann::json receive(const std::string& awaited);
  bool happened(const std::string& event) const;
  void stop();

  int to_browser_ = -1;
  int from_browser_ = -1;
  int process_ = -1;
  int last_id_ = 0;
  std::filesystem::path profile_;
  std::string session_;
  std::string unread_;
  std::vector<nlohmann::json> events_;
};

}  // namespace workbook::site
