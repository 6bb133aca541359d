#pragma once
// The results of a student as a JSON document: an item of the store of grade.

#include "scenefile/gradebook/gradebook.h"

#include <string>
#include <string_view>

namespace scenefile {

/// `key`: the text of its first member, item_text() in io/item.h. Keeps all values exactly: texts
/// that are not UTF-8, and pictures, are base64.
std::string encode_student(const StudentResult& student, std::string_view key);

/// Its inverse, for documents of this build of the program. Returns false if the bytes are not such
/// a document.
bool decode_student(std::string_view bytes, StudentResult& student);

}  // namespace scenefile
