#pragma once
// The answers of the functions for the page.

#include "scenefile/verbs/json_writer.h"

#include <exception>
#include <new>
#include <string>
#include <string_view>

namespace scenefile {

inline std::string error_json(std::string_view text) {
  Json json;
  json.begin_object();
  json.add("error", text);
  json.end_object();
  return json.text();
}

/// Runs `work` and turns exceptions into answers, so that every call has one. `release`: frees
/// memory when there is none left.
template <typename Work, typename Release>
std::string answer_of(const Work& work, const Release& release) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    release();
    return error_json("out of memory");
  } catch (const std::exception& error) {
    return error_json(error.what());
  }
}

}  // namespace scenefile
