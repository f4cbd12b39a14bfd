#!/usr/bin/env bash
# The packages hold the files of `cmake --install`, byte for byte, and otherwise only files that Debian
# requires; each file of assets/ is in one of them or has a reason in not_installed.txt, and has a licence;
# LICENSE, copyright file and AppStream state one licence. trees.sh BUILD FOLDER
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$1 folder=$2
fail() { printf '%s\n' "$*"; exit 1; }
rm -rf "$folder"
mkdir -p "$folder/packed" "$folder/installed"

# Low compression, which would take most of the time.
cpack --config "$build/CPackConfig.cmake" -B "$folder/packages" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip >"$folder/cpack.log" 2>&1 ||
    { cat "$folder/cpack.log"; fail "expected two packages"; }
for name in onggi onggi-kiosk; do
    package=$(echo "$folder/packages/${name}_"*.deb)
    [ -f "$package" ] || fail "expected one package $name, found $package"
    dpkg-deb -R "$package" "$folder/$name"
    mv "$folder/$name/DEBIAN" "$folder/$name.control"
    for script in "$folder/$name.control/"{pre,post}{inst,rm}; do
        [ ! -e "$script" ] || { sh -n "$script" && [ -x "$script" ]; } || fail "expected a script of $name's that can be run: $script"
    done
    # No file may be in both: dpkg would refuse the second package.
    while read -r file; do
        [ ! -e "$folder/packed/$file" ] || fail "$file: expected it in one package, found it in both"
    done < <(cd "$folder/$name" && find . ! -type d -printf '%P\n')
    cp -a "$folder/$name/." "$folder/packed"
