# Read by cpack (CPACK_PROJECT_CONFIG_FILE): the packages' version, of the commit. A later commit is a later version, and
# sets SOURCE_DATE_EPOCH: what is packed twice is the same twice.
include(${CMAKE_CURRENT_LIST_DIR}/commit.cmake)
onggi_commit(${CPACK_ONGGI_SOURCE})
string(TIMESTAMP made "%Y%m%d%H%M%S" UTC)
set(CPACK_DEBIAN_PACKAGE_VERSION ${CPACK_PACKAGE_VERSION}+git${made}.${ONGGI_COMMIT})
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_KIOSK_PACKAGE_DEPENDS
    "onggi (= ${CPACK_DEBIAN_PACKAGE_VERSION}-1)"
    # What the unit, and the script that it starts, call.
    systemd udev seatd procps
    # A screen: the compositor, X11 in it, drivers for both.
    cage xwayland libgl1-mesa-dri mesa-vulkan-drivers
    # The words on it.
    fonts-nanum fonts-noto-core)
list(JOIN CPACK_DEBIAN_KIOSK_PACKAGE_DEPENDS ", " CPACK_DEBIAN_KIOSK_PACKAGE_DEPENDS)
