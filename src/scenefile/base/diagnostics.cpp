#include "scenefile/base/diagnostics.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace scenefile {

Diagnostics::Diagnostics(const Limits& limits)
    : max_per_code_(limits.messages_per_code), max_bytes_(limits.message_bytes) {}

void Diagnostics::report(const Code& code, Location location, std::string message) {
  report(code, code.severity, location, std::move(message));
}

void Diagnostics::report(const Code& code, Severity severity, Location location,
                         std::string message, std::vector<std::string> notes) {
  add({&code, severity, location, {}, std::move(message), std::move(notes)});
}

void Diagnostics::report(const Code& code, Location location, std::string message,
                         std::optional<Correction> correction) {
  add({&code, code.severity, location, {}, std::move(message), {}, std::move(correction)});
}

void Diagnostics::add(Diagnostic diagnostic) {
  Tally& tally = tallies_[diagnostic.code];
  const auto severity = static_cast<std::size_t>(diagnostic.severity);
  ++counts_[severity];
  std::size_t bytes = diagnostic.message.size() + diagnostic.file.size();
  for (const std::string& note : diagnostic.notes) {
    bytes += note.size();
  }
  if (diagnostic.correction) {
    bytes += diagnostic.correction->written.size() + diagnostic.correction->instead.size();
  }
  // The first of each code is always kept, so that no code goes unmentioned.
  const bool fits = tally.kept < max_per_code_ && bytes_ + bytes <= max_bytes_;
  if (tally.kept != 0 && !fits) {
    ++tally.dropped[severity];
    return;
  }
  ++tally.kept;
  bytes_ += bytes;
  list_.push_back(std::move(diagnostic));
}

std::size_t Diagnostics::dropped(const Code& code) const {
  const auto found = tallies_.find(&code);
  if (found == tallies_.end()) {
    return 0;
  }
  const auto& dropped = found->second.dropped;
  return std::accumulate(std::begin(dropped), std::end(dropped), std::size_t{0});
}

std::size_t Diagnostics::dropped() const {
  std::size_t sum = 0;
  for (const auto& entry : tallies_) {
    sum += dropped(*entry.first);
  }
  return sum;
}

void Diagnostics::set_paths(const std::function<std::string(const std::string& file)>& path_of) {
  for (Diagnostic& diagnostic : list_) {
    if (!diagnostic.file.empty()) {
      diagnostic.path = path_of(diagnostic.file);
    }
  }
}

void Diagnostics::rewrite(
    const std::function<std::optional<Severity>(const Code&, Severity)>& decide) {
  std::vector<Diagnostic> kept;
  std::fill(std::begin(counts_), std::end(counts_), std::size_t{0});
  for (Diagnostic& diagnostic : list_) {
    if (const auto severity = decide(*diagnostic.code, diagnostic.severity)) {
      diagnostic.severity = *severity;
      ++counts_[static_cast<std::size_t>(*severity)];
      kept.push_back(std::move(diagnostic));
    }
  }
  list_ = std::move(kept);
  for (auto& [code, tally] : tallies_) {
    std::size_t dropped[3] = {0, 0, 0};
    for (const Severity from : {Severity::note, Severity::warning, Severity::error}) {
      if (const auto to = decide(*code, from)) {
        dropped[static_cast<std::size_t>(*to)] += tally.dropped[static_cast<std::size_t>(from)];
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      tally.dropped[i] = dropped[i];
      counts_[i] += dropped[i];
    }
  }
}

}  // namespace scenefile
