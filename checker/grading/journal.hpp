/// @file
/// What has been judged, in a file that only grows: a program that is killed loses nothing but what it was doing.
#pragma once

#include "checker/pipeline/check_exercise.hpp"

namespace workbook {

class Journal {
 public:
  enum class Access { write, read };

  /// To write, opens the file for this program alone, and drops what was written by halves.
  /// @throws GradingError if another one grades there, std::runtime_error
  explicit Journal(fs::path file, Access access = Access::write);

  bool has(const std::string& key) const { return places_.contains(key); }

  /// The result under the key, if it was made from exactly this content.
  std::optional<CheckResult> find(const std::string& key, const std::string& content) const;

  /// Safe from the end of this program at once, and from that of the machine a second later or after sync(): waiting
  /// for the disk after each result would keep processors idle. @throws std::runtime_error
  void append(const std::string& key, const std::string& content, const CheckResult& checked);

  /// Copies the results that this journal lacks. @throws std::runtime_error
  void merge(const Journal& other);

  /// All is on disk when it returns. @throws std::runtime_error
  void sync();

  /// Leaves out the results with this verdict from now on.
  void forget(const std::string& verdict);

  std::size_t damaged() const { return damaged_; }

 private:
  struct Place {
    std::int64_t offset = 0;
    std::size_t size = 0;
  };

  std::string line_at(const Place& place) const;
  void write(const std::string& key, const std::string& line);

  fs::path file_;
  Descriptor descriptor_;
  std::map<std::string, Place> places_;
  std::int64_t end_ = 0;
  Clock::time_point synced_ = Clock::now();
  std::size_t damaged_ = 0;
};

}  // namespace workbook
