"""Work and precision as a picture: error across, wall time of a simulated second up, both logarithmic. Plain SVG."""

import math
from xml.sax.saxutils import escape

COLOURS = ("#111111", "#c0392b", "#2471a3", "#1e8449", "#b7950b", "#7d3c98", "#ca6f1e", "#148f77", "#7b7d7d", "#922b21")
WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 760, 420, 70, 40, 250, 50


def picture(title, curves):
    """SVG of curves by name, each a list of (steps, seconds, error)."""
    curves = {name: [(error, seconds) for _, seconds, error in curve if error > 0] for name, curve in curves.items()}
    curves = {name: points for name, points in curves.items() if points}
    if not curves:
        return None
    values = [point for points in curves.values() for point in points]
    across = decades([error for error, _ in values])
    up = decades([seconds for _, seconds in values])
    # Small errors on the right, so that better is to the right and below.
    x = lambda value: LEFT + (across[1] - math.log10(value)) / (across[1] - across[0]) * (WIDTH - LEFT - RIGHT)  # noqa: E731
    y = lambda value: HEIGHT - BOTTOM - (math.log10(value) - up[0]) / (up[1] - up[0]) * (HEIGHT - TOP - BOTTOM)  # noqa: E731
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
        f'<text x="{LEFT}" y="22" font-size="15">{escape(title)}</text>',
    ]
    for power in range(across[0], across[1] + 1):
        at = x(10.0**power)
        parts.append(f'<line x1="{at:.1f}" y1="{TOP}" x2="{at:.1f}" y2="{HEIGHT - BOTTOM}" stroke="#dddddd"/>')
        parts.append(f'<text x="{at:.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">1e{power}</text>')
    for power in range(up[0], up[1] + 1):
        at = y(10.0**power)
        parts.append(f'<line x1="{LEFT}" y1="{at:.1f}" x2="{WIDTH - RIGHT}" y2="{at:.1f}" stroke="#dddddd"/>')
        parts.append(f'<text x="{LEFT - 6}" y="{at + 4:.1f}" text-anchor="end">{duration(power)}</text>')
    middle = (LEFT + WIDTH - RIGHT) / 2
    said = "largest error of an angle at the end, rad"
    parts.append(f'<text x="{middle:.0f}" y="{HEIGHT - 12}" text-anchor="middle">{said}</text>')
    upright, said = HEIGHT / 2, "wall time of a simulated second"
    turned = f'transform="rotate(-90 16 {upright:.0f})"'
    parts.append(f'<text x="16" y="{upright:.0f}" text-anchor="middle" {turned}>{said}</text>')
    for k, (name, points) in enumerate(curves.items()):
        colour = COLOURS[k % len(COLOURS)]
        line = " ".join(f"{x(error):.1f},{y(seconds):.1f}" for error, seconds in points)
        dash = ' stroke-dasharray="5 3"' if k >= len(COLOURS) else ""
        parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="{2.5 if k == 0 else 1.5}"{dash}/>')
        parts += [f'<circle cx="{x(e):.1f}" cy="{y(s):.1f}" r="2.5" fill="{colour}"/>' for e, s in points]
        at = TOP + 10 + 18 * k
        key = WIDTH - RIGHT + 14
        parts.append(f'<line x1="{key}" y1="{at - 4}" x2="{key + 20}" y2="{at - 4}" stroke="{colour}" stroke-width="2"{dash}/>')
        parts.append(f'<text x="{key + 26}" y="{at}">{escape(name)}</text>')
    return "\n".join([*parts, "</svg>", ""])


def decades(values):
    """Powers of ten around the values, at least one apart."""
    logs = [math.log10(value) for value in values]
    low, high = math.floor(min(logs)), math.ceil(max(logs))
    return low, max(high, low + 1)


def duration(power):
    names = {0: "1 s", 1: "10 s", 2: "100 s", -1: "100 ms", -2: "10 ms", -3: "1 ms", -4: "100 µs", -5: "10 µs", -6: "1 µs"}
    return names.get(power, f"1e{power} s")
