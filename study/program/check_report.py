#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Opens a report in headless Chromium and checks that every chart is there and legible.

usage: check_report.py FOLDER [--self-test]

A chart must be drawn at least 300 by 150 pixels large, hold marks and text, and have all its text inside it and at least
6 pixels high; the first has no text over another. --self-test breaks the report in several ways and fails unless each is noticed."""

import csv
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

MEASURE = """<script>addEventListener('load',()=>{const all={};
for(const svg of document.querySelectorAll('.chart svg')){const box=svg.getBoundingClientRect();const text=[...svg.querySelectorAll('text')];
const rects=text.map(t=>t.getBoundingClientRect()).filter(r=>r.width>0);
all[svg.id]={width:box.width,height:box.height,texts:rects.length,least:Math.min(...text.map(t=>{const m=t.getScreenCTM();return parseFloat(getComputedStyle(t).fontSize)*Math.sqrt(Math.abs(m.a*m.d-m.b*m.c))})),
outside:rects.filter(r=>r.left<box.left-2||r.right>box.right+2||r.top<box.top-2||r.bottom>box.bottom+2).length,
overlaps:rects.filter((r,i)=>rects.some((o,j)=>j<i&&r.left<o.right-1&&o.left<r.right-1&&r.top<o.bottom-2&&o.top<r.bottom-2)).length,
marks:svg.querySelectorAll('path,use,rect').length,visible:getComputedStyle(svg).visibility}}
const images=[...document.querySelectorAll('.image img')].map(i=>i.naturalWidth);
const pre=document.createElement('pre');pre.id='measured';pre.textContent=JSON.stringify({charts:all,images:images,rows:document.querySelectorAll('td').length});
document.body.append(pre)})</script></body>"""


def measured(page):
    """The browser's measurements of the page's text."""
    browser = (
        shutil.which("chromium")
        or shutil.which("chromium-browser")
        or shutil.which("google-chrome")
    )
    if not browser:
        sys.exit("check_report.py: no Chromium; on Debian: apt-get install chromium")
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "report.html"
        path.write_text(page.replace("</body>", MEASURE))
        command = [
            browser,
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--window-size=1280,1024",
            "--virtual-time-budget=5000",
            f"--user-data-dir={folder}/profile",
            "--dump-dom",
            path.as_uri(),
        ]
        dom = subprocess.run(
            command, capture_output=True, text=True, timeout=120, check=True
        ).stdout
    found = re.search(r'<pre id="measured">(.*?)</pre>', dom, re.S)
    if not found:
        sys.exit("check_report.py: the browser did not run the page")
    return json.loads(found[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))


def problems(page, sweeps):
    """The problems of the report's text, line by line."""
    found = []
    if re.search(r'(?:src|href)="(?!data:|#)', page):
        found.append("the report loads something from elsewhere")
    expected = [
        "speed-accuracy",
        "flicker",
        "pixels",
        "cost",
        "planes-needed",
    ] + [f"edges-{i}" for i in range(sweeps)]
    result = measured(page)
    for name in expected:
        chart = result["charts"].get(f"chart-{name}")
        if not chart:
            found.append(f"chart {name} is missing")
            continue
        if chart["width"] < 300 or chart["height"] < 150 or chart["visible"] != "visible":
            found.append(f"chart {name} is {chart['width']:.0f} by {chart['height']:.0f} pixels")
        if chart["texts"] < 8 or chart["marks"] < 10:
            found.append(f"chart {name} has {chart['texts']} texts and {chart['marks']} marks")
        if not (chart["least"] or 0) >= 6:
            found.append(f"chart {name} has text {chart['least']} pixels high")
        if chart["outside"]:
            found.append(f"chart {name} has {chart['outside']} texts that stick out of it")
    overlaps = result["charts"].get("chart-speed-accuracy", {}).get("overlaps")
    if overlaps:
        found.append(f"chart speed-accuracy has {overlaps} texts over others")
    if len(result["images"]) < 10 or 0 in result["images"]:
        found.append(f"images are missing: {result['images']}")
    if result["rows"] < 40:
        found.append(f"the tables have {result['rows']} cells")
    return found


def main():
    folder = pathlib.Path(sys.argv[1])
    page = (folder / "report.html").read_text()
    with open(folder / "edges.csv", newline="") as file:
        sweeps = len({row["sweep"] for row in csv.DictReader(file)})
    found = problems(page, sweeps)
    if "--self-test" in sys.argv:
        breaks = {
            "a chart less": re.sub(r'id="chart-flicker"', 'id="chart-other"', page),
            "tiny text": page.replace("</style>", "svg text{font-size:3px!important}</style>", 1),
            "a hidden chart": page.replace("</style>", "#chart-pixels{display:none}</style>", 1),
            "text outside": page.replace(
                "</style>", "#chart-cost text{transform:translate(900px,0)!important}</style>", 1
            ),
            "texts over others": page.replace(
                "</style>",
                "#chart-speed-accuracy text{transform:translate(300px,200px)!important}</style>",
                1,
            ),
            "a broken image": page.replace(
                "data:image/png;base64,iVBOR", "data:image/png;base64,AAAA", 1
            ),
            "a network load": page.replace("<h1>", '<img src="elsewhere.png"><h1>', 1),
        }
        found += [
            f"not noticed: {what}"
            for what, broken in breaks.items()
            if broken == page or not problems(broken, sweeps)
        ]
    print("\n".join(found) or f"{sweeps + 5} charts, all there and legible")
    return bool(found)


sys.exit(main())
