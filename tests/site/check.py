# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""python3 check.py PROJECT FOLDER: builds the site of docs/ in FOLDER with MkDocs, strictly, and checks that each page is in its
navigation and its search, that each link leads to a file, and to a heading, that is there, and that a page loads
nothing from elsewhere. Prints as GoogleTest does."""

import html.parser
import json
import os
import pathlib
import re
import subprocess
import sys
import urllib.parse

project, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
faults = []


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.names, self.links, self.loaded, self.tables, self.text = set(), [], [], 0, ""
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.names |= {given[key] for key in ("id", "name") if given.get(key)}
        self.tables += tag == "table" and not attributes  # MkDocs' own has a class
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        if tag in ("img", "script", "iframe") and given.get("src"):
            self.loaded.append(given["src"])
        if tag == "link" and given.get("href"):
            self.loaded.append(given["href"])

    def handle_data(self, data):
        self.text += data


built = subprocess.run(["mkdocs", "build", "--strict", "--clean", "--site-dir", str(folder)], cwd=project, text=True,
                       stderr=subprocess.PIPE)
if built.returncode != 0:
    faults.append(built.stderr)
if "not included in the \"nav\"" in built.stderr:
    faults.append(built.stderr)

pages = {path: Page(path) for path in folder.glob("*.html")}
for path, page in pages.items():
    if path.name == "404.html":  # MkDocs' own, with links from the top of a server
        continue
    for link in page.links + page.loaded:
        target = urllib.parse.urlsplit(link)
        if target.scheme or target.netloc:
            if link in page.loaded:
                faults.append(f"{path.name} loads {link}")
            continue
        to = pathlib.Path(os.path.normpath(folder / urllib.parse.unquote(target.path))) if target.path else path
        if not to.exists() or to.is_dir():
            faults.append(f"{path.name}: no {link}")
        elif target.fragment and to.suffix == ".html" and urllib.parse.unquote(target.fragment) not in pages[to].names:
            faults.append(f"{path.name}: no heading {link}")
    if re.search(r"^\|[ :-]*-+[ :-]*\|", page.text, re.MULTILINE):
        faults.append(f"{path.name}: a table that is none")

search = folder / "search" / "search_index.json"
found = {entry["location"].split("#")[0] for entry in json.loads(search.read_text())["docs"]} if search.exists() else set()
sources = [*project.glob("docs/*.md"), *(project / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md"))]
for source in sources:
    name = "index.html" if source.name == "README.md" else source.stem + ".html"
    if folder / name not in pages:
        faults.append(f"no page {name}")
    elif name not in found and not (name == "index.html" and "" in found):
        faults.append(f"{name} is not searched")
    else:  # MkDocs wants a blank line before a table, which others do not
        rows = re.findall(r"^\|[ :|-]*-[ :|-]*\|$", source.read_text(encoding="utf-8"), re.MULTILINE)
        if len(rows) != pages[folder / name].tables:
            faults.append(f"{name} has {pages[folder / name].tables} of {len(rows)} tables")

print("\n".join(faults))
print("[  FAILED  ] 1 test, listed below:" if faults else "[  PASSED  ] 1 test.")
sys.exit(bool(faults))
