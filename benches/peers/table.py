"""A run as files: JSON of everything, markdown of what is read, and pictures of work and precision."""

import datetime
import json

from picture import picture
from precision import LEVELS

KINDS = (("evaluation", "evaluation, ns"), ("chain", "chained, ns"), ("step", "step, ns"))
COMMAND = "python3 benches/peers/run.py"
OWN = "Linkwright"
# A load above this at the start or the end is said: something else ran.
QUIET = 0.7
# Agreement of a rival that counts as exact.
EXACT = 1e-6


def write(results, folder, date=None):
    """Writes DATE.json, DATE.md and a picture for each mechanism; their paths."""
    date = date or datetime.date.today().isoformat()
    folder.mkdir(parents=True, exist_ok=True)
    data, page = folder / f"{date}.json", folder / f"{date}.md"
    paths = [data, page]
    pictures = {}
    for name, mechanism in results["mechanisms"].items():
        drawn = picture(mechanism["title"], mechanism.get("precision", {}).get("curves", {}))
        if drawn:
            pictures[name] = f"{date}-{name}.svg"
            (folder / pictures[name]).write_text(drawn)
            paths.append(folder / pictures[name])
    data.write_text(json.dumps(results | {"date": date}, indent=1, ensure_ascii=False) + "\n")
    page.write_text(markdown(results, date, pictures))
    return paths


def markdown(results, date, pictures=()):
    lines = [f"# Linkwright and its rivals, {date}", "", *head(results), *summary(results)]
    for name, mechanism in results["mechanisms"].items():
        lines += section(mechanism, dict(pictures).get(name))
    return "\n".join([*lines, *absent(results)]) + "\n"


def head(results):
    machine, settings = results["machine"], results["settings"]
    options = "".join(f" --{key} {','.join(settings[key])}" for key in ("only",) if settings.get(key))
    options += " --quick" if settings.get("quick") else ""
    lines = [
        f"`{COMMAND}{options}` on {machine['processor']}, {machine['cores']} cores; {machine['rustc']}; {machine['gcc']}; "
        f"{machine['clang']}.",
        "Peers: " + "; ".join(f"{name}: {version}" for name, version in sorted(results.get("versions", {}).items())) + ".",
        f"State of Linkwright: {results.get('commit', 'unknown')}.",
    ]
    loads = [machine["load"][0], machine.get("load_at_end", machine["load"])[0]]
    lines.append(f"Load at the start {loads[0]:.1f}, at the end {loads[1]:.1f} (the comparison itself makes 1).")
    if loads[0] > QUIET:
        lines += ["", "**Something else ran on this machine when the run began: believe the ratios, not the last digit.**"]
    return [
        *lines,
        "",
        "All accelerations were compared before anything was timed, at 64 random consistent states; `agrees to` is the largest difference",
        "of the worst state by the largest acceleration of that state. Times are the least of many slices that take turns in one process",
        "on one core; a ratio is the median of the peer's slices by Linkwright's slices beside them. *Chained*: each state depends on the",
        "result before. A *step* is one of RK4 (Simbody: Runge–Kutta–Merson, five evaluations), with each peer's way of staying on the",
        "constraints. Peers that are handed cosines and sines are named so: Linkwright keeps them in its state and pays in its step.",
        "",
    ]


def summary(results):
    """The best exact rival of each mechanism."""
    lines = [
        "## In short",
        "",
        "Linkwright, ns, and how many times as long the best rival takes that agrees to 1e-6 and is given angles.",
        "",
    ]
    lines += ["| | evaluation | best rival | handed cos, sin | chained | best rival | step | best rival |", "|---" * 8 + "|"]
    for mechanism in results["mechanisms"].values():
        own = mechanism["peers"].get(OWN, {})
        cells = [mechanism["title"]]
        for kind, _ in KINDS:
            cells.append(number(own[kind]["ns"]) if kind in own else "")
            cells.append(best(mechanism, kind, handed=False) or "none")
            if kind == "evaluation":
                cells.append(best(mechanism, kind, handed=True))
        lines.append("| " + " | ".join(cells) + " |")
    ahead = [
        f"{mechanism['title']}: {peer}, {title} at {found[kind]['ratio']:.2f} of Linkwright's time"
        for mechanism in results["mechanisms"].values()
        for peer, found in mechanism["peers"].items()
        for kind, title in (("evaluation", "evaluation"), ("chain", "chained"), ("step", "step"))
        if kind in found and peer != OWN and found[kind]["ratio"] < 1
    ]
    lines += ["", "Where Linkwright is behind: " + ("; ".join(ahead) if ahead else "in none of these times") + ".", ""]
    return [*lines, *builds(results)]


def best(mechanism, kind, handed):
    """The exact rival with the least ratio."""
    rivals = [
        (found[kind]["ratio"], peer.replace(", handed cos, sin", ""))
        for peer, found in mechanism["peers"].items()
        if peer != OWN and kind in found and found["agrees_to"] <= EXACT and ("handed" in peer) == handed
    ]
    return f"{min(rivals)[0]:.2f} ({min(rivals)[1]})" if rivals else ""