done
# The libraries are those of this suite, so version and changelog name it, and each package asks for the other of its suite.
for word in ID VERSION_ID VERSION_CODENAME; do declare "$word=$(. /etc/os-release && echo "${!word}")"; done
version=$(sed -n 's/^Version: //p' "$folder/onggi.control/control")
[[ "$version" = *-1~${ID/#debian/deb}$VERSION_ID ]] || fail "expected a version that ends in -1~deb12 on Debian 12, found $version"
grep -qF "onggi (= $version)" "$folder/onggi-kiosk.control/control" || fail "expected the kiosk's package to need onggi $version"
[[ "$(zcat "$folder/onggi/usr/share/doc/onggi/changelog.Debian.gz" | head -1)" = "onggi ($version) $VERSION_CODENAME; "* ]] ||
    fail "expected a changelog of $version in $VERSION_CODENAME"
# All packed files, by their bytes.
(cd "$folder/packed" && find . -type f -exec sha256sum {} +) | cut -d ' ' -f 1 | sort -u >"$folder/sums"

DESTDIR=$folder/installed cmake --install "$build" --prefix /usr --strip >"$folder/install.log"
# LICENSE, REUSE.toml, the package and AppStream agree; each licence's text is in LICENSES/, and no other.
mapfile -t licences < <(sed -n 's/^SPDX.*Identifier = "\(.*\)"$/\1/p' REUSE.toml)
licence=${licences[0]}
[ -n "$licence" ] || fail "expected a licence in REUSE.toml, found none"
[ "$(printf '%s.txt\n' "${licences[@]}" | sort -u)" = "$(ls LICENSES)" ] || fail "expected in LICENSES/ one text for each licence of REUSE.toml"
cmp LICENSE "LICENSES/$licence.txt"
common=/usr/share/common-licenses/$licence
[ ! -e "$common" ] || cmp LICENSE "$common"
share=$folder/packed/usr/share
found=$(awk '/^Files: \*$/ { on = 1 } on && /^License:/ { print $2; exit }' "$share/doc/onggi/copyright")
[ "$found" = "$licence" ] || fail "expected $licence in the package's copyright file, found '$found'"
grep -q "^ $common\.\$" "$share/doc/onggi/copyright" || fail "expected the copyright file to name $common"
found=$(sed -n 's|.*<project_license>\(.*\)</project_license>|\1|p' "$share/metainfo/onggi.metainfo.xml")
[ "$found" = "$licence" ] || fail "expected $licence in the AppStream metadata, found '$found'"

for only in usr/share/doc/onggi/changelog.gz usr/share/doc/onggi/changelog.Debian.gz usr/share/doc/onggi-kiosk \
    usr/share/lintian/overrides/onggi; do
    [ -e "$folder/packed/$only" ] || fail "expected $only in a package, found none"
    rm "$folder/packed/$only"
done
rmdir "$folder/packed/usr/share/lintian/overrides" "$folder/packed/usr/share/lintian"
tree() { (cd "$folder/$1" && find . -printf '%y %m %p %l\n' | sort && find . -type f -exec sha256sum {} + | sort -k 2); }
tree packed >"$folder/packed.txt"
tree installed >"$folder/installed.txt"
diff "$folder/installed.txt" "$folder/packed.txt" || fail "expected packages (>) that hold the installed files (<)"

for document in README.md docs/*.md; do
    [ -s "$share/doc/onggi/$document" ] || fail "expected $document among the documents"
done

# The build path must not be in the package: it would differ between builders.
for path in "$PWD" "$build"; do
    if grep -rlaF "$path" "$folder/packed"; then fail "expected no file that names $path"; fi
done

# Each file of assets/, by its bytes.
mapfile -t assets < <(git ls-files --cached --others --exclude-standard -- assets)
[ ${#assets[@]} -gt 60 ] || fail "expected the files of assets/, found ${#assets[@]}"
declare -A named=()
while read -r line; do
    [ -z "$line" ] || [[ "$line" = \#* ]] || named["${line%%  *}"]=0
done <"$here/not_installed.txt"
for file in "${assets[@]}"; do
    installed=false pattern=
    grep -q "^$(sha256sum "$file" | cut -d ' ' -f 1)\$" "$folder/sums" && installed=true
    for one in "${!named[@]}"; do
        # shellcheck disable=SC2053  # a pattern
        [[ "$file" = $one ]] || continue
        pattern=$one
        named[$one]=$((named[$one] + 1))
    done
    $installed || [ -n "$pattern" ] || fail "$file: expected an install rule that takes it, or a line in not_installed.txt, found neither"
    if $installed && [ -n "$pattern" ]; then fail "$file: is installed, and yet not_installed.txt has '$pattern'"; fi
done
for one in "${!named[@]}"; do
    [ "${named[$one]}" -gt 0 ] || fail "not_installed.txt: expected a file that is called $one, found none"
done

# The table of licences names it, other than by the catch-all paragraph.
mapfile -t licensed < <(awk '/^Files:/ { on = 1; sub(/^Files:/, "") } /^[A-Z]/ && !/^Files:/ { on = 0 } on' assets/package/copyright.in |
    tr ' ' '\n' | grep '^assets/')
for file in "${assets[@]}"; do
    covered=false
    for one in "${licensed[@]}"; do
        # shellcheck disable=SC2053  # a pattern
        [[ "$file" = $one ]] && covered=true
    done
    $covered || fail "$file: expected a paragraph of assets/package/copyright.in that names it, found none"
done
# docs/licences.md lists each linked library and each required font.
for name in $(sed -n 's/^\(Depends\|Recommends\): //p' "$folder/onggi.control/control" | tr ',|' '\n\n' | awk '{ print $1 }'); do
    case $name in
    libxcursor1 | libxi6 | libxinerama1 | libxrandr2 | mesa-vulkan-drivers | vulkan-icd) ;;  # used by others, not linked
    *) grep -q "^|.*\`$name\`.*|.*|.*|$" docs/licences.md || fail "$name: expected its licence in docs/licences.md" ;;
    esac
done
echo "two packages of $(wc -l <"$folder/packed.txt") lines: the installed files, no more; ${#assets[@]} assets have a place or a reason"
