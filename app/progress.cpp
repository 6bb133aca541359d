#include "app/progress.h"

#include "app/output.h"

#include <fmt/format.h>

#include <string>

namespace scenefile::app {

namespace {

constexpr int bar_width = 30;
constexpr std::chrono::milliseconds interval{100};
constexpr double shortest_estimate = 0.5;  // seconds until an estimate is useful

std::string time_text(double seconds) {
  if (seconds < 60) {
    return fmt::format("{:.0f} s", seconds);
  }
  const auto minutes = static_cast<long long>(seconds / 60);
  return minutes < 60 ? fmt::format("{} min {:.0f} s", minutes, seconds - 60.0 * double(minutes))
                      : fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

}  // namespace

void ProgressBar::update(double done) {
  const Clock::time_point now = Clock::now();
  if (!shown_ || (drawn_ && now - last_ < interval)) {
    return;
  }
  last_ = now;
  drawn_ = true;
  const auto filled = static_cast<int>(done * bar_width);
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string rest = seconds > shortest_estimate && done > 0
                               ? time_text(seconds * (1 - done) / done) + " left"
                               : std::string();
  say(fmt::format("\r[{:-<{}}] {:3.0f} %  {}\033[K", std::string(filled, '#'), bar_width,
                  100 * done, rest));
}

ProgressBar::~ProgressBar() {
  if (drawn_) {
    say("\r\033[K");
  }
}

}  // namespace scenefile::app