def builds(results):
    """Who is generated and compiled sooner."""
    sooner = []
    for mechanism in results["mechanisms"].values():
        own = mechanism["peers"].get(OWN, {}).get("build")
        others = [
            (found["generation"] + found["build"], peer)
            for peer, found in mechanism["peers"].items()
            if peer != OWN and found.get("build") and found.get("generation")
        ]
        if own and others and min(others)[0] < own:
            sooner.append(f"{mechanism['title']} {min(others)[1]} {seconds(min(others)[0])} (Linkwright {seconds(own)})")
    said = "; ".join(sooner) if sooner else "none"
    return [f"Generated and compiled sooner than Linkwright's package by cargo (without the start of Python): {said}.", ""]


def number(value):
    """Three digits, without a power of ten."""
    if value is None:
        return ""
    if value >= 1000:
        return f"{value:,.0f}".replace(",", " ")
    digits = f"{value:.3g}"
    return digits if "e" not in digits else f"{value:.6f}"


def seconds(value):
    """With a unit."""
    if value is None:
        return ""
    for factor, unit in ((1, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")):
        if value >= factor:
            return f"{value / factor:.3g} {unit}"
    return f"{value:.1e} s"


def section(mechanism, drawn=None):
    lines = [f"## {mechanism['title']}", ""]
    if "clock" in mechanism:
        clock = mechanism["clock"]
        lines += [f"Clock beside the slices: {clock['median']:.2f} GHz in the middle, {clock['least']:.2f} to {clock['most']:.2f}.", ""]
    lines.append("| | agrees to | " + " | ".join(f"{title} | ratio" for _, title in KINDS) + " |")
    lines.append("|---" * (2 + 2 * len(KINDS)) + "|")
    refused = {entry["peer"] for entry in mechanism["refused"]}
    for peer, found in mechanism["peers"].items():
        cells = [peer + (f" ({found['note']})" if found["note"] and peer != OWN else ""), agreement(found)]
        if peer in refused:
            lines.append(f"| {cells[0]} | {cells[1]}: **refused, not timed** |" + " |" * (2 * len(KINDS)))
            continue
        if peer == OWN:
            cells[1] = ""
        for kind, _ in KINDS:
            timed = found.get(kind)
            cells += [number(timed["ns"]), f"{timed['ratio']:.2f}"] if timed else ["", ""]
        lines.append("| " + " | ".join(cells) + " |")
    return [*lines, "", *precision(mechanism, drawn), *batches(mechanism), *costs(mechanism)]


def agreement(found):
    text = f"{found['agrees_to']:.0e}"
    return text if found["agrees_to"] < 1e-5 else f"{text}, the middle state to {found['middle_agrees_to']:.0e}"


def precision(mechanism, drawn):
    found = mechanism.get("precision")
    if not found:
        return []
    reference = found["reference"]
    trust = f"which {reference['peer']} confirms to {reference['agrees_to']:.0e} rad" if reference["peer"] else "which no peer confirms"
    lines = [
        f"Wall time of a simulated second at equal error of the angles after {found['end']:g} s (reference: steps four times shorter, "
        f"{trust}):",
        "",
    ]
    lines += ["| | " + " | ".join(f"{level:.0e} rad" for level in LEVELS) + " | least error |", "|---" * (2 + len(LEVELS)) + "|"]
    own = found["at"].get(OWN, [None] * len(LEVELS))
    for peer, times in found["at"].items():
        cells = [peer]
        for value, base in zip(times, own):
            beside = f" ({value / base:.1f})" if value and base and peer != OWN else ""
            cells.append((seconds(value) or "not reached") + beside)
        errors = [error for _, _, error in found["curves"][peer]]
        lines.append("| " + " | ".join([*cells, f"{min(errors):.0e}" if errors else ""]) + " |")
    return [*lines, "", *([f"![work and precision]({drawn})", ""] if drawn else [])]


def batches(mechanism):
    found = mechanism.get("batches")
    if not found:
        return []
    lines = ["| many at once | threads | million steps a second |", "|---|---|---|"]
    lines += [f"| {peer} | {entry['threads']} | {number(entry['rate'] / 1e6)} |" for peer, entry in found.items()]
    return [*lines, ""]


def costs(mechanism):
    rows = [(peer, found) for peer, found in mechanism["peers"].items() if found.get("code") or found.get("build")]
    if not rows:
        return []
    lines = ["| made by | bytes of instructions | generation | compilation |", "|---|---|---|---|"]
    for peer, found in rows:
        generation = "in the build" if peer == OWN else seconds(found.get("generation"))
        lines.append(f"| {peer} | {number(found.get('code'))} | {generation} | {seconds(found.get('build'))} |")
    return [*lines, ""]


def absent(results):
    if not results["absent"]:
        return []
    titles = {name: mechanism["title"] for name, mechanism in results["mechanisms"].items()}
    lines = ["## Absent", "", "| peer | mechanism | reason |", "|---|---|---|"]
    for entry in results["absent"]:
        lines.append(f"| {entry['peer']} | {titles.get(entry['mechanism'], 'all')} | {cell(entry['reason'])} |")
    return [*lines, ""]


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")
