"""Checks codemeta.json and .zenodo.json: their form, and that they say what cffconvert makes of CITATION.cff.

Usage: validate_metadata.py REPOSITORY
Prints one line per fault and ends with their number; exit code 1 when there is any. Every check has to refuse a planted fault.
"""

import copy
import json
import pathlib
import sys

import jsonschema
from cffconvert import Citation

TEXT = {"type": "string", "minLength": 1}
ORCID = {"type": "string", "pattern": r"^\d{4}-\d{4}-\d{4}-\d{3}[\dX]$"}


def record(required, **properties):
    return {"type": "object", "required": required, "properties": properties, "additionalProperties": False}


def many(item):
    return {"type": "array", "minItems": 1, "items": item}


#: The fields of a deposit of Zenodo that a program needs.
ZENODO = record(
    ["upload_type", "access_right", "title", "description", "creators", "license", "version"],
    upload_type={"const": "software"},
    access_right={"const": "open"},
    title=TEXT,
    description=TEXT,
    version=TEXT,
    license={"enum": ["MIT", "Apache-2.0"]},
    keywords=many(TEXT),
    creators=many(record(["name"], name=TEXT, affiliation=TEXT, orcid=ORCID)),
    references=many(TEXT),
)
PERSON = record(["type", "familyName"], type={"const": "Person"}, familyName=TEXT, givenName=TEXT)
GROUP = record(["type", "name"], type={"const": "Organization"}, name=TEXT)
#: The terms of CodeMeta 3.0 that we use.
CODEMETA = record(
    ["@context", "type", "name", "description", "version", "license", "author", "programmingLanguage"],
    **{"@context": {"const": "https://w3id.org/codemeta/3.0"}},
    type={"const": "SoftwareSourceCode"},
    name=TEXT,
    alternateName=TEXT,
    description=TEXT,
    version=TEXT,
    license=many({"type": "string", "pattern": "^https://spdx.org/licenses/[A-Za-z0-9.-]+$"}),
    keywords=many(TEXT),
    programmingLanguage=many(TEXT),
    softwareRequirements=TEXT,
    author=many({"anyOf": [PERSON, GROUP]}),
    citation=many(record(["type", "name", "author"], type={"const": "ScholarlyArticle"}, name=TEXT, author=many(PERSON))),
)


def faults(schema, ours, converted, same):
    """The faults of one file: of its form, and of what differs from the conversion."""
    found = [error.message for error in jsonschema.Draft7Validator(schema).iter_errors(ours)]
    for key, read in same.items():
        if read(ours) != converted[key]:
            found.append(f"{key}: {read(ours)!r}, but CITATION.cff says {converted[key]!r}")
    return found


def main():
    root = pathlib.Path(sys.argv[1])
    citation = Citation((root / "CITATION.cff").read_text())
    zenodo, codemeta = json.loads(citation.as_zenodo()), json.loads(citation.as_codemeta())
    zenodo["license"] = zenodo["license"]["id"][0]
    codemeta["author"] = [author["name"] for author in codemeta["author"]]
    as_is = lambda key: lambda ours: ours[key]
    checks = [
        (".zenodo.json", ZENODO, zenodo, {key: as_is(key) for key in ("title", "version", "keywords", "creators", "license")}),
        (
            "codemeta.json",
            CODEMETA,
            codemeta,
            {key: as_is(key) for key in ("name", "version", "keywords")} | {"author": lambda ours: [a["name"] for a in ours["author"]]},
        ),
    ]
    count = 0
    for path, schema, converted, same in checks:
        ours = json.loads((root / path).read_text())
        found = faults(schema, ours, converted, same)
        for key in ("version", *same):
            altered = copy.deepcopy(ours)
            altered[key] = [{"name": "Somebody"}] if key in ("creators", "author") else "0"
            if not faults(schema, altered, converted, same):
                found.append(f"another {key} is not noticed")
        for fault in found:
            print(f"{path}: {fault}")
        count += len(found)
    print(f"{count} faults")
    return 1 if count else 0


sys.exit(main())
