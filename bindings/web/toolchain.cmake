# Compiles the core to WebAssembly with Debian's emscripten 3.1.6 (decision 22). SCENEFILE_WEB_PREFIX: where
# libraries/ was installed.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SCENEFILE_WEB_PREFIX)
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
list(APPEND CMAKE_FIND_ROOT_PATH "${SCENEFILE_WEB_PREFIX}")
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}/find")

# LLVM 14 miscompiles the search through nested groups with -msimd128. Only the file that computes in
# lanes, by hand, is compiled with it (trace/CMakeLists.txt).
set(web_flags "-fno-slp-vectorize -fno-vectorize -fwasm-exceptions -mllvm -wasm-enable-sjlj")
set(CMAKE_C_FLAGS_INIT "${web_flags}")
set(CMAKE_CXX_FLAGS_INIT
  "${web_flags} -fno-rtti -include ${CMAKE_CURRENT_LIST_DIR}/missing_in_libcxx13.h")

# Calls the compiler directly, with emcc's arguments: emcc takes half a second per source, half of the
# build time. emcc is used for linking.
string(JOIN " " as_emcc -target wasm32-unknown-emscripten -DEMSCRIPTEN -D__EMSCRIPTEN_major__=3
  -D__EMSCRIPTEN_minor__=1 -D__EMSCRIPTEN_tiny__=6 -fvisibility=default
  -mllvm -combiner-global-alias-analysis=false -mllvm -disable-lsr -D_LIBCPP_ABI_VERSION=2
  -fno-threadsafe-statics -Dunix -D__unix -D__unix__
  --sysroot=/usr/share/emscripten/cache/sysroot -Xclang -iwithsysroot/include/compat)
set(CMAKE_C_COMPILE_OBJECT
  "/usr/bin/clang-14 ${as_emcc} <DEFINES> <INCLUDES> <FLAGS> -o <OBJECT> -c <SOURCE>")
set(CMAKE_CXX_COMPILE_OBJECT
  "/usr/bin/clang++-14 ${as_emcc} <DEFINES> <INCLUDES> <FLAGS> -o <OBJECT> -c <SOURCE>")
