# Included during installation; `onggi_program` is the built program and `made` a folder. Sets, from the
# program's output: `named` ("onggi 0.1.0 (72112cf1a2b3, 2026-11-24)"), `version` and `day`.
execute_process(COMMAND ${onggi_program} --version OUTPUT_VARIABLE named OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
if(NOT named MATCHES "^onggi ([0-9.]+) [(].*, ([0-9-]+)[)]$")
    message(FATAL_ERROR "${onggi_program} --version: expected a version and a day, found '${named}'")
endif()
set(version ${CMAKE_MATCH_1})
set(day ${CMAKE_MATCH_2})

# onggi_manual(SECTION NAME ...): installs a page as .gz; if missing, it is made by the given execute_process
# arguments.
function(onggi_manual SECTION NAME)
    if(ARGN)
        file(MAKE_DIRECTORY ${made})
        execute_process(${ARGN} COMMAND_ERROR_IS_FATAL ANY)
    endif()
    # Store no name and time, for reproducible bytes.
    execute_process(COMMAND gzip -9nf ${made}/${NAME}.${SECTION} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
