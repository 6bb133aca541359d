// Feeds bytes to the reader of students' results in a store of grade.

#include "law.h"
#include "scenefile/verbs/student_item.h"
#include "target.h"

#include <string>
#include <string_view>

using namespace scenefile;
using fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  StudentResult student;
  if (decode_student({reinterpret_cast<const char*>(data), size}, student)) {
    const std::string text = encode_student(student, "");
    StudentResult again;
    require(decode_student(text, again), "what is written is read");
    require(encode_student(again, "") == text, "nothing is lost");
  }
  return 0;
}
