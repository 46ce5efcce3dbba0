"""Checks the author's part of a CODECHECK: the configuration file specification 1.0, and the files of the community process.

Usage: validate_codecheck.py ARCHIVE.zip
Every rule is checked on the archive and on a copy with a planted fault, which it has to refuse.
Prints one line per rule, and the fields that are open; exit code 1 when a rule is broken or accepts its fault.
"""

import re
import sys
import zipfile

from ruamel.yaml import YAML

VERSION = "https://codecheck.org.uk/spec/config/1.0/"
ORCID = re.compile(r"\d{4}-\d{4}-\d{4}-\d{3}[\dX]")
NAME = "codecheck.yml"


def document(files):
    """The configuration file, as another program than slipmode reads it."""
    return YAML(typ="safe", pure=True).load(files[NAME].decode("utf-8"))


def replace(old, new, name=NAME):
    """A planted fault: another text for every place of a pattern."""

    def alter(files):
        text = files[name].decode("utf-8")
        altered = re.sub(old, new, text, flags=re.MULTILINE)
        assert altered != text, f"nothing to alter: {old}"
        files[name] = altered.encode("utf-8")

    return alter


def without(name):
    return lambda files: files.pop(name)


def latin_1(files):
    files[NAME] = files[NAME].replace(b"OPEN FIELD", b"\xe9").replace(b"title: \"", b"title: \"\xe9")


def manifest(files):
    return [item["file"] for item in document(files)["manifest"]]


def authors(files):
    return document(files)["paper"]["authors"]


RULES = [
    ("the file is codecheck.yml, next to all other files", lambda f: NAME in f, without(NAME)),
    ("it is UTF-8", lambda f: bool(f[NAME].decode("utf-8")), latin_1),
    ("three dashes begin the document", lambda f: b"\n---\n" in b"\n" + f[NAME], replace("^---$", "")),
    ("a directive states the version of YAML", lambda f: f[NAME].startswith(b"%YAML 1."), replace(r"\A%YAML 1.1\n", "")),
    ("`version` is the address of the specification", lambda f: document(f)["version"] == VERSION, replace("config/1.0", "config/0.1")),
    ("`manifest` is a list of files, not empty", lambda f: len(manifest(f)) > 0, replace("^manifest:", "files:")),
    ("each item has `file`", lambda f: all(isinstance(path, str) for path in manifest(f)), replace("- file:", "- path:")),
    (
        "a comment is a text",
        lambda f: all(isinstance(item.get("comment", ""), str) for item in document(f)["manifest"]),
        replace("comment: .*", "comment: [1]"),
    ),
    ("paths are relative to codecheck.yml", lambda f: not any(path.startswith(("/", "../")) for path in manifest(f)), replace('file: "', 'file: "/')),
    ("every file of the manifest is there", lambda f: all(path in f for path in manifest(f)), without("report/ledger.json")),
    (
        "all results are in the manifest",
        lambda f: sorted(manifest(f)) == sorted(path for path in f if path.startswith("report/")),
        replace('  - file: "report/ledger.json"\n    comment: .*\n', ""),
    ),
    ("`paper` has a title", lambda f: bool(document(f)["paper"]["title"].strip()), replace("^  title: .*$", '  title: ""')),
    ("`paper.authors` has at least one author, with a name", lambda f: len(authors(f)) > 0 and all(a["name"].strip() for a in authors(f)), replace("- name:", "- title:")),
    (
        "an ORCID is plain, without an address",
        lambda f: all(ORCID.fullmatch(author.get("ORCID", "0000-0002-1825-0097")) for author in authors(f)),
        replace("(- name: .*)$", r"\1\n    ORCID: https://orcid.org/0000-0002-1825-0097"),
    ),
    ("`reference` is a text", lambda f: isinstance(document(f)["paper"].get("reference", ""), str), replace(r"^  title: (.*)$", r"  title: \1\n  reference: [1]")),
    ("README says how to run the workflow", lambda f: "`slipmode report input" in f["README.md"].decode("utf-8"), without("README.md")),
    ("LICENSE names the licences, and their texts are there", lambda f: all(name in f for name in re.findall(r"LICENSE-[A-Z0-9]+", f["LICENSE"].decode())), without("LICENSE-MIT")),
]


def holds(rule, files):
    """Whether a rule holds; what cannot be read breaks it."""
    try:
        return rule(files)
    except Exception:  # Whatever a parser raises.
        return False


def main():
    with zipfile.ZipFile(sys.argv[1]) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    broken = 0
    for name, rule, fault in RULES:
        altered = dict(files)
        fault(altered)
        found = (holds(rule, files), holds(rule, altered))
        word = {(True, False): "holds", (True, True): "ACCEPTS ITS FAULT"}.get(found, "BROKEN")
        broken += word != "holds"
        print(f"{word}: {name}")
    for line in files.get(NAME, b"").decode("utf-8", "replace").splitlines():
        if "OPEN FIELD" in line:
            print(f"open: {line.strip()}")
    print(f"{len(RULES)} rules, {broken} broken")
    return 1 if broken else 0


sys.exit(main())
