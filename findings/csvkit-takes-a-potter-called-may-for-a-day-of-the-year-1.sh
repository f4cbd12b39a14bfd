#!/usr/bin/env bash
# Package: csvkit 1.0.7-1 with python3-agate 1.6.3-2 and python3-parsedatetime 2.6-3 (Debian 12).
# Behaviour: a column whose cells are all names of months (May, April, August) is a column of dates for csvsort and csvjson:
# the first of the month in the year 1, and sorted by it. One more name that is no month, and the column stays as it is.
# Expected: text; a date needs a day or a year, and a tool that sorts leaves the cells alone.
# Why it matters: a list of makers changes as rows are filtered: with Chun the potters are May and April, without her they
# are 0001-05-01 and 0001-04-01, in a gallery's labels too. Say --no-inference for tables of names.
# Seen:
#   with Chun: April, Chun, May; without: 0001-04-01, 0001-05-01
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download csvkit=1.0.7-1 python3-csvkit=1.0.7-1 python3-agate=1.6.3-2 python3-agateexcel=0.2.5-2 \
    python3-agatesql=0.5.8-2 python3-agatedbf=0.2.2-2 python3-babel=2.10.3-1 python-babel-localedata=2.10.3-1 \
    python3-isodate=0.6.1-1 python3-leather=0.3.4-2 python3-parsedatetime=2.6-3 python3-pytimeparse=1.1.5-3 \
    python3-slugify=4.0.0-2 python3-six=1.16.0-4 python3-tz=2022.7.1-4 python3-unidecode=1.3.6-1
for package in *.deb; do dpkg-deb -x "$package" .; done
export PYTHONPATH=$folder/usr/lib/python3/dist-packages
# sorted NAME...: a table of potters and their pots, sorted by potter: its first column.
sorted() {
    { echo potter,pots; printf '%s,7\n' "$@"; } | /usr/bin/python3 -W ignore usr/bin/csvsort -c potter |
        awk -F, 'NR > 1 { printf "%s%s", between, $1; between = ", " }'
}
saw="with Chun: $(sorted May Chun April); without: $(sorted May April)"
echo "saw: $saw"
[ "$saw" = "with Chun: April, Chun, May; without: 0001-04-01, 0001-05-01" ]
