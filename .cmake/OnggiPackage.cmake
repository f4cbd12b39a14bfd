# `--target package` makes two Debian packages, onggi and onggi-kiosk, from the components onggi and kiosk of
# OnggiInstall.cmake. Files for packages only are in assets/package; its README says why CPack is used.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME onggi)
set(CPACK_PACKAGE_VENDOR Onggi)
set(CPACK_PACKAGE_CONTACT "Onggi maintainers <maintainers@onggi.invalid>")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_COMPONENTS_ALL onggi kiosk)
set(CPACK_DEB_COMPONENT_INSTALL ON)
# Installation writes paths into units, so the prefix must be the final one, below DESTDIR.
set(CPACK_SET_DESTDIR ON)
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# Version and date come from the commit at packaging time, not at configuration time.
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_SOURCE_DIR}/.cmake/package_version.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/.cmake/package_tree.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/.cmake/package_members.cmake)
set(CPACK_ONGGI_SOURCE ${CMAKE_SOURCE_DIR})

set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(package ${CMAKE_SOURCE_DIR}/assets/package)
set(CPACK_DEBIAN_ONGGI_PACKAGE_NAME onggi)
set(CPACK_DEBIAN_ONGGI_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_ONGGI_PACKAGE_SHLIBDEPS ON)
# Loaded by GLFW at run time, but not in its package's dependencies: pointers and touches, several screens.
set(CPACK_DEBIAN_ONGGI_PACKAGE_DEPENDS "libxcursor1, libxi6, libxinerama1, libxrandr2")
set(CPACK_DEBIAN_ONGGI_PACKAGE_RECOMMENDS "mesa-vulkan-drivers | vulkan-icd, fonts-nanum, fonts-noto-core, espeak-ng")
# For Japanese and Chinese, which a kiosk does not offer unless its settings say so: 54 MB.
set(CPACK_DEBIAN_ONGGI_PACKAGE_SUGGESTS fonts-noto-cjk)
set(CPACK_DEBIAN_ONGGI_PACKAGE_CONTROL_EXTRA ${package}/onggi/postinst)

set(CPACK_DEBIAN_KIOSK_PACKAGE_NAME onggi-kiosk)
set(CPACK_DEBIAN_KIOSK_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_KIOSK_PACKAGE_CONTROL_EXTRA ${package}/onggi-kiosk/postinst ${package}/onggi-kiosk/prerm
    ${package}/onggi-kiosk/postrm ${package}/onggi-kiosk/conffiles)

set(CPACK_COMPONENT_ONGGI_DESCRIPTION "potter's wheel that one can feel
Pots are thrown on a wheel by stylus, force-feedback joystick, controller,
mouse or touch screen; the clay yields, drags and pushes back. Sessions replay
to the bit, and pots leave as glTF, USDZ, STL and 3MF.

This package holds the program, what it brings along, and the udev rules by
which whoever sits at the machine may open the devices.")
set(CPACK_COMPONENT_KIOSK_DESCRIPTION "museum kiosk around the Onggi potter's wheel
Makes of a machine a wheel that is always up: a service that starts with it, is
watched and started again, a user of its own, a full screen without a desktop,
settings in /etc/onggi, a server for pots that visitors take home by phone.

Installing it takes the machine's screen and tty1. Pots are kept in
/var/lib/onggi, and stay there when the package is purged.")

include(CPack)
