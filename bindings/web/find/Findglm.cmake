# Only headers.
find_path(glm_INCLUDE_DIR glm/glm.hpp REQUIRED)
if(NOT TARGET glm::glm)
  add_library(glm::glm INTERFACE IMPORTED)
  set_target_properties(glm::glm PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${glm_INCLUDE_DIR}")
endif()
set(glm_FOUND ON)
