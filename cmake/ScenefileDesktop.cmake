# Integration with the system: manual pages, shell completions, and the desktop entry with which file
# managers open scenes in the window.
set(manual ${PROJECT_BINARY_DIR}/manual)
set(make_manual ${PROJECT_SOURCE_DIR}/cmake/make_manual.cmake)
add_custom_command(OUTPUT ${manual}.stamp
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:scenefile> -DOUT=${manual} -P ${make_manual}
  COMMAND ${CMAKE_COMMAND} -E touch ${manual}.stamp
  DEPENDS scenefile ${make_manual} ${PROJECT_SOURCE_DIR}/packages/projects_ray.1
  COMMENT "Manual pages and completions" VERBATIM)
add_custom_target(scenefile_manual ALL DEPENDS ${manual}.stamp)

# zsh looks for completions of packages and of programs installed by hand in different folders.
set(zsh site-functions)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(zsh vendor-completions)
endif()
set(man1 ${CMAKE_INSTALL_MANDIR}/man1)
install(DIRECTORY ${manual}/man1/ DESTINATION ${man1} COMPONENT program)
install(FILES ${manual}/bash/scenefile DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${manual}/zsh/_scenefile DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${zsh} COMPONENT program)
install(FILES ${manual}/fish/scenefile.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)

if(TARGET scenefile-window)
  set(desktop ${PROJECT_SOURCE_DIR}/packages)
  file(CREATE_LINK scenefile-view.1.gz ${PROJECT_BINARY_DIR}/scenefile-window.1.gz SYMBOLIC)
  install(FILES ${PROJECT_BINARY_DIR}/scenefile-window.1.gz DESTINATION ${man1} COMPONENT window)
  install(FILES ${desktop}/scenefile.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT window)
  install(FILES ${desktop}/scenefile.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT window)
  install(FILES ${desktop}/scenefile.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT window)
endif()
