# Only headers.
find_path(RAPIDJSON_INCLUDE_DIRS rapidjson/reader.h REQUIRED)
set(RapidJSON_FOUND ON)
