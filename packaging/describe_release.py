#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes the notes of a release, and a list of what is linked into it.

usage: describe_release.py FOLDER VERSION

FOLDER has the release's .tar.gz, which has the licence of each library that the program is linked with. The list is SPDX 2.3
as JSON, clipc-VERSION.spdx.json, and the notes are the section of CHANGELOG.md, clipc-VERSION.md."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tarfile
from datetime import UTC, datetime

ROOT = pathlib.Path(__file__).resolve().parents[1]


def notes(version):
    """The section of that version, or of what comes next."""
    text = (ROOT / "CHANGELOG.md").read_text()
    sections = re.split(r"^## (.*)\n", text, flags=re.M)[1:]
    named = dict(zip(sections[0::2], sections[1::2], strict=True))
    if version not in named:
        sys.exit(f"CHANGELOG.md has no section {version}")
    return f"# clipc {version}\n{named[version]}"


def linked(archive):
    """The names of Debian's packages whose code is in the program."""
    with tarfile.open(archive) as tar:
        found = re.compile(r".*/share/doc/clipc/linked/([^/]+)")
        return sorted(match[1] for name in tar.getnames() if (match := found.fullmatch(name)))


def version_of(package):
    """The version of a Debian package that is installed here."""
    return subprocess.run(
        ["dpkg-query", "-W", "-f", "${Version}", package],
        capture_output=True,
        text=True,
        check=True,
    ).stdout


def element(name, version, licence, reference=None):
    found = {
        "SPDXID": f"SPDXRef-{re.sub(r'[^A-Za-z0-9.-]', '-', name)}",
        "name": name,
        "versionInfo": version,
        "downloadLocation": "NOASSERTION",
        "licenseConcluded": licence,
        "licenseDeclared": licence,
        "copyrightText": "NOASSERTION",
        "filesAnalyzed": False,
    }
    if reference:
        found["externalRefs"] = [
            {
                "referenceCategory": "PACKAGE-MANAGER",
                "referenceType": "purl",
                "referenceLocator": reference,
            }
        ]
    return found


def bill(archive, version):
    """What the program is made of, as SPDX 2.3."""
    parts = [element("clipc", version, "Apache-2.0 WITH LLVM-exception")]
    for name in linked(archive):
        installed = version_of(name)
        purl = f"pkg:deb/debian/{name}@{installed}"
        parts.append(element(name, installed, "NOASSERTION", purl))
    time = datetime.fromtimestamp(int(os.environ["SOURCE_DATE_EPOCH"]), UTC)
    return {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"clipc-{version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/clipc-{version}",
        "creationInfo": {
            "created": time.strftime("%Y-%m-%dT%H:%M:%SZ"),
            "creators": ["Organization: clipc"],
        },
        "packages": parts,
        "relationships": [
            {
                "spdxElementId": "SPDXRef-DOCUMENT",
                "relationshipType": "DESCRIBES",
                "relatedSpdxElement": parts[0]["SPDXID"],
            },
            *(
                {
                    "spdxElementId": parts[0]["SPDXID"],
                    "relationshipType": "STATIC_LINK",
                    "relatedSpdxElement": part["SPDXID"],
                }
                for part in parts[1:]
            ),
        ],
    }


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder, version = pathlib.Path(sys.argv[1]), sys.argv[2]
    archive = next(folder.glob("clipc-*-Linux.tar.gz"))
    text = json.dumps(bill(archive, version), indent=1) + "\n"
    (folder / f"clipc-{version}.spdx.json").write_text(text)
    (folder / f"clipc-{version}.md").write_text(notes(version))


if __name__ == "__main__":
    main()
