# cmake -DPROGRAM=... -DOUT=... -P make_manual.cmake
# Writes PROGRAM's manual pages and completions to the folders OUT/man1, bash, zsh and fish.
function(answer file)
  execute_process(COMMAND ${PROGRAM} help ${ARGN} OUTPUT_FILE ${OUT}/${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${OUT}/man1 ${OUT}/bash ${OUT}/zsh ${OUT}/fish)
answer(bash/scenefile --completion bash)
answer(zsh/_scenefile --completion zsh)
answer(fish/scenefile.fish --completion fish)

answer(man1/scenefile.1 --man)
execute_process(COMMAND ${PROGRAM} help --json OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(JSON count LENGTH ${help} commands)
math(EXPR last "${count} - 1")
foreach(i RANGE ${last})
  string(JSON command GET ${help} commands ${i} name)
  answer(man1/scenefile-${command}.1 --man ${command})
endforeach()
file(COPY ${CMAKE_CURRENT_LIST_DIR}/../packages/projects_ray.1 DESTINATION ${OUT}/man1)
file(WRITE ${OUT}/man1/projects_path.1 ".so man1/projects_ray.1\n")

# Compressed like all manual pages, without time or name.
find_program(GZIP gzip REQUIRED)
file(GLOB pages ${OUT}/man1/*.1)
execute_process(COMMAND ${GZIP} -9n ${pages} COMMAND_ERROR_IS_FATAL ANY)
