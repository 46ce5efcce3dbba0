"""Validates an RO-Crate folder without a network: the JSON-LD context comes from the `rocrate` package.

Usage: validate_crate.py CRATE_FOLDER PROFILE
Prints one line per issue and ends with their number; exit code 1 when there is any.
"""

import io
import json
import pathlib
import sys
import urllib.request

import rocrate
from rocrate_validator import models, services
from rocrate_validator.utils.http import HttpRequester

CONTEXT_URL = "https://w3id.org/ro/crate/1.1/context"
#: What has no answer before the program has an address: no address of the program or of its authors is known.
OPEN = {"process-run-crate-0.5_5.1", "ro-crate-1.1_31.2"}
CONTEXT = (pathlib.Path(rocrate.__file__).parent / "data" / "ro-crate.jsonld").read_bytes()


class Answer(io.BytesIO):
    """The context, as both HTTP clients of the validator expect an answer."""

    status_code = 200
    ok = True
    headers = {"Content-Type": "application/ld+json"}
    url = CONTEXT_URL

    @property
    def content(self):
        return self.getvalue()

    @property
    def text(self):
        return self.getvalue().decode()

    def json(self):
        return json.loads(self.getvalue())

    def info(self):
        return self.headers

    def geturl(self):
        return self.url

    def raise_for_status(self):
        return None


def answer(request):
    url = request if isinstance(request, str) else request.full_url
    if url.split("#")[0] != CONTEXT_URL:
        raise OSError(f"{url}: nothing is fetched")
    return Answer(CONTEXT)


urllib.request.urlopen = lambda request, *rest, **options: answer(request)
HttpRequester.get = lambda self, url, *rest, **options: answer(url)

import rdflib.parser
import rdflib._networking

rdflib.parser._urlopen = lambda request: answer(request)
rdflib._networking._urlopen = lambda request: answer(request)

folder, profile = sys.argv[1:]
result = services.validate(
    services.ValidationSettings(
        rocrate_uri=folder,
        profile_identifier=profile,
        requirement_severity=models.Severity.RECOMMENDED,
    )
)
issues = [issue for issue in result.get_issues() if issue.check.identifier not in OPEN]
for issue in issues:
    print(f"{issue.severity.name} {issue.check.identifier}: {issue.message}")
print(f"{len(issues)} issues")
sys.exit(1 if issues else 0)
