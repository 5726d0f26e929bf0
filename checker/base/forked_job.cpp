#include "checker/base/forked_job.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>
#include <thread>

namespace workbook {

namespace {

constexpr rlim_t most_memory = rlim_t{4} << 30;  // a check needs some 100 MB; a scanner that runs wild stops here

void write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(descriptor, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) ::_exit(1);
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
}

/// The new process. It leaves by _exit: what the parent has begun to print, and its objects, are not its own.
[[noreturn]] void work_and_exit(const std::function<std::string(const ForkedJob::Send&)>& work, int result,
                                pid_t parent) {
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // not SIGKILL: it has compilers of its own to end
  if (::getppid() != parent) ::_exit(1);
#if !defined(__SANITIZE_ADDRESS__)  // which reserves terabytes of addresses
  rlimit memory{};
  ::getrlimit(RLIMIT_AS, &memory);
  memory.rlim_cur = std::min(most_memory, memory.rlim_max);  // the soft limit: a sanitizer's process raises it again
  ::setrlimit(RLIMIT_AS, &memory);
#endif
  try {
    write_all(result, work([result](std::string_view bytes) { write_all(result, bytes); }));
  } catch (...) {  // whatever it is: this must not go on in the parent's code
    ::_exit(2);
  }
  ::_exit(0);
}

}  // namespace

ForkedJob::ForkedJob(const std::function<std::string(const Send&)>& work, Clock::duration time_limit)
    : deadline_(begun_ + time_limit) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  bytes_ = Descriptor(ends[0]);
  const Descriptor writing(ends[1]);
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process_ == 0) work_and_exit(work, writing.number(), parent);
  ::setpgid(process_, process_);  // Ctrl-C and Ctrl-Z are for the parent, which decides what becomes of its jobs
  ::fcntl(bytes_.number(), F_SETFL, O_NONBLOCK);
}

ForkedJob::~ForkedJob() { end(); }

bool ForkedJob::collect() {
  std::array<char, 65536> buffer;
  while (!closed_) {
    const ssize_t got = ::read(bytes_.number(), buffer.data(), buffer.size());
    if (got > 0) output_.append(buffer.data(), static_cast<std::size_t>(got));
    if (got == 0) closed_ = true;
    if (got < 0 && errno != EINTR) break;
  }
  return closed_;
}

std::string ForkedJob::finish() {
  while (!collect()) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
    if (left <= 0) {
      end();
      return "it ran for too long";
    }
    pollfd watched{bytes_.number(), POLLIN, 0};
    ::poll(&watched, 1, static_cast<int>(left));
  }
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  if (WIFSIGNALED(status)) return fmt::format("signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  return WEXITSTATUS(status) == 0 ? "" : "it failed";
}

void ForkedJob::end() {
  if (process_ < 0) return;
  ::kill(process_, SIGTERM);
  const auto patience = Clock::now() + std::chrono::seconds(1);
  while (::waitpid(process_, nullptr, WNOHANG) == 0) {
    if (Clock::now() > patience) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  process_ = -1;
}

}  // namespace workbook
