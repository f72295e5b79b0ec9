#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the tables of docs/ that state what data/benchmarks measured.

In a page, a table stands between <!-- figures: NAME --> and <!-- end of figures -->; NAME is a function below.

figures.py          writes the tables into the pages
figures.py --check  fails if a page differs from what would be written
"""

import csv
import pathlib
import re
import statistics
import sys

docs = pathlib.Path(__file__).resolve().parent
figures = {}


def figure(function):
    figures[function.__name__.replace("_", "-")] = function
    return function


def read(name):
    """The rows of a file of data/benchmarks, with their numbers as floats."""

    def value(text):
        try:
            return float(text)
        except ValueError:
            return text

    with open(docs.parent / "data" / "benchmarks" / f"{name}.csv", encoding="utf-8", newline="") as file:
        return [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]


def only(rows, **wanted):
    """The rows that have these values."""
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def one(rows, **wanted):
    found = only(rows, **wanted)
    assert len(found) == 1, f"{len(found)} rows have {wanted}"
    return found[0]


def number(value):
    """Two or three digits, as many as a reader compares."""
    if value == "":
        return ""
    if value != 0 and not 1e-3 <= abs(value) < 1e6:
        return f"{value:.1e}".replace("e-0", "e-").replace("e+0", "e").replace("e+", "e")
    digits = 3 if 1 <= abs(value) < 10 or abs(value) >= 100 else 2
    rounded = float(f"{value:.{digits}g}")
    return f"{rounded:,.0f}" if abs(rounded) >= 100 else f"{rounded:g}"


def table(head, lines, *sources):
    text = ["| " + " | ".join(line) + " |" for line in (head, *lines)]
    text.insert(1, "|" + "---|" * len(head))
    made_of = [f"`data/benchmarks/{name}.csv`, commit {row['commit']}, {row['date'][:10]}" for name, row in sources]
    return "\n".join(text) + "\n\n(" + ";\n".join(made_of) + ")"


@figure
def solve():
    rows = read("epyc-solve")
    methods = [("hales-64", "double"), ("hales-1024", "double"), ("hales-64-simd", "float"),
               ("boost-brent", "double"), ("exact", "double"), ("batch", "double"), ("batch", "float")]
    lines = []
    for method, precision in methods:
        by = [one(rows, method=method, precision=precision, fog="exp", isa=isa) for isa in ("AVX2", "AVX3")]
        times = [number(row["ns_per_light"]) for row in by]
        lines.append([f"`{method}`", precision, *times, number(by[0]["max_error_255"])])
    for precision in ("double", "float"):
        by = [one(rows, method="memory-copy", precision=precision, isa=isa) for isa in ("AVX2", "AVX3")]
        lines.append(["`memory-copy`", precision, *(number(row["ns_per_light"]) for row in by), ""])
    return table(["method", "precision", "ns a light, AVX2", "AVX3", "largest error, 1/255"], lines,
                 ("epyc-solve", rows[0]))


@figure
def airlight():
    rows = read("xeon-airlight")
    marches = [("march", 16), ("march", 64), ("march-clipped", 16), ("march-clipped", 64), ("litfog", "")]
    shown = {"point": marches, "g-0.85": marches, "droplets": marches, "layers": marches, "any": marches,
             "inverse-square": [("arctangent", ""), ("pegoraro-2009", ""), ("sun-2005", ""), ("litfog", "")]}
    lines = []
    for lights, methods in shown.items():
        for method, nodes in methods:
            row = one(rows, method=method, nodes=nodes, fog="exp", lights=lights, lamp_leg=1)
            errors = [number(row["max_error_255"]), number(row["p99_relative"])]
            lines.append([lights, f"`{method}`", number(nodes), number(row["ns_per_ray"]), *errors])
    return table(["lamps", "method", "nodes", "ns a ray", "largest error, 1/255", "relative error of 99 % of rays"],
                 lines, ("xeon-airlight", rows[0]))


@figure
def update():
    rows = [row for row in read("epyc-update") if row["method"] != "updater-no-skip"]
    lines = [[f"`{row['method']}`", row["fog"], row["isa"], number(1000 * row["ms_per_step"]),
              f"{row['bytes_per_step']:,.0f}", number(row["max_deviation_255"])] for row in rows]
    return table(["method", "fog", "SIMD", "microseconds a step", "bytes to upload", "largest deviation, 1/255"], lines,
                 ("epyc-update", rows[0]))


@figure
def fit():
    rows = read("epyc-fit")
    lines = []
    for problem in dict.fromkeys(row["problem"] for row in rows):
        by = [one(rows, problem=problem, method=method) for method in ("litfog", "ceres")]
        solved = [f"{100 * row['solved_share']:.0f} %" for row in by]
        lines.append([problem, *(number(row["ms"]) for row in by), *solved])
    return table(["tables", "ms, litfog", "Ceres", "optimum found, litfog", "Ceres"], lines,
                 ("epyc-fit", rows[0]))


@figure
def frames():
    rows = only(read("llvmpipe-render"), path="unified", fog_light="peak", size="1280x720", samples=4)
    lines = []
    for scene in sorted({row["scene"] for row in rows}):
        ratios = [one(rows, scene=scene, lights=lights, skip=skip)["ratio_to_plain"] for lights in (2, 16)
                  for skip in ("on", "off")]
        lines.append([scene, *(f"{ratio:.2f}" for ratio in ratios)])
    return table(["scene", "2 lights", "nothing skipped", "16 lights", "nothing skipped"], lines,
                 ("llvmpipe-render", rows[0]))


@figure
def airlight_frames():
    rows = read("llvmpipe-frames")
    lines = []
    for single in only(rows, fog_light="single"):
        by_all = one(rows, scene=single["scene"], phase=single["phase"], fog_light="all")
        phase = f", {single['phase']}" if single["phase"] else ""
        lines.append([single["scene"] + phase, f"{single['lights']:,.0f}", f"{single['ratio_to_peak']:.1f}",
                      f"{by_all['ratio_to_peak']:.1f}", f"{by_all['ratio_to_single']:.1f}",
                      number(by_all["max_error_255"]), number(by_all["mean_error_255"])])
    return table(["scene", "lights", "single over peak", "all over peak", "all over single", "largest error, 1/255",
                  "mean"], lines, ("llvmpipe-frames", rows[0]))


@figure
def paths():
    rows = only(read("llvmpipe-render"), scene="headlights", size="640x360", samples=4, skip="on", lights=2)
    lines = []
    for row in sorted(rows, key=lambda row: row["ms_per_frame"]):
        name = f"`{row['path']}`" + (", airlight" if row["fog_light"] == "airlight" else "")
        ratios = [f"{row[f'ratio_to_{other}']:.2f}" for other in ("legacy", "plain")]
        lines.append([name, *ratios, number(row["max_error_255"])])
    return table(["path", "time over `legacy`", "over `plain`", "largest error, 1/255"], lines,
                 ("llvmpipe-render", rows[0]))


@figure
def rejection():
    rows = read("llvmpipe-rejection")
    lines = []
    for scene in sorted({row["scene"] for row in rows}):
        for rejection in ("front-to-back", "depth-pass"):
            by = [one(rows, scene=scene, lights=lights, samples=samples, rejection=rejection)
                  for samples in (1, 4) for lights in (2, 16)]
            before = one(rows, scene=scene, lights=2, samples=1, rejection="none")
            layers = [f"{row['layers_passed']:.2f}" for row in (before, by[0])]
            lines.append([scene, rejection, *layers, *(f"{row['ratio_to_none']:.2f}" for row in by)])
    return table(["scene", "rejection", "layers that pass, by material", "by this", "time, 1 sample, 2 lights", "16 lights",
                  "4 samples, 2 lights", "16 lights"], lines, ("llvmpipe-rejection", rows[0]))


@figure
def airlight_climb():
    rows = read("airlight-climb")
    lines = []
    for function, lamps, bound in dict.fromkeys((row["function"], row["lamps"], row["bound"]) for row in rows):
        by = only(rows, function=function, lamps=lamps, bound=bound)
        fogs = " and ".join(dict.fromkeys(row["fog"] for row in by))
        legs = " or ".join(f"{k:g}" for k in sorted({row["lamp_leg"] for row in by}))
        g = max(row["g"] for row in by)
        unit = "/255" if function == "airlight" else ""
        kind = f"{lamps}, {fogs}, k = {legs}, " + (f"\\|g\\| <= {g:g} and droplets" if g > 0 else "isotropic")
        lines.append([f"`{function}`", kind, f"{sum(row['rays'] for row in by):,.0f}", f"{by[0]['bound']:g}{unit}",
                      f"{max(row['worst'] for row in by):.3g}"])
    text = table(["function", "range", "rays", "bound", "worst found"], lines)
    return text.removesuffix("()") + "(`data/benchmarks/airlight-climb.csv`)"


@figure
def glow():
    rows = read("glow")
    lines = []
    for fog, phase in (("isotropic", "hg"), ("droplets", "droplets")):
        for method in ("single", "all", "apsf-2003", "gaussian-2004", "octaves-2013"):
            by = only(rows, phase=phase, method=method)
            cells = []
            for tau in (0.3, 1, 3, 6):
                errors = [100 * row["relative_error"] for row in only(by, tau=tau)]
                cells.append(f"{number(statistics.median(errors))}, {number(max(errors))}" if errors else "")
            lines.append([fog, f"`{method}`", number(statistics.median(row["ns_per_ray"] for row in by)), *cells])
    return table(["fog", "method", "ns a ray", "depth 0.3", "1", "3", "6"], lines, ("glow", rows[0]))


@figure
def traced():
    rows = read("traced")
    lines = []
    for single in only(rows, fog_light="single"):
        all_orders = one(rows, scene=single["scene"], visibility_m=single["visibility_m"], fog_light="all")
        ratios = [number(row[key]) for row in (single, all_orders) for key in ("ratio_p10", "ratio_p50", "ratio_p90")]
        lines.append([f"`{single['scene']}`", f"{number(single['visibility_m'])} m", *ratios, number(single["noise_p50"])])
    return table(["scene", "visibility", "single: 10 %", "median", "90 %", "all: 10 %", "median", "90 %", "noise"], lines,
                 ("traced", rows[0]))


@figure
def city():
    names = ("llvmpipe-city", "h100-city")
    machines = [read(name) for name in names]

    def row(what, values):
        return [what, *(values(rows) for rows in machines)]

    def largest(method, key, **wanted):
        return lambda rows: number(max(row[key] for row in only(rows, method=method, **wanted)))

    def lamps_in_view(rows):
        times = {lights: {row["visibility_m"]: row["ms"] for row in only(rows, method="frame-airlight", lights=lights)
                          if row["lights_that_matter"] > 0} for lights in (100, 1000)}
        return number(max(times[1000][m] / times[100][m] for m in times[1000] if m in times[100]))

    lines = [
        row("processor time of a frame over that of one with those lights alone", largest("frame", "ratio_to_those")),
        row("ms for the clusters of 100,000 lights in a new view", largest("clusters", "ms", lights=100_000)),
        row("ms for the same after a new visibility", largest("clusters-fog", "ms", lights=100_000)),
        row("the frame by airlight of 1,000 lamps over that of 100", lamps_in_view),
        row("the slowest of the 300 frames of a flight over the median", largest("frame-flight", "worst_ratio")),
    ]
    return table(["largest at any visibility", "two cores without a GPU", "an H100 and its processor"], lines,
                 *((name, rows[0]) for name, rows in zip(names, machines)))


@figure
def maps():
    rows = read("llvmpipe-maps")
    lines = [[f"`{row['path']}`", *(f"{size:,.0f}" for size in (row["pair_size"] or row["map_size"], row["range_kib"])),
              *(number(row[key]) for key in ("p99_error_255", "max_error_255"))] for row in rows]
    return table(["path", "texels a side", "KiB", "error of 99 % of pixels, 1/255", "largest"], lines,
                 ("llvmpipe-maps", rows[0]))


def plain(head, lines):
    return "\n".join("| " + " | ".join(line) + " |" for line in (head, ["---"] * len(head), *lines))


@figure
def fuzz():
    lines = [[f"`{row['target']}`", f"{row['runs']:,.0f}", f"{row['seconds'] / 60:,.0f}"] for row in read("fuzz")]
    return plain(["target", "runs", "minutes"], lines)


@figure
def load():
    row = read("epyc-load")[0]
    times = [number(1000 * row[key]) for key in ("ms_per_step", "ms_99", "ms_worst")]
    return table(["lights", "steps", "microseconds a step", "99 %", "worst", "worst over median", "MiB", "grown by"],
                 [[f"{row['lights']:,.0f}", f"{row['steps']:,.0f}", *times, number(row["ms_worst"] / row["ms_per_step"]),
                   number(row["resident_mib"]), number(row["grown_mib"])]], ("epyc-load", row))


@figure
def coverage():
    rows = [{**row, "folder": row["filename"].rpartition("/")[0]} for row in read("coverage")]
    return plain(["folder", "lines", "branches"], [[f"`{folder}`", *(
        f"{sum(row[f'{what}_covered'] for row in only(rows, folder=folder)):.0f} of "
        f"{sum(row[f'{what}_total'] for row in only(rows, folder=folder)):.0f}" for what in ("line", "branch"))]
        for folder in sorted({row["folder"] for row in rows})])


@figure
def mutants():
    rows = read("mutants")
    lines = []
    for folder in sorted({row["file"].rpartition("/")[0] for row in rows}):
        here = [row for row in rows if row["file"].startswith(folder + "/")]
        survivors = [f"`{row['file'].rpartition('/')[2]}:{row['line']:.0f}` `{row['operator']}` to `{row['mutant']}`"
                     .replace("|", "\\|") for row in here if not row["found_by"]]
        lines.append([f"`{folder}`", str(len(here)), str(len(here) - len(survivors)), ", ".join(survivors)])
    return plain(["folder", "mutants", "found", "not found"], lines)


def with_figures(text):
    def block(match):
        return f"{match[1]}\n{figures[match[2]]()}\n{match[3]}"

    return re.sub(r"(<!-- figures: ([a-z-]+) -->)\n.*?(<!-- end of figures -->)", block, text, flags=re.DOTALL)


stale = []
for page in sorted(docs.glob("*.md")):
    text = page.read_text(encoding="utf-8")
    made = with_figures(text)
    if made == text:
        continue
    stale.append(page.name)
    if "--check" not in sys.argv:
        page.write_text(made, encoding="utf-8")
if stale and "--check" in sys.argv:
    sys.exit(f"docs: {', '.join(stale)}: not what `./run figures` writes")
