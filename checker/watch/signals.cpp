#include "checker/watch/signals.hpp"

#include "checker/messages/watching.hpp"

#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace workbook {

Signals::Signals() {
  sigset_t all;
  ::sigemptyset(&all);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGWINCH, SIGTSTP, SIGCONT}) {
    struct sigaction action {};
    const bool ignored = ::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
    if (!ignored) ::sigaddset(&all, number);  // by nohup, for example
  }
  ::sigprocmask(SIG_BLOCK, &all, &before_);
  arrived_ = Descriptor(::signalfd(-1, &all, SFD_NONBLOCK | SFD_CLOEXEC));
  if (!arrived_) {
    const int reason = errno;
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
    throw std::system_error(reason, std::generic_category(), messages::cannot_listen_to_signals());
  }
}

Signals::~Signals() {
  take();  // what came too late changes nothing any more
  ::sigprocmask(SIG_SETMASK, &before_, nullptr);
}

std::vector<int> Signals::take() {
  std::vector<int> numbers;
  signalfd_siginfo info{};
  while (::read(arrived_.number(), &info, sizeof info) == static_cast<ssize_t>(sizeof info))
    numbers.push_back(static_cast<int>(info.ssi_signo));
  return numbers;
}

void Signals::stop_as_usual() {
  sigset_t stop;
  ::sigemptyset(&stop);
  ::sigaddset(&stop, SIGTSTP);
  ::raise(SIGTSTP);
  ::sigprocmask(SIG_UNBLOCK, &stop, nullptr);  // here it stops, unless nobody could continue it
  ::sigprocmask(SIG_BLOCK, &stop, nullptr);
}

}  // namespace workbook
