# Shared by ./run and ./check: packages, builds, terminal output. Sourced, never run. Works without root: sudo
# is used only to install.

say() { printf '%s\n' "onggi: $*"; }
die() { local status=$1; shift; printf '%s\n' "onggi: $*" >&2; exit "$status"; }

packages_to_run=(
    g++ cmake ninja-build pkg-config ccache
    libglfw3-dev libxcb1-dev libxcb-shm0-dev libxcb-xinput-dev libglm-dev libvulkan-dev glslang-tools libtinygltf-dev nlohmann-json3-dev libhidapi-dev libopenal-dev
    libsndfile1-dev libwebsockets-dev libmicrohttpd-dev libseccomp-dev libidn2-dev libqrcodegencpp-dev libsystemd-dev
    libcli11-dev libfmt-dev libpng-dev libturbojpeg0-dev libwebp-dev libopenh264-dev lib3mf-dev libmeshoptimizer-dev zlib1g-dev libarchive-dev
    libpango1.0-dev libfontconfig-dev libtomlplusplus-dev fonts-nanum fonts-noto-core
    mesa-vulkan-drivers)
packages_to_check=(
    glslang-dev spirv-tools libgtest-dev libbenchmark-dev vulkan-validationlayers
    xvfb xserver-xorg-core xserver-xorg-video-dummy xserver-xorg-dev xdotool x11-xserver-utils libx11-dev umockdev libumockdev-dev libdrm-dev admesh zbar-tools curl python3 git
    systemd cage xwayland dpkg-dev qemu-user fonts-noto-cjk espeak-ng)
# The clang of .cmake/clang.cmake. Only Debian 12 has the clang-format that the source is formatted by, and a cage that turns
# the picture by itself.
if grep -qs '^VERSION_CODENAME=bookworm$' /etc/os-release; then
    packages_to_check+=(clang-14 libclang-rt-14-dev clang-format-14)
else
    packages_to_check+=(clang-19 libclang-rt-19-dev wlr-randr)
fi
packages_for_web=(chromium gir1.2-webkit2-4.1 python3-gi libgl1-mesa-dri gstreamer1.0-plugins-good gstreamer1.0-libav)
packages_for_swiftshader=(chromium)
packages_for_slicer=(prusa-slicer)
packages_for_packages=(mmdebstrap lintian desktop-file-utils appstream man-db groff)

# quietly COMMAND...: prints what the command prints only if it fails, and fails with its exit code. apt explains on its
# standard output why packages cannot be installed together.
quietly() {
    local printed status=0
    printed=$("$@" 2>&1) || status=$?
    [ "$status" -eq 0 ] || printf '%s\n' "$printed" >&2
    return "$status"
}

# install_packages NAME...: installs missing packages, after a message.
install_packages() {
    command -v dpkg-query >/dev/null || { say "not a Debian system: taking it that these are installed: $*"; return; }
    local missing=() name
    for name in "$@"; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || missing+=("$name")
    done
    [ ${#missing[@]} -eq 0 ] && return
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || die 3 "as root, install: apt-get install --no-install-recommends ${missing[*]}"
        as_root=(sudo)
    fi
    say "installing Debian packages: ${missing[*]}"
    local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -qq)
    quietly "${as_root[@]}" "${apt[@]}" update || say "the package lists could not be refreshed; trying with those there are"
    quietly "${as_root[@]}" "${apt[@]}" install -y --no-install-recommends "${missing[@]}" ||
        die 3 "these Debian packages could not be installed: ${missing[*]}"
}

# build PRESET [CMAKE OPTION ...] [-- TARGET ...]: configures and builds; by default all targets.
build() {
    local preset=$1 options=() targets=()
    shift
    while [ $# -gt 0 ] && [ "$1" != -- ]; do options+=("$1"); shift; done
    [ $# -gt 0 ] && shift
    [ $# -gt 0 ] && targets=(--target "$@")
    # Lets ccache share objects between checkouts.
    export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
    mkdir -p build
    say "building $preset"
    cmake --preset "$preset" "${options[@]}" >"build/$preset-configure.log" 2>&1 ||
        { tail -n 20 "build/$preset-configure.log" >&2; die 1 "configuring $preset failed"; }
    cmake --build --preset "$preset" -j "$(nproc)" "${targets[@]}" >"build/$preset-build.log" 2>&1 ||
        { tail -n 60 "build/$preset-build.log" >&2; die 1 "building $preset failed"; }
}
