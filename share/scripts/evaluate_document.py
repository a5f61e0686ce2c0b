"""Puts tables between the markers of docs/evaluation.md; what people wrote there stays.

A place is <!-- measured: NAME --> ... <!-- end -->, where NAME is a log or `summary`.
"""
import json
import pathlib
import re

import evaluate_logs
import evaluate_tables

DOCUMENT = pathlib.Path("docs/evaluation.md")
RESULTS = pathlib.Path("docs/evaluation")
PLACE = re.compile(r"<!-- measured: ([\w-]+) -->\n(.*?)<!-- end -->\n", re.DOTALL)


def results(folder=RESULTS):
    """By log, in the order of evaluate_logs; logs that were never measured are left out."""
    files = {name: folder / f"{name}.json" for name in evaluate_logs.LOGS}
    return {name: json.loads(file.read_text()) for name, file in files.items() if file.exists()}


def filled(document, measured, peers):
    """The document with tables of what was measured; places of other logs stay as they are."""
    places = PLACE.findall(document)
    if document.count("<!-- measured:") != len(places):
        raise SystemExit(f"evaluate: a marker of {DOCUMENT} has no <!-- end --> of its own")
    unknown = [name for name, _ in places if name not in (*evaluate_logs.LOGS, "summary")]
    if unknown:
        raise SystemExit(f"evaluate: {DOCUMENT} has a place for '{unknown[0]}', which is no log")
    missing = [name for name in measured if name not in dict(places)]
    if missing:
        raise SystemExit(f"evaluate: {DOCUMENT} has no place <!-- measured: {missing[0]} -->")

    def fill(match):
        name = match.group(1)
        if name == "summary" and measured:
            lines = evaluate_tables.summary(measured)
        elif name in measured:
            lines = evaluate_tables.section(name, measured[name], peers)
        else:
            return match.group(0)
        body = "\n".join(lines)
        return f"<!-- measured: {name} -->\n\n{body}\n\n<!-- end -->\n"

    return PLACE.sub(fill, document)


def update():
    peers = evaluate_tables.read_peers(RESULTS / "peers.csv")
    text = filled(DOCUMENT.read_text(), results(), peers)
    new = DOCUMENT.with_suffix(".md.new")
    new.write_text(text)
    new.replace(DOCUMENT)
