#pragma once
// Messages with a header, as language servers receive them: `Content-Length: N`, an empty line, N
// bytes.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// Of a message without its header.
inline constexpr std::size_t max_message_bytes = 256'000'000;

enum class MessageEvent : std::uint8_t {
  message,
  timeout,  ///< none was complete in time
  end,      ///< of the input
  broken,   ///< a header without a length, or with one above the limit
};

class MessageReader {
 public:
  /// Waits for the next message of standard input, at most `seconds`; without a number, as long as
  /// it takes.
  MessageEvent next(std::optional<double> seconds, std::string& body);

  // For callers that read the input themselves.
  void add(std::string_view bytes) { read_.append(bytes); }
  /// Takes a message from what was added; nullopt if it is not complete.
  std::optional<MessageEvent> take(std::string& body);

 private:
  std::string read_;
};

}  // namespace scenefile
