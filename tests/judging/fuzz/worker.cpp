// A worker whose replies are damaged: to k it says k, 1/k, −k, … and then changes some bytes of that, others for every
// k. What it prints tells whether it has changed who replies how ("header") or numbers ("numbers").
#include "checker/worker/protocol.hpp"

#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>
#include <string>
#include <vector>

using namespace workbook::protocol;

namespace {

bool receive(void* to, std::size_t size) {
  for (char* next = static_cast<char*>(to); size > 0;) {
    const ssize_t got = ::read(channel, next, size);
    if (got <= 0) return false;
    next += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool send(int to, const std::string& bytes) {
  return ::write(to, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
}

/// @param whole  the reply as it should be
std::string damaged(std::string bytes, std::mt19937& random) {
  constexpr std::size_t decisive = offsetof(ReplyHeader, signal);
  for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
    // Half of them where they matter most.
    const std::size_t at = random() % (random() % 2 == 0 ? decisive : bytes.size());
    const std::size_t from = random() % bytes.size(), length = random() % 24;
    switch (random() % 6) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        break;
      case 1:
        bytes[at] = static_cast<char>(random());
        break;
      case 2:
        bytes.replace(at, 8, 8, random() % 2 == 0 ? '\0' : '\xff');
        break;
      case 3:
        bytes.erase(at, length);
        break;
      case 4:
        bytes.insert(at, bytes.substr(from, length));
        break;
      default:
        bytes.insert(bytes.size(), bytes.substr(0, random() % 2 == 0 ? bytes.size() : length));
    }
    if (bytes.empty()) break;
  }
  return bytes;
}

}  // namespace

int main() {
  RequestHeader request{};
  while (receive(&request, sizeof request)) {
    Shape shape{};
    double k = 0;
    if (request.arguments != 1 || !receive(&shape, sizeof shape) || !receive(&k, sizeof k)) return 1;
    ReplyHeader reply{};
    reply.magic = reply_magic;
    reply.nonce = request.nonce;
    reply.status = Status::returned;
    reply.result = request.result;
    std::vector<double> numbers(static_cast<std::size_t>(request.result.rows * request.result.cols));
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i % 3 == 0 ? k : i % 3 == 1 ? 1 / k : -k;
    std::string bytes(reinterpret_cast<const char*>(&reply), sizeof reply);
    bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));

    std::mt19937 random(static_cast<unsigned>(k));
    const std::string sent = damaged(bytes, random);
    constexpr std::size_t decisive = offsetof(ReplyHeader, signal);
    if (sent.compare(0, decisive, bytes, 0, decisive) != 0) send(STDOUT_FILENO, "header");
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      double number = std::nan("");
      const std::size_t place = sizeof reply + i * sizeof number;
      if (place + sizeof number <= sent.size()) std::memcpy(&number, sent.data() + place, sizeof number);
      if (!(std::abs(number - numbers[i]) <= 1e-3 * std::abs(numbers[i]))) send(STDOUT_FILENO, "numbers");
    }
    if (!send(channel, sent)) return 1;
    // Else both sides might wait for each other until the time is over.
    Status status{};
    if (sent.size() >= sizeof reply) std::memcpy(&status, sent.data() + offsetof(ReplyHeader, status), sizeof status);
    if (sent.size() < bytes.size() || status == Status::crash_report) return 0;
  }
  return 0;
}
