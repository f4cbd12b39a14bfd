# kiosk.toml(5) of the commented settings: awk -v named=VERSION -v day=YYYY-MM-DD -f kiosk_toml.awk assets/kiosk.toml
# assets/install/kiosk.toml. A line there that it does not understand ends it with 1 and one line.

# Letter by letter, as troff would otherwise make dashes, escapes and requests of them.
function troff(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    sub(/^[.']/, "\\\\\\&&", text)
    return text
}
function sentence(text) {
    # Not the name of a file.
    if (text !~ /^[^ ]*[.\/]/) text = toupper(substr(text, 1, 1)) substr(text, 2)
    return text ~ /[.]$/ ? text : text "."
}
function refuse() {
    printf "%s, line %d: expected a comment, a [section] or KEY = VALUE  # what it is, found: %s\n", FILENAME, FNR, $0 >"/dev/stderr"
    failed = 1
    exit 1
}
BEGIN {
    print ".\\\" Written at installing from the commented settings."
    printf ".TH KIOSK.TOML 5 %s \"%s\" \"File Formats\"\n", day, troff(named)
    print ".SH NAME\nkiosk.toml \\- settings of an Onggi kiosk\n.SH DESCRIPTION"
}
FNR == 1 { files++ }
# The second file: what an installed kiosk begins with, as it is.
files == 2 {
    if (FNR == 1) print ".SH AS INSTALLED\n/etc/onggi/kiosk.toml begins as:\n.PP\n.nf"
    print troff($0)
    next
}
/^#[^ ]* *[a-z_]+ = / && !/^# / { sub(/^#/, "") }
/^# / { print troff(substr($0, 3)); next }
/^$/ { next }
/^\[[a-z]+\]/ {
    section = substr($1, 2, length($1) - 2)
    printf ".SH [%s]\n", section
    if (match($0, /# /)) print troff(sentence(substr($0, RSTART + 2)))
    next
}
/^[a-z_]+ = .*# / {
    comment = $0
    sub(/^[^#]*# /, "", comment)
    value = $0
    sub(/ *# .*$/, "", value)
    printf ".TP\n\\fB%s\\fR\n%s\n", troff(value), troff(sentence(comment))
    next
}
# One that needs no words.
/^[a-z_]+ = [^#]*$/ {
    printf ".TP\n\\fB%s\\fR\n\\&\n", troff($0)
    next
}
{ refuse() }
END {
    if (failed) exit 1
    print ".fi\n.SH FILES\n.TP\n/etc/onggi/kiosk.toml\nThe settings of the installed kiosk; it begins with those and is then the museum's."
    print ".TP\n/usr/share/onggi/kiosk\\-settings.toml\nThe settings above, to copy from.\n.SH SEE ALSO\n.BR onggi (1),\n.BR onggi\\-kiosk (8)"
}
