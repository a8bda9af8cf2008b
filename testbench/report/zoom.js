// Figures of a report that can be zoomed and read off: Dygraphs draws them in place of their SVG.
//
//     drag across       zoom all panels of the figure along their axis; drag up or down: this panel's own axis
//     shift and drag    move; double click: all of it again
//
// figure is the element, with an SVG and a div.panels in it; data is what zoom.cpp writes:
// {axis, marks: [[x, text]], panels: [panel]}
// panel: {label, weight, range: [low, high] or null, ticks: [[y, text]], curves: [{title, color, width, steps, dots, x: [], y: []}]}
//
// Doc: docs/report.md   Test: tests/testbench/zoom.sh

// Curves with instants of their own as one table: an instant's row has null where a curve has no point.
function steplockTable(curves) {
  const points = [];
  curves.forEach((curve, k) => curve.x.forEach((x, i) => points.push({x, k, y: curve.y[i]})));
  points.sort((a, b) => a.x - b.x);  // stable: the points of one curve keep their order
  const rows = [];
  for (const point of points) {
    let row = rows[rows.length - 1];
    if (!row || row[0] !== point.x || row[point.k + 1] !== null) {
      row = [point.x, ...curves.map(() => null)];
      rows.push(row);
    }
    row[point.k + 1] = point.y;
  }
  return rows;
}

function steplockMarks(canvas, area, plot, marks, named) {
  canvas.strokeStyle = canvas.fillStyle = '#9aa5b1';
  canvas.font = '11px sans-serif';
  const ends = [];  // of the texts in each line: one that would touch another stands a line below
  for (const [x, text] of [...marks].sort((a, b) => a[0] - b[0])) {
    const at = plot.toDomXCoord(x);
    if (at < area.x || at > area.x + area.w) continue;
    canvas.beginPath();
    canvas.moveTo(at, area.y);
    canvas.lineTo(at, area.y + area.h);
    canvas.stroke();
    if (!named) continue;
    const width = canvas.measureText(text).width + 6, left = Math.min(at, area.x + area.w - width);
    let line = ends.findIndex((end) => end < left);
    if (line < 0) line = ends.length;
    ends[line] = left + width;
    canvas.fillText(text, left + 3, area.y + 11 + 13 * line);
  }
}

function steplockZoom(figure, data) {
  if (typeof Dygraph === 'undefined') return;  // the SVG stays
  const plots = [];
  let following = true;  // none follows another one before all are there
  const follow = (plot) => {
    if (following) return;
    following = true;
    for (const other of plots) if (other !== plot) other.updateOptions({dateWindow: plot.xAxisRange()});
    following = false;
  };
  data.panels.forEach((panel, index) => {
    const element = document.createElement('div');
    // Names of ticks need their lines.
    element.style.cssText = `width: 100%; height: ${Math.max(Math.round(110 * panel.weight), 14 * panel.ticks.length) + 30}px`;
    const legend = document.createElement('div');  // above the panel, where it hides no curve
    legend.className = 'legend';
    const titled = panel.curves.some((curve) => curve.title);
    figure.querySelector('.panels').append(...(titled ? [legend, element] : [element]));
    const labels = panel.curves.map((curve, k) => (curve.title || panel.label) + '\u200b'.repeat(k));  // each its own
    const series = {};
    panel.curves.forEach((curve, k) => {
      series[labels[k]] = {color: curve.color, stepPlot: curve.steps, drawPoints: curve.dots, strokeWidth: curve.dots ? 0 : curve.width};
    });
    const widest = 20 + 7 * Math.max(0, ...panel.ticks.map(([, label]) => label.length));  // px, at this size of letters
    const names = panel.ticks.length > 0 ? {axisLabelFontSize: 11, ticker: () => panel.ticks.map(([v, label]) => ({v, label}))} : {};
    plots.push(new Dygraph(element, steplockTable(panel.curves), {
      labels: ['x', ...labels], series, ylabel: panel.label, xlabel: index === data.panels.length - 1 ? data.axis : '',
      connectSeparatedPoints: true, ...(titled ? {legend: 'always', labelsDiv: legend} : {legend: 'follow'}), digitsAfterDecimal: 6,
      valueRange: panel.range, axes: {y: {axisLabelWidth: Math.max(75, widest), ...names}}, drawCallback: follow,
      underlayCallback: (canvas, area, plot) => steplockMarks(canvas, area, plot, data.marks, index === 0),
    }));
  });
  following = false;
  figure.querySelector('svg').style.display = 'none';
  figure.plots = plots;
}
