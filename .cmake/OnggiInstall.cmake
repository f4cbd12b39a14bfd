# The files of `cmake --install`: the program with its assets (component onggi), and the set-up of a kiosk
# (assets/install; component kiosk). Each component is also a Debian package (OnggiPackage.cmake). `--target
# uninstall` removes all files.

# The project's licence as REUSE.toml states it, for the package's copyright file and for AppStream.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/REUSE.toml)
file(STRINGS ${CMAKE_SOURCE_DIR}/REUSE.toml ONGGI_LICENCE REGEX "^SPDX.*Identifier = " LIMIT_COUNT 1)
string(REGEX REPLACE "^.*\"(.*)\"$" "\\1" ONGGI_LICENCE "${ONGGI_LICENCE}")

# Evaluated at installation, when the prefix is known. systemd and PAM read /etc for any prefix.
install(CODE [[
    if(CMAKE_INSTALL_PREFIX MATCHES "^/usr(/local)?$")
        set(ONGGI_ETC /etc)
    else()
        set(ONGGI_ETC ${CMAKE_INSTALL_PREFIX}/etc)
    endif()
]] ALL_COMPONENTS)
install(CODE "set(source ${CMAKE_SOURCE_DIR})\nset(build ${CMAKE_BINARY_DIR})\nset(ONGGI_LICENCE ${ONGGI_LICENCE})" ALL_COMPONENTS)
# Records new folders, which an uninstall removes again. Belongs to no component, so not done for packages.
install(CODE [[
    set(record ${build}/install_folders.txt)
    set(folders "")
    if(EXISTS ${record})
        file(STRINGS ${record} folders)
    endif()
    foreach(place bin lib/onggi lib/systemd/system lib/sysusers.d lib/tmpfiles.d lib/udev/rules.d share/applications
            share/bash-completion/completions share/doc/onggi/docs share/icons/hicolor/scalable/apps share/man/man1
            share/man/man5 share/man/man8 share/metainfo share/onggi)
        list(APPEND places ${CMAKE_INSTALL_PREFIX}/${place})
    endforeach()
    foreach(place IN LISTS places ITEMS ${ONGGI_ETC}/security/limits.d)
        set(place $ENV{DESTDIR}${place})
        while(NOT EXISTS ${place})
            list(APPEND folders ${place})
            get_filename_component(place ${place} DIRECTORY)
        endwhile()
    endforeach()
    list(REMOVE_DUPLICATES folders)
    list(JOIN folders "\n" folders)
    file(WRITE ${record} "${folders}\n")
]])

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME onggi)
install(TARGETS onggi RUNTIME DESTINATION bin)
# bin/onggi reads share/onggi: see engine/files/asset_folder.h.
install(DIRECTORY assets/workshop DESTINATION share/onggi FILES_MATCHING
    PATTERN "*.json" PATTERN "*.jpg" PATTERN "*.png" PATTERN "*.glb" PATTERN "README.md" PATTERN "maker" EXCLUDE)
install(DIRECTORY assets/heritage DESTINATION share/onggi)
install(DIRECTORY assets/tools DESTINATION share/onggi FILES_MATCHING PATTERN "*.glb" PATTERN "maker" EXCLUDE)
install(DIRECTORY assets/demonstrations DESTINATION share/onggi FILES_MATCHING
    PATTERN "*.onggi" PATTERN "shown.txt" PATTERN "README.md")
