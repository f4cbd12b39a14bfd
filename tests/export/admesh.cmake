# admesh must find each STL pot closed, complete, facing outward, and without a degenerate facet, before any
# repair. cmake -DADMESH=program -DPOTS=folder -P admesh.cmake
file(GLOB pots ${POTS}/*.stl)
if(NOT pots)
    message(FATAL_ERROR "admesh: expected pots in ${POTS}, found none")
endif()
foreach(pot IN LISTS pots)
    # A closed hollow is a separate part.
    set(parts 1)
    if(pot MATCHES "closed_over")
        set(parts 2)
    endif()
    # All repairs off except the exact check, so that the report describes the file.
    execute_process(COMMAND ${ADMESH} --exact --normal-directions --normal-values ${pot}
        OUTPUT_VARIABLE report ERROR_VARIABLE report RESULT_VARIABLE code)
    foreach(line IN ITEMS
            "Total disconnected facets *: *0 "
            "Degenerate facets *: *0\n"
            "Number of parts *: *${parts} "
            "Facets reversed *: *0\n"
            "Normals fixed *: *0\n")
        if(NOT code EQUAL 0 OR NOT report MATCHES "${line}")
            message(FATAL_ERROR "admesh: ${pot}: expected \"${line}\" in\n${report}")
        endif()
    endforeach()
    message(STATUS "${pot}: closed, ${parts} part, nothing degenerate, reversed or fixed")
endforeach()
