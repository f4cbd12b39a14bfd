#!/usr/bin/env bash
# Package: csvkit 1.0.7-1 with python3-agate 1.6.3-2; python3-pint 0.19.2-1 (Debian 12).
# Behaviour: a quoted cell "6,8" is the number 68 for csvsort, csvjson and csvstat: a comma anywhere groups digits. pint, a
# library of units, takes "6,8 cm" as 68 cm by the same rule. Neither wants three digits behind the comma.
# Expected: the cell stays a text, since 6,8 groups nothing; at the least a word about the one or the other reading.
# Why it matters: museums of half of Europe write their sizes so. A table that was only sorted comes back with cups of
# 68 cm, each size wrong by its own power of ten. Say --locale de_DE, or --no-inference, and let a reader refuse commas.
# Seen:
#   sorted: 68 and 125; told the locale: 6.8 and 12.5; 6,8 cm in pint: 68 centimeter
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download csvkit=1.0.7-1 python3-csvkit=1.0.7-1 python3-agate=1.6.3-2 python3-agateexcel=0.2.5-2 \
    python3-agatesql=0.5.8-2 python3-agatedbf=0.2.2-2 python3-babel=2.10.3-1 python-babel-localedata=2.10.3-1 \
    python3-isodate=0.6.1-1 python3-leather=0.3.4-2 python3-parsedatetime=2.6-3 python3-pytimeparse=1.1.5-3 \
    python3-slugify=4.0.0-2 python3-six=1.16.0-4 python3-tz=2022.7.1-4 python3-pint=0.19.2-1 \
    python3-unidecode=1.3.6-1
for package in *.deb; do dpkg-deb -x "$package" .; done
export PYTHONPATH=$folder/usr/lib/python3/dist-packages
printf 'pot,height\nCup,"6,8"\nJar,"12,5"\n' >pots.csv
# heights OPTION...: the column of the sorted table.
heights() {
    /usr/bin/python3 -W ignore usr/bin/csvsort -c pot "$@" pots.csv | awk -F, 'NR > 1 { printf "%s%s", between, $2; between = " and " }'
}
saw="sorted: $(heights); told the locale: $(heights --locale de_DE)"
saw="$saw; 6,8 cm in pint: $(/usr/bin/python3 -W ignore -c 'import pint; print(pint.UnitRegistry()("6,8 cm"))')"
echo "saw: $saw"
[ "$saw" = "sorted: 68 and 125; told the locale: 6.8 and 12.5; 6,8 cm in pint: 68 centimeter" ]