install(FILES assets/gestures/attract.csv DESTINATION share/onggi/gestures)
# Also built into the program; installed as a template for a museum's own tables.
install(DIRECTORY assets/languages DESTINATION share/onggi)
install(FILES assets/kiosk.toml DESTINATION share/onggi RENAME kiosk-settings.toml)
install(FILES README.md DESTINATION share/doc/onggi)
install(DIRECTORY docs DESTINATION share/doc/onggi)
# Entries for menus and shells. The program itself generates its manual page and completion at installation.
install(FILES assets/manual/onggi.desktop DESTINATION share/applications)
install(FILES assets/manual/onggi.svg DESTINATION share/icons/hicolor/scalable/apps)
# With the emulator of a cross build, because the program writes its own manual.
install(CODE "set(onggi_program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:onggi>)" ALL_COMPONENTS)
install(CODE [[
    set(made ${build}/install)
    include(${source}/.cmake/manual.cmake)
    configure_file(${source}/assets/package/copyright.in ${made}/copyright @ONLY)
    file(INSTALL ${made}/copyright DESTINATION ${CMAKE_INSTALL_PREFIX}/share/doc/onggi)
    configure_file(${source}/assets/manual/onggi.metainfo.xml.in ${made}/onggi.metainfo.xml @ONLY)
    onggi_manual(1 onggi COMMAND ${onggi_program} manual ${made})
    file(RENAME ${made}/onggi.bash ${made}/onggi)
    file(INSTALL ${made}/onggi.1.gz DESTINATION ${CMAKE_INSTALL_PREFIX}/share/man/man1)
    file(INSTALL ${made}/onggi.metainfo.xml DESTINATION ${CMAKE_INSTALL_PREFIX}/share/metainfo)
    file(INSTALL ${made}/onggi DESTINATION ${CMAKE_INSTALL_PREFIX}/share/bash-completion/completions)
]] COMPONENT onggi)

# Searched by udev and systemd for the prefixes /usr and /usr/local.
install(FILES assets/udev/70-onggi.rules DESTINATION lib/udev/rules.d)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME kiosk)
install(FILES assets/install/71-onggi-kiosk.rules DESTINATION lib/udev/rules.d)
install(FILES assets/install/kiosk.toml DESTINATION share/onggi)
install(FILES assets/install/sysusers.conf DESTINATION lib/sysusers.d RENAME onggi.conf)
install(CODE [[
    set(made ${build}/install)
    configure_file(${source}/assets/install/onggi-kiosk.service.in ${made}/onggi-kiosk.service @ONLY)
    configure_file(${source}/assets/install/onggi-share.service.in ${made}/onggi-share.service @ONLY)
    configure_file(${source}/assets/install/tmpfiles.conf.in ${made}/onggi.conf @ONLY)
    configure_file(${source}/assets/install/kiosk.in ${made}/kiosk @ONLY)
    configure_file(${source}/assets/install/limits.conf ${made}/70-onggi.conf COPYONLY)
    include(${source}/.cmake/manual.cmake)
    configure_file(${source}/assets/manual/onggi-kiosk.8.in ${made}/onggi-kiosk.8 @ONLY)
    onggi_manual(8 onggi-kiosk)
    onggi_manual(5 kiosk.toml COMMAND awk -v named=${named} -v day=${day} -f ${source}/assets/manual/kiosk_toml.awk
        ${source}/assets/kiosk.toml ${source}/assets/install/kiosk.toml OUTPUT_FILE ${made}/kiosk.toml.5)
    file(INSTALL ${made}/onggi-kiosk.8.gz DESTINATION ${CMAKE_INSTALL_PREFIX}/share/man/man8)
    file(INSTALL ${made}/kiosk.toml.5.gz DESTINATION ${CMAKE_INSTALL_PREFIX}/share/man/man5)
    file(INSTALL ${made}/onggi-kiosk.service ${made}/onggi-share.service DESTINATION ${CMAKE_INSTALL_PREFIX}/lib/systemd/system)
    file(INSTALL ${made}/onggi.conf DESTINATION ${CMAKE_INSTALL_PREFIX}/lib/tmpfiles.d)
    file(INSTALL ${made}/kiosk DESTINATION ${CMAKE_INSTALL_PREFIX}/lib/onggi
        PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    file(INSTALL ${made}/70-onggi.conf DESTINATION ${ONGGI_ETC}/security/limits.d)
]] COMPONENT kiosk)

add_custom_target(uninstall
    COMMAND ${CMAKE_COMMAND} -DBUILD=${CMAKE_BINARY_DIR} -P ${CMAKE_SOURCE_DIR}/.cmake/uninstall.cmake
    USES_TERMINAL VERBATIM)
