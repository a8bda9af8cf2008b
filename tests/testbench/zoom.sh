#!/usr/bin/env bash
# The figures of a report in headless Chromium: each one is drawn by Dygraphs in place of its SVG, its panels zoom together and back, every point
# of its curves is in it, no text of a mark stands on another one or out of the panel, and the page loads nothing.
#   zoom.sh none | follows | library | loads | texts STEPLOCK WORK
#     follows   panels do not follow each other; library: Dygraphs is not in the page; loads: the page has a picture of elsewhere;
#     texts: all marks have theirs in one line
set -euo pipefail
flaw=$1 steplock=$(realpath "$2") work=$3
cd "$(dirname "$0")/../.."
mkdir -p "$work"
"$steplock" run tests/testbench/short.toml --engine fixed --out "$work/run" >"$work/log"
page=$work/page.html
case $flaw in
  none) cat "$work/run/report.html" ;;
  follows) sed 's/other\.updateOptions/void/' "$work/run/report.html" ;;
  library) sed 's/^!function(t){"object"/!function(t){return;"object"/' "$work/run/report.html" ;;
  loads) sed 's#<h2>#<img src="file:///nowhere.png"><h2>#' "$work/run/report.html" ;;
  texts) sed 's/ + 13 \* line//' "$work/run/report.html" ;;
  *) echo "zoom.sh: no flaw '$flaw'" >&2; exit 2 ;;
esac >"$page"
cat >>"$page" <<'END'
<script>
const said = [], near = (a, b, width) => Math.abs(a - b) < 1e-9 * width;
const figures = [...document.querySelectorAll('figure')];
if (figures.length < 4) said.push('only ' + figures.length + ' figures');
for (const figure of figures) {
  if (!figure.plots || figure.querySelector('svg').style.display !== 'none') { said.push('a figure is a picture'); continue; }
  const [first, ...others] = figure.plots, [a, b] = first.xAxisRange(), inner = [a + (b - a) / 4, b - (b - a) / 4];
  const shows = (plot, range) => plot.xAxisRange().every((x, i) => near(x, range[i], b - a));
  first.updateOptions({dateWindow: inner});
  if (!others.every((plot) => shows(plot, inner))) said.push('a panel does not follow');
  first.updateOptions({dateWindow: [a, b]});
  if (!others.every((plot) => shows(plot, [a, b]))) said.push('a panel does not come back');
  const data = JSON.parse(figure.querySelector('script').textContent.replace(/^[^{]*/, '').replace(/\);\s*$/, ''));
  figure.plots.forEach((plot, panel) => data.panels[panel].curves.forEach((curve, k) => {
    let points = 0;
    for (let row = 0; row < plot.numRows(); ++row) points += plot.getValue(row, k + 1) !== null;
    if (points !== curve.y.filter((y) => y !== null).length) said.push('a curve has lost points');
  }));
}
const texts = [], nothing = () => {};
const canvas = {beginPath: nothing, moveTo: nothing, lineTo: nothing, stroke: nothing, measureText: (text) => ({width: 6 * text.length}),
                fillText: (text, x, y) => texts.push([x, y, x + 6 * text.length])};
const marks = [[590, 'stop'], [300, 'load off'], [310, 'reverse'], [0, 'run']];
steplockMarks(canvas, {x: 0, y: 0, w: 600, h: 90}, {toDomXCoord: (x) => x}, marks, true);
if (texts.length !== 4 || texts.some(([a, , b]) => a < 0 || b > 600)) said.push('a text is out of its panel');
if (texts.some((p, i) => texts.some((q, k) => k > i && p[1] === q[1] && p[0] < q[2] && q[0] < p[2]))) said.push('a text stands on another');
if (performance.getEntriesByType('resource').length > 0 || document.querySelector('[src], link')) said.push('something is loaded');
document.body.dataset.said = said.join('; ') || 'all figures zoom';
</script>
END
chromium --headless --no-sandbox --disable-gpu --user-data-dir="$work/browser" --dump-dom "file://$(realpath "$page")" >"$work/dom.html" 2>"$work/browser.log" || {
  tail -n 5 "$work/browser.log" >&2; echo "zoom.sh: chromium does not run" >&2; exit 2; }
said=$(sed -n 's/.*<body data-said="\([^"]*\)".*/\1/p' "$work/dom.html")
case $said in
  'all figures zoom') echo "zoom.sh: $said" ;;
  '') echo "zoom.sh: the page's scripts do not run to their end" >&2; exit 1 ;;
  *) echo "zoom.sh: refused: $said" >&2; exit 1 ;;
esac
