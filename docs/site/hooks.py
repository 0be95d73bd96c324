# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""What MkDocs needs to know of pages that are read where they lie as well: those at the top belong to the
site, files of the repository that a page links to come along, and a link to a folder is its text."""

import os
import re

from mkdocs.structure.files import File

PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
LINK = re.compile(r"(!?\[(?:[^\[\]]|\[[^\]]*\])*\])\(([^()\s]+)\)")


def top(config):
    return os.path.dirname(os.path.abspath(config["config_file_path"]))


def in_repository(link, page, config):
    """Where a link of a page leads, from the top of the repository; None: elsewhere, or to a heading of the page."""
    target = link.split("#")[0]
    if not target or re.match(r"[a-z]+:", link):
        return None
    folder = os.path.dirname(page.abs_src_path)
    return os.path.relpath(os.path.join(folder, target), top(config))


def in_site(path):
    """Where a file of the repository is in the site: the folder docs is its top."""
    return path[len("docs/"):] if path.startswith("docs/") else path


def add(files, path, config):
    if files.get_file_from_path(path) is None:
        files.append(File(path, top(config), config["site_dir"], config["use_directory_urls"]))


def on_files(files, config):
    for file in [file for file in files if file.src_uri.startswith("site/") or file.src_uri.endswith("/head.md")]:
        files.remove(file)  # not pages by themselves
    for path in PAGES:
        add(files, path, config)
    for page in list(files.documentation_pages()):
        with open(page.abs_src_path, encoding="utf-8") as text:
            links = LINK.findall(text.read())
        for path in filter(None, (in_repository(link, page, config) for _, link in links)):
            if os.path.isfile(os.path.join(top(config), path)) and not path.startswith("docs/"):
                add(files, path, config)
    return files


def on_page_markdown(markdown, page, config, files):
    def moved(match):
        text, link = match.groups()
        path = in_repository(link, page.file, config)
        if path is None:
            return match[0]
        if os.path.isdir(os.path.join(top(config), path)):
            return text[1:-1]
        heading = link[link.index("#"):] if "#" in link else ""
        return f"{text}({os.path.relpath(in_site(path), os.path.dirname(page.file.src_uri) or '.')}{heading})"

    return LINK.sub(moved, markdown)
