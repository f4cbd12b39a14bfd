# Run by cpack (CPACK_PRE_BUILD_SCRIPTS) between installing and packing: adds the files that only a Debian
# package has.
set(onggi ${CPACK_TEMPORARY_DIRECTORY}/onggi/usr/share)
set(kiosk ${CPACK_TEMPORARY_DIRECTORY}/kiosk/usr/share)

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(version ${CPACK_DEBIAN_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
cmake_host_system_information(RESULT suite QUERY DISTRIB_VERSION_CODENAME)
file(WRITE ${onggi}/doc/onggi/changelog.Debian "onggi (${version}) ${suite}; urgency=medium

  * Built of this commit. What is new: changelog.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
file(COPY_FILE ${CPACK_ONGGI_SOURCE}/CHANGELOG.md ${onggi}/doc/onggi/changelog)
foreach(file changelog changelog.Debian)
    execute_process(COMMAND gzip -9nf ${onggi}/doc/onggi/${file} COMMAND_ERROR_IS_FATAL ANY)
    file(CHMOD ${onggi}/doc/onggi/${file}.gz FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
endforeach()
# Both packages share one source and version.
file(MAKE_DIRECTORY ${kiosk}/doc)
file(CREATE_LINK onggi ${kiosk}/doc/onggi-kiosk SYMBOLIC)

# Lintian overrides, with reasons.
file(MAKE_DIRECTORY ${onggi}/lintian/overrides)
file(COPY_FILE ${CPACK_ONGGI_SOURCE}/assets/package/onggi/lintian-overrides ${onggi}/lintian/overrides/onggi)

# Folders must be readable by all, independent of the packer's umask.
execute_process(COMMAND find ${CPACK_TEMPORARY_DIRECTORY} -type d -exec chmod 755 {} + COMMAND_ERROR_IS_FATAL ANY)
