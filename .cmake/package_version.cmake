# Read by cpack (CPACK_PROJECT_CONFIG_FILE): sets the packages' version from the commit, so that a later
# commit is a later version, and SOURCE_DATE_EPOCH, so that packaging is reproducible.
include(${CMAKE_CURRENT_LIST_DIR}/commit.cmake)
onggi_commit(${CPACK_ONGGI_SOURCE})
string(TIMESTAMP made "%Y%m%d%H%M%S" UTC)
set(CPACK_DEBIAN_PACKAGE_VERSION ${CPACK_PACKAGE_VERSION}+git${made}.${ONGGI_COMMIT})
# The suite is that of the machine, whose libraries the packages need: 1~deb12.
cmake_host_system_information(RESULT suite QUERY DISTRIB_ID DISTRIB_VERSION_ID)
list(JOIN suite "" suite)
string(REGEX REPLACE "^debian" "deb" suite "${suite}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1~${suite})
set(CPACK_DEBIAN_KIOSK_PACKAGE_DEPENDS
    "onggi (= ${CPACK_DEBIAN_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})"
    # Called by the unit and its start script.
    systemd udev seatd procps
    # Display: the compositor, X11 in it, and drivers.
    cage wlr-randr xwayland libgl1-mesa-dri mesa-vulkan-drivers
    # Fonts.
    fonts-nanum fonts-noto-core)
list(JOIN CPACK_DEBIAN_KIOSK_PACKAGE_DEPENDS ", " CPACK_DEBIAN_KIOSK_PACKAGE_DEPENDS)
