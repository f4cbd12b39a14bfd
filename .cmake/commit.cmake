# onggi_commit(SOURCE): the commit of the checkout SOURCE. Sets in the caller:
#   ONGGI_COMMIT    twelve digits, and ".changed" behind them where tracked files differ from it; "unknown" outside git
#   ONGGI_COMMIT_S  when it was made, in seconds since 1970; SOURCE_DATE_EPOCH, if set, comes before it
# Also sets SOURCE_DATE_EPOCH to it, so that string(TIMESTAMP) and all started tools use this time.
function(onggi_commit SOURCE)
    execute_process(COMMAND git -C ${SOURCE} log -1 --abbrev=12 "--format=%h %ct"
        OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
    string(REPLACE " " ";" head "${head}")
    set(commit unknown)
    set(made_s 0)
    if(failed EQUAL 0)
        list(GET head 0 commit)
        list(GET head 1 made_s)
        execute_process(COMMAND git -C ${SOURCE} status --porcelain --untracked-files=no
            OUTPUT_VARIABLE changes ERROR_QUIET)
        if(NOT changes STREQUAL "")
            string(APPEND commit ".changed")
        endif()
    endif()
    if(DEFINED ENV{SOURCE_DATE_EPOCH})
        set(made_s $ENV{SOURCE_DATE_EPOCH})
    endif()
    set(ENV{SOURCE_DATE_EPOCH} ${made_s})
    set(ONGGI_COMMIT ${commit} PARENT_SCOPE)
    set(ONGGI_COMMIT_S ${made_s} PARENT_SCOPE)
endfunction()
