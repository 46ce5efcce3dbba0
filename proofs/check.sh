#!/bin/sh
# Checks the theorems of this folder: files and statements against accepted.txt, then every proof and what it assumes with Coq.
# It needs coqc and the usual commands of a shell (awk, sed, sort, tsort, paste, find, sha256sum). README.md says what it shows.
#
#   sh check.sh [SHA256]      SHA256: that of an accepted.txt you trust; another one ends the check
#
# Exit codes: 0 all accepted, 1 a file or theorem is not what was accepted, 2 something is missing on this machine.
set -eu
unset CDPATH
LC_ALL=C
export LC_ALL
cd "$(dirname "$0")"

# What Coq's library of real numbers assumes; a theorem may assume no more.
allowed='ClassicalDedekindReals.sig_forall_dec
ClassicalDedekindReals.sig_not_dec
FunctionalExtensionality.functional_extensionality_dep
Classical_Prop.classic'

# The lemmas that a file of a report may have besides its theorems; no other name of them hides one of the library or of Coq.
own='growth_right root_part_lt root_part_le root_part_other_lt root_part_other_le'

# With what a sentence outside of a proof, or a command inside of one, may begin.
sentences='Definition End Export Fixpoint Import Lemma Let Ltac Module Proof Qed Section Theorem Variable Variables Hypotheses Open'

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 2' HUP INT TERM

refuse() {
    printf 'check.sh: %s\n' "$*" >&2
    exit 1
}

# The first line of a list of faults, if there is one.
refuse_first() {
    if [ -s "$1" ]; then refuse "$(sed -n 1p "$1")"; fi
}

needs() {
    command -v "$1" >/dev/null || { echo "check.sh: $1 is not installed" >&2; exit 2; }
}
for command in awk sed sort tsort paste find sha256sum; do needs "$command"; done

# --- 1. The lists, and the files that they name.
for list in accepted.txt files.txt; do
    [ -f "$list" ] && [ ! -L "$list" ] || refuse "$list is missing"
    printf '%s has the SHA-256 %s\n' "$list" "$(sha256sum <"$list" | sed 's/ .*//')"
