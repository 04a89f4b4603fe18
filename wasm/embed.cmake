# Puts a WebAssembly module into lvsm.mjs as base64: cmake -D TEMPLATE=... -D WASM=... -D OUTPUT=... -P embed.cmake
cmake_minimum_required(VERSION 3.22)
find_program(BASE64 base64 REQUIRED)
execute_process(COMMAND ${BASE64} -w0 ${WASM} OUTPUT_VARIABLE WASM COMMAND_ERROR_IS_FATAL ANY)
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
