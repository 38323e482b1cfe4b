"""A run as files: JSON of everything, markdown of what is read."""

import datetime
import json

KINDS = (("evaluation", "evaluation, ns"), ("chain", "chained, ns"), ("step", "step of RK4, ns"))


def write(results, folder, date=None):
    """Writes DATE.json and DATE.md; their paths."""
    date = date or datetime.date.today().isoformat()
    folder.mkdir(parents=True, exist_ok=True)
    data, page = folder / f"{date}.json", folder / f"{date}.md"
    data.write_text(json.dumps(results | {"date": date}, indent=1) + "\n")
    page.write_text(markdown(results, date))
    return data, page


def markdown(results, date):
    lines = [f"# Linkwright and its rivals, {date}", ""]
    for mechanism in results["mechanisms"].values():
        lines += section(mechanism)
    return "\n".join(lines)


def number(value):
    """Three digits, without a power of ten."""
    if value is None:
        return ""
    if value >= 1000:
        return f"{value:,.0f}".replace(",", " ")
    return f"{value:.3g}"


def section(mechanism):
    lines = [f"## {mechanism['title']}", "", "| | agrees to | " + " | ".join(f"{title} | ratio" for _, title in KINDS) + " |"]
    lines.append("|---" * (2 + 2 * len(KINDS)) + "|")
    for peer, found in mechanism["peers"].items():
        cells = [peer, f"{found['agrees_to']:.0e}"]
        for kind, _ in KINDS:
            timed = found.get(kind)
            cells += [number(timed["ns"]), f"{timed['ratio']:.2f}"] if timed else ["", ""]
        lines.append("| " + " | ".join(cells) + " |")
    return [*lines, ""]
