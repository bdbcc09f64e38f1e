"use strict";
// Curves and points over linear and logarithmic axes, as SVG.

const superscript = (n) => `${n}`.replace(/./g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);

/// What stands at a tick: 0.25, 3·10⁵; of a logarithm, 10⁻³.
function tick_text(x, log) {
  if (log) return `10${superscript(Math.round(x))}`;
  if (x === 0 || (Math.abs(x) >= 1e-3 && Math.abs(x) < 1e5)) return `${Number(x.toPrecision(6))}`.replace("-", "−");
  const [digits, power] = Number(x.toPrecision(4)).toExponential().split("e");
  return `${digits}·10${superscript(Number(power))}`.replace("-", "−");
}

/// An axis {log, title, low, high}: where a number lies in [0, 1] along it, and its ticks.
function scale_of({log, low, high}, length, room) {
  const f = log ? Math.log10 : (x) => x;
  let a = f(low), b = f(high);
  if (!(b > a)) [a, b] = [a - (log ? 1 : Math.abs(a) / 2 || 1), b + (log ? 1 : Math.abs(b) / 2 || 1)];
  const step = log ? Math.max(1, Math.ceil((b - a) / (length / room))) : tick_step(b - a, length / room);
  const ticks = [];
  for (let k = Math.ceil(a / step - 1e-9); k * step <= b + 1e-9 * step; ++k) ticks.push(k * step);
  return {at: (x) => (f(x) - a) / (b - a), ticks: ticks.map((x) => [(x - a) / (b - a), tick_text(x, log)])};
}

/// The least and the largest number of a list, a little apart; of a logarithm, of the positive ones.
function span_of(values, log) {
  let low = Infinity, high = -Infinity;
  for (const x of values)
    if (Number.isFinite(x) && (!log || x > 0)) {
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
  if (low > high) return log ? {low: 0.1, high: 1} : {low: 0, high: 1};
  const air = 0.04 * (high - low);
  return log ? {low: low / 1.2, high: high * 1.2} : {low: low - air, high: high + air};
}

/// Series are {points: [[x, y]], kind: "line", "dots" or "crosses", style: a class}. The picture is as wide as `place`.
function chart(place, label, x, y, series) {
  const width = Math.max(260, place.clientWidth || 600), height = Math.round(Math.min(380, 0.66 * width));
  const left = 58, right = 12, top = 20, bottom = 40, inner = width - left - right, tall = height - top - bottom;
  const X = scale_of(x, inner, 75), Y = scale_of(y, tall, 38);
  const at = ([u, v]) => [left + inner * X.at(u), top + tall * (1 - Y.at(v))];
  const seen = ([u, v]) => Number.isFinite(u) && Number.isFinite(v) && Math.abs(v) < 1e9;
  const shape = {
    line: (points) => {
      let text = "", pen = "M";
      for (const point of points) {
        const good = seen(point);
        if (good) text += pen + point[0].toFixed(1) + " " + Math.max(-9e4, Math.min(9e4, point[1])).toFixed(1);
        pen = good ? "L" : "M";
      }
      return text;
    },
    dots: (points) => points.filter(seen).map(([u, v]) => `M${u.toFixed(1)} ${v.toFixed(1)}h0`).join(""),
    crosses: (points) => points.filter(seen).map(([u, v]) => `M${(u - 4).toFixed(1)} ${(v - 4).toFixed(1)}l8 8m0 -8l-8 8`).join(""),
  };
  const id = `clip-${place.id}`;
  return svg("svg", {class: "chart", viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label},
    svg("clipPath", {id}, svg("rect", {x: left, y: top, width: inner, height: tall})),
    ...X.ticks.map(([u]) => svg("line", {class: "grid", x1: left + u * inner, x2: left + u * inner, y1: top, y2: top + tall})),
    ...Y.ticks.map(([v]) => svg("line", {class: "grid", x1: left, x2: left + inner, y1: top + tall * (1 - v), y2: top + tall * (1 - v)})),
    svg("g", {"clip-path": `url(#${id})`}, ...series.map(({points, kind, style}) =>
      svg("path", {class: `${kind} ${style}`, d: shape[kind](points.map(at))}))),
    svg("rect", {class: "frame", x: left, y: top, width: inner, height: tall}),
    ...X.ticks.map(([u, text]) => svg("text", {x: left + u * inner, y: top + tall + 15, "text-anchor": "middle"}, text)),
    ...Y.ticks.map(([v, text]) => svg("text", {x: left - 6, y: top + tall * (1 - v) + 4, "text-anchor": "end"}, text)),
    svg("text", {class: "title", x: left + inner, y: height - 6, "text-anchor": "end"}, x.title),
    svg("text", {class: "title", x: left, y: 13}, y.title));
}

/// [style, text] of each curve, with a sample of it.
function legend(entries) {
  return element("p.legend", {}, ...entries.map(([style, text, kind = "line"]) => element("span", {},
    svg("svg", {width: 22, height: 10, "aria-hidden": "true"}, svg("path", {class: `${kind} ${style}`,
      d: kind === "line" ? "M1 5h20" : kind === "dots" ? "M11 5h0" : "M7 1l8 8m0 -8l-8 8"})), ` ${text}`)));
}

/// A figure with a title, its legend and its numbers as CSV; `draw` fills a place that has its width already.
function figure(title, entries, header, rows, draw) {
  const place = element("div", {id: `chart-${figure.count = (figure.count ?? 0) + 1}`});
  const data = element("pre.data");
  const numbers = element("details", {ontoggle: () => {
    if (numbers.open) data.textContent = [header, ...rows()].map((row) => row.join(",")).join("\n");
  }}, element("summary", {}, "Data (CSV)"), data);
  const whole = element("figure.plot", {}, element("h3", {}, title), place, entries.length > 1 ? legend(entries) : null, numbers);
  whole.redraw = () => place.replaceChildren(draw(place));
  return whole;
}
