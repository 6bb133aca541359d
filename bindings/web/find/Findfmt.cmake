# The library built in libraries/.
find_path(fmt_INCLUDE_DIR fmt/format.h REQUIRED)
find_library(fmt_LIBRARY fmt REQUIRED)
if(NOT TARGET fmt::fmt)
  add_library(fmt::fmt STATIC IMPORTED)
  set_target_properties(fmt::fmt PROPERTIES IMPORTED_LOCATION "${fmt_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${fmt_INCLUDE_DIR}")
endif()
set(fmt_FOUND ON)
