# Included while installing, with `onggi_program` the built one and `made` a folder. Sets what the program says of itself:
# `named` ("onggi 0.1.0 (72112cf1a2b3, 2026-11-24)"), `version` and `day`.
execute_process(COMMAND ${onggi_program} --version OUTPUT_VARIABLE named OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
if(NOT named MATCHES "^onggi ([0-9.]+) [(].*, ([0-9-]+)[)]$")
    message(FATAL_ERROR "${onggi_program} --version: expected a version and a day, found '${named}'")
endif()
set(version ${CMAKE_MATCH_1})
set(day ${CMAKE_MATCH_2})

# onggi_manual(SECTION NAME ...): a page, made by what execute_process is told where it is not there yet, as .gz.
function(onggi_manual SECTION NAME)
    if(ARGN)
        file(MAKE_DIRECTORY ${made})
        execute_process(${ARGN} COMMAND_ERROR_IS_FATAL ANY)
    endif()
    # No name, no time: the same bytes.
    execute_process(COMMAND gzip -9nf ${made}/${NAME}.${SECTION} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
