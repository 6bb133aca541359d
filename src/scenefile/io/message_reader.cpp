#include "scenefile/io/message_reader.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>

namespace scenefile {

namespace {

constexpr std::size_t max_header_bytes = 10'000;
constexpr std::string_view header_end = "\r\n\r\n";

// The number after `Content-Length:`; nullopt if there is none, or one above the limit.
std::optional<std::size_t> length_in(std::string_view header) {
  constexpr std::string_view name = "content-length:";
  while (!header.empty()) {
    const std::size_t end = std::min(header.find("\r\n"), header.size());
    std::string_view line = header.substr(0, end);
    header.remove_prefix(std::min(end + 2, header.size()));
    if (line.size() > name.size() && equal_ignoring_case(line.substr(0, name.size()), name)) {
      line.remove_prefix(std::min(line.find_first_not_of(' ', name.size()), line.size()));
      std::size_t length = line.empty() || !is_digit(line[0]) ? max_message_bytes + 1 : 0;
      while (!line.empty() && is_digit(line[0]) && length <= max_message_bytes) {
        length = 10 * length + static_cast<std::size_t>(line[0] - '0');
        line.remove_prefix(1);
      }
      return length <= max_message_bytes ? std::optional(length) : std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<MessageEvent> MessageReader::take(std::string& body) {
  const std::size_t end = read_.find(header_end);
  if (end == std::string::npos) {
    return read_.size() > max_header_bytes ? std::optional(MessageEvent::broken) : std::nullopt;
  }
  const std::optional<std::size_t> length = length_in(std::string_view(read_).substr(0, end));
  if (!length) {
    return MessageEvent::broken;
  }
  const std::size_t begin = end + header_end.size();
  if (read_.size() - begin < *length) {
    return std::nullopt;
  }
  body = read_.substr(begin, *length);
  read_.erase(0, begin + *length);
  return MessageEvent::message;
}

MessageEvent MessageReader::next(std::optional<double> seconds, std::string& body) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  for (;;) {
    if (const std::optional<MessageEvent> event = take(body)) {
      return *event;
    }
    int wait = -1;
    if (seconds) {
      const double passed = std::chrono::duration<double>(Clock::now() - start).count();
      wait = static_cast<int>(std::ceil(std::clamp(*seconds - passed, 0.0, 1e5) * 1000));
    }
    pollfd input{STDIN_FILENO, POLLIN, 0};
    const int ready = ::poll(&input, 1, wait);
    if (ready == 0) {
      return MessageEvent::timeout;
    }
    if (ready < 0) {
      if (errno == EINTR) {
        continue;
      }
      return MessageEvent::end;
    }
    std::array<char, 65536> buffer;
    const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (count > 0) {
      add({buffer.data(), static_cast<std::size_t>(count)});
    } else if (count == 0 || errno != EINTR) {
      return MessageEvent::end;
    }
  }
}

}  // namespace scenefile
