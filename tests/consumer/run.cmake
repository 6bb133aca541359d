# Installs the build to an empty folder, builds the consumer against it as a separate project, and
# renders scenes with it, including one with textures and meshes.
# cmake -DBUILD=... -DSOURCE=... -DSCENES=... -DWORK=... -DFLAGS=... -DCXX=... -DLIBDIR=... -P run.cmake
function(must)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${out}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
must(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
must(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_PREFIX_PATH=${WORK}/prefix "-DCMAKE_CXX_FLAGS=${FLAGS}")
must(${CMAKE_COMMAND} --build ${WORK}/build)
must(${WORK}/build/verbs)
# The same without CMake: it also links with the flags from pkg-config.
set(ENV{PKG_CONFIG_PATH} ${WORK}/prefix/${LIBDIR}/pkgconfig)
execute_process(COMMAND pkg-config --libs scenefile OUTPUT_VARIABLE libs OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(libs UNIX_COMMAND "${libs} ${FLAGS}")
must(${CXX} ${WORK}/build/CMakeFiles/consumer.dir/main.cpp.o -o ${WORK}/build/linked ${libs})
must(${WORK}/build/linked ${SCENES}/hello.xml ${WORK}/linked.png)

foreach(scene hello showcase)
  must(${WORK}/build/consumer ${SCENES}/${scene}.xml ${WORK}/${scene}.png)
  file(SIZE ${WORK}/${scene}.png size)
  if(size LESS 1000)
    message(FATAL_ERROR "the consumer wrote ${size} bytes")
  endif()
endforeach()

must(${WORK}/build/normals ${SCENES}/hello.xml ${WORK}/normals.exr ${WORK}/normals.png)
file(SIZE ${WORK}/normals.exr size)
if(size LESS 10000 OR NOT EXISTS ${WORK}/normals.png)
  message(FATAL_ERROR "the layer of normals has ${size} bytes")
endif()
