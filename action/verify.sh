#!/bin/sh
# Verifies a report: verify.sh DIR FILE.xml
# Writes the result in the form of JUnit, and its text to the summary of a workflow where there is one ($GITHUB_STEP_SUMMARY).
# The exit code is that of `slipmode verify`.
set -u
text=$(slipmode verify "$1" --junit "$2" --quiet 2>&1)
code=$?
printf '%s\n' "$text"
if [ -n "${GITHUB_STEP_SUMMARY:-}" ]; then
    { printf '### slipmode verify %s: %s\n\n' "$1" "$([ "$code" -eq 0 ] && echo passed || echo failed)"
      printf '%s\n' "$text" | sed 's/^/    /'; } >>"$GITHUB_STEP_SUMMARY"
fi
exit "$code"