done
if [ $# -gt 0 ] && [ "$(sha256sum <accepted.txt)" != "$1  -" ]; then
    refuse "accepted.txt does not have the SHA-256 $1"
fi
find . ! -type f ! -type d | sed 's|^\./||; s|$| is neither a file nor a folder|' >"$work/faults"
refuse_first "$work/faults"
find . -type f | sed 's|^\./||' | grep -vxF -e accepted.txt -e files.txt -e left-out.txt -e check.sh -e README.md | sort >"$work/names"
awk '!/^[A-Za-z0-9_-]+\/[A-Za-z0-9_]+\.v$/ { print $0 " does not belong to the theorems" }' "$work/names" >"$work/faults"
refuse_first "$work/faults"
while read -r file; do
    printf '%s %s\n' "$file" "$(sha256sum <"$file" | sed 's/ .*//')"
done <"$work/names" >"$work/found"
# Each file is the one that files.txt lists, and the one that accepted.txt lists if it lists any. Of the library, and of a report that
# accepted.txt lists, all files are there and no other.
awk -v moved="$work/moved" '
    function folder(path) { sub(/\/.*/, "", path); return path }
    FILENAME == ARGV[1] { found[$1] = $2; has[folder($1)] = 1; next }
    FILENAME == ARGV[2] { listed[$2] = $1; next }
    $1 ~ /\// { accepted[$1] = $2; known[folder($1)] = 1 }
    END {
        for (path in listed) if (!(path in found)) print path " is missing"
        for (path in accepted) if ((folder(path) == "library" || folder(path) in has) && !(path in found)) print path " is missing"
        for (path in found) {
            if (!(path in listed)) print path " is not in files.txt"
            else if (listed[path] != found[path]) print path " is not the file of files.txt" >moved
            if (path in accepted) { if (accepted[path] != found[path]) print path " is not the file of accepted.txt" >moved }
            else if (folder(path) in known) print path " is not in accepted.txt"
        }
    }
' "$work/found" files.txt accepted.txt | sort >"$work/faults"
refuse_first "$work/faults"

# --- 2. What the files say: no sentence that assumes or changes how others are read, and the accepted statements.
mkdir "$work/statements"
while read -r file; do
    # Comments are taken out; they may lie in each other. A text in quotation marks could hide the end of one, and no file needs any.
    awk -v file="$file" -v out="$work/plain" '
        { text = text $0 "\n" }
        END {
            if (text ~ /"/) { print file ": has a quotation mark"; exit }
            depth = 0
            while (match(text, /\(\*|\*\)/)) {
                mark = substr(text, RSTART, 2)
                if (depth == 0) plain = plain substr(text, 1, RSTART - 1) (mark == "(*" ? " " : mark)
                if (mark == "(*") depth++
                else if (depth > 0) depth--
                text = substr(text, RSTART + 2)
            }
            if (depth > 0) print file ": a comment does not end"
            printf "%s", plain text >out
        }
    ' "$file" >"$work/faults"
    refuse_first "$work/faults"
    awk -v file="$file" -v sentences="$sentences" -v own="$own" -v folder="$work/statements" -v list="$work/theorems" -v all="$work/lemmas" '
        function fault(text) { print file ": " place text; exit }
        BEGIN {
            RS = "\001"
            count = split(sentences, words, " ")
            for (i = 1; i <= count; i++) may_begin[words[i]] = 1
            count = split(own, words, " ")
            for (i = 1; i <= count; i++) is_own[words[i]] = 1
        }
        {
            # A sentence ends with a full stop before a space.
            text = $0 " "
            while (match(text, /\.[ \t\n]/)) {
                sentence = substr(text, 1, RSTART - 1)
                text = substr(text, RSTART + 1)
                sub(/^[ \t\n]+/, "", sentence)
                if (sentence ~ /(^|[^A-Za-z0-9_\047])(admit|give_up|Admitted|Axioms?|Parameters?|Conjectures?|Declare|Unset|Abort|Redirect|Load|Drop|bypass_check)($|[^A-Za-z0-9_\047])/)
                    fault("assumes, or changes the rules: " sentence)
                head = sentence
                sub(/^[-+*{} \t\n]+/, "", head)
                word = head
                sub(/[^A-Za-z0-9_\047].*/, "", word)
                if (word == "From") {
                    if (head !~ /^From (Coq|Coquelicot|Interval|Slipmode)[A-Za-z.]* Require (Import|Export) [A-Za-z0-9_. \n]+$/) fault("imports something else: " head)
                } else if (word == "Set") {
                    if (head !~ /^Set Default Timeout [0-9]+$/) fault("changes the rules: " head)
                } else if (word == "Print") {
                    if (head !~ /^Print Assumptions all_theorems$/) fault("prints something else: " head)
                } else if (head != "" && word !~ /^[a-z0-9]/ && !(word in may_begin)) fault("has a sentence that is not allowed: " head)
                # Lemmas and theorems of a report have names of their own kind, so that they hide nothing.
                if (word == "Theorem" || word == "Lemma") {
                    name = head
                    sub(/^[A-Za-z]+[ \n]+/, "", name)
                    rest = name
                    sub(/[^A-Za-z0-9_\047].*/, "", name)
                    rest = substr(rest, length(name) + 1)
                    place = name ": "
                    if (file !~ /^library\// && name !~ /^[a-z]+_[0-9a-f]+(_substituted)?$/ && !(word == "Lemma" && name in is_own))
                        fault("is a name that may hide another one")
                    print file, name >>all
                    if (word == "Theorem") {
                        if (file !~ /^library\//) {
                            printf "%s", rest >(folder "/" name)
                            close(folder "/" name)
                        }
                        print file, name >>list
                    }
                } else if (file !~ /^library\// && word != "Proof" && word != "Qed" && word !~ /^(From|Set|Print)$/ && word !~ /^[a-z0-9]/) {
                    if (head !~ /^Definition all_theorems := \([A-Za-z0-9_, \n]+\)$/ && head != "") fault("has a sentence that is not allowed: " head)
                }
                if (word == "Qed") place = ""
            }
            if (text !~ /^[ \t\n]*$/) fault("does not end with a full stop")
        }
    ' "$work/plain" >"$work/faults"
    refuse_first "$work/faults"
done <"$work/names"
[ -s "$work/theorems" ] || refuse "there is no theorem"
awk '{ print $2 }' "$work/theorems" | while read -r name; do
    [ -f "$work/statements/$name" ] || continue
    printf '%s %s\n' "$name" "$(sha256sum <"$work/statements/$name" | sed 's/ .*//')"
done >"$work/stated"
awk -v own="$work/new" '
    FILENAME == ARGV[1] { if ($1 !~ /\//) { accepted[$1 " " $2] = 1; known[$1] = 1 } next }
    ($1 in known) && !(($1 " " $2) in accepted) { print $1 ": does not state what accepted.txt lists" }
    !($1 in known) { print $1 >own }
' accepted.txt "$work/stated" >"$work/faults"
refuse_first "$work/faults"
# A file that is another one is named last: its theorem at fault says more.
[ ! -f "$work/moved" ] || sort "$work/moved" >"$work/faults"
refuse_first "$work/faults"

# --- 3. Coq proves everything, in a folder of its own.
needs coqc
with_coq() { # the folder of the file's module, its name for Coq, the file
    (cd "$work/folder" && coqc -q -noglob -w -all -Q library Slipmode -Q "$1" "$2" "$3") >"$work/said" 2>&1
}
cp -R . "$work/folder"
awk '
    FNR == 1 { module = FILENAME; sub(/.*\//, "", module); sub(/\.v$/, "", module); print module, module }
    /^From Slipmode Require / { sub(/\.$/, ""); for (i = 5; i <= NF; i++) print $i, module }
' library/*.v >"$work/imports"
tsort "$work/imports" >"$work/order" 2>"$work/said" || refuse "library: $(sed -n 1p "$work/said")"
sed 's|.*|library/&.v|' "$work/order" >"$work/files"
grep -v '^library/' "$work/names" >>"$work/files" || :
needs_library() { # one of its modules
    grep -q "^From $1[. ]" library/*.v || return 0
    printf 'From %s Require %s.\n' "$1" "$2" >"$work/folder/asked.v"
    with_coq library Slipmode asked.v || { echo "check.sh: Coq's library $1 is not installed" >&2; exit 2; }
}
needs_library Coquelicot Coquelicot
needs_library Interval Tactic
assumes_no_more() { # terms of the module, with commas between them
    printf 'From %s Require %s.\nDefinition asked := (%s).\nPrint Assumptions asked.\n' \
        "$prefix" "$module" "$1" >"$work/folder/asked.v"
    with_coq "$place" "$prefix" asked.v || {
        cat "$work/said" >&2
        printf '%s\n' "$1: Coq does not know it" >"$work/faults"
        return 1
    }
    printf '%s\n' "$allowed" | awk '
        FILENAME == "-" { allowed[$1] = 1; next }
        /^(Axioms:|Closed under the global context)/ { listed++; next }
        /^[^ ]/ {
            axiom = $1
            sub(/:$/, "", axiom)
            if (!(axiom in allowed)) print
        }
        END { if (listed != 1) print "Coq has not said what" }
    ' - "$work/said" >"$work/faults"
    [ ! -s "$work/faults" ]
}
# A file at fault does not end the check: all of them are listed at its end.
keep() { printf '%s\n' "$*" >>"$work/refused"; }
while read -r file; do
    [ -f "$file" ] || refuse "$file is missing"
    case $file in
        library/*) prefix=Slipmode place=library ;;
        *) prefix=Report place=${file%%/*} ;;
    esac
    with_coq "$place" "$prefix" "$file" || {
        cat "$work/said" >&2
        keep "$file: Coq does not accept it"
        continue
    }
    # What the theorems and lemmas assume is asked of Coq anew: what the file itself prints could be about other ones.
    module=${file##*/}
    module=${module%.v}
    awk -v file="$file" -v prefix="@$prefix.$module." '$1 == file { print prefix $2 }' "$work/lemmas" >"$work/asked"
    [ -s "$work/asked" ] || continue
    if ! assumes_no_more "$(paste -sd , "$work/asked")"; then
        fault="assumes more: $(sed -n 1p "$work/faults")"
        while read -r name; do
            assumes_no_more "$name" || { fault="${name##*.}: assumes more: $(sed -n 1p "$work/faults")"; break; }
        done <"$work/asked"
        keep "$file: $fault"
        continue
    fi
    printf 'accepted %s\n' "$file"
done <"$work/files"

# --- 4. What was shown.
count() { sed -n '$=' "$1" 2>/dev/null || :; }
if [ -s "$work/refused" ]; then
    printf 'check.sh: %s of %s files are refused:\n' "$(count "$work/refused")" "$(count "$work/files")" >&2
    sed 's/^/check.sh: /' "$work/refused" >&2
    exit 1
fi
all=$(count "$work/theorems")
new=$(count "$work/new")
printf 'Coq accepts all %s theorems. They assume at most:\n%s\n' "$all" "$allowed"
printf '%s of them are not in accepted.txt: compare the SHA-256 of files.txt, or read them.\n' "${new:-0}"
