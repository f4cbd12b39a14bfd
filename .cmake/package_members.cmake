# Run by cpack (CPACK_POST_BUILD_SCRIPTS): the modes of a package's archive members depend on the packer's
# umask; they are unused, so they are set to a fixed value. deb(5), ar(5): a header of 60 bytes before each
# member, mode at 40, size at 48.
foreach(package ${CPACK_PACKAGE_FILES})
    file(SIZE ${package} end)
    set(head 8)
    while(head LESS end)
        math(EXPR mode "${head} + 40")
        math(EXPR size "${head} + 48")
        file(READ ${package} bytes OFFSET ${size} LIMIT 10)
        string(STRIP "${bytes}" bytes)
        execute_process(COMMAND printf "100644  " COMMAND dd of=${package} bs=1 seek=${mode} conv=notrunc status=none
            COMMAND_ERROR_IS_FATAL ANY)
        math(EXPR head "${head} + 60 + ${bytes} + ${bytes} % 2")
    endwhile()
endforeach()
