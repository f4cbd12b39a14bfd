# Builds and runs the golden tests with ONGGI_BLESS from the environment, and checks that each named scene was
# stored. The tests refuse in CI and if the tree has changes outside tests/golden. cmake -DCTEST=ctest
# -DBUILD=folder -P golden_bless.cmake
if("$ENV{ONGGI_BLESS}" STREQUAL "")
    message(FATAL_ERROR "golden-bless: expected the scenes to store, for example ONGGI_BLESS=vase,neck")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} RESULT_VARIABLE code)
if(NOT code EQUAL 0)
    message(FATAL_ERROR "golden-bless: the build failed, nothing was stored")
endif()
# Other scenes are compared as usual and may fail; only the named ones matter here. Scenes called gpu-... are
# SwiftShader's.
execute_process(COMMAND ${CTEST} --test-dir ${BUILD} -R "^(golden|swiftshader)_pictures$" --verbose OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(REPLACE "," ";" scenes "$ENV{ONGGI_BLESS}")
foreach(scene IN LISTS scenes)
    if(NOT output MATCHES "blessed: ${scene}\n")
        message(FATAL_ERROR "golden-bless: ${scene} was not stored. The tests said:\n${output}")
    endif()
    string(REGEX MATCH "blessed: ${scene}\n([^\n]*\n)([^\n]*\n)([^\n]*\n)?" story "${output}")
    string(REGEX REPLACE "\n[0-9]+: " "\n" story "${story}")  # ctest puts the test's number before each line
    message("${story}")
endforeach()
message("golden-bless: stored. Look at both pictures, and say in the commit why they differ.")
