"use strict";
// Rooted trees as SVG, stability regions on a canvas.

/// The tree in brackets, [tau,[tau]], as {children, mark}; null where the text is none. Trees of several tableaux have marks.
function parsed_tree(text) {
  let at = 0;
  function node() {
    const children = [];
    if (text.startsWith("tau", at)) {
      at += 3;
    } else if (text[at] === "[") {
      do {
        ++at;
        const child = node();
        if (!child) return null;
        children.push(child);
      } while (text[at] === ",");
      if (text[at++] !== "]") return null;
    } else {
      return null;
    }
    const mark = /^_\w+/.exec(text.slice(at))?.[0] ?? "";
    at += mark.length;
    return {children, mark};
  }
  const root = node();
  return root && at === text.length ? root : null;
}

function svg(name, attributes, ...children) {
  const e = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) e.setAttribute(key, value);
  e.append(...children);
  return e;
}

/// A drawing of it, the root below.
function tree_picture(text) {
  const root = parsed_tree(text);
  if (!root) return document.createTextNode(text);
  const lines = [], points = [];
  let leaves = 0, height = 0;
  function place(node, level) {
    height = Math.max(height, level);
    const xs = node.children.map((child) => place(child, level + 1));
    const x = xs.length ? (xs[0] + xs[xs.length - 1]) / 2 : leaves++;
    xs.forEach((cx) => lines.push([x, level, cx, level + 1]));
    points.push([x, level, node]);
    return x;
  }
  place(root, 0);
  const step = 14, edge = 6, X = (x) => edge + step * x, Y = (level) => edge + step * (height - level);
  return svg("svg", {class: "tree", role: "img", "aria-label": `tree ${text}`, width: X(leaves - 1) + edge,
                     height: Y(0) + edge},
    ...lines.map(([x, a, cx, b]) => svg("line", {x1: X(x), y1: Y(a), x2: X(cx), y2: Y(b)})),
    ...points.map(([x, level, node]) =>
      svg("circle", {cx: X(x), cy: Y(level), r: 3.5, class: (level ? "" : "root") + (node.mark ? " marked" : "")})));
}

/// Half the width of a window that shows what there is to see: for polynomials the whole region, otherwise the poles.
function natural_window(r, poles) {
  if (r.denominator.length > 1) {
    const sizes = poles.map((p) => Math.hypot(p.re, p.im)).filter((size) => size > 0 && size < 1e6);
    return sizes.length ? 1.8 * Math.max(...sizes) : 8;
  }
  let far = 1;
  for (let radius = 0.25; radius < 200; radius += radius < 20 ? 0.25 : 2)
    for (let k = 0; k <= 48; ++k)
      if (size_squared(r, radius * Math.cos((Math.PI * k) / 48), radius * Math.sin((Math.PI * k) / 48)) <= 1) far = radius;
  return 1.15 * far;
}

/// Steps of 1, 2 or 5 times a power of ten, about `parts` in the length.
function tick_step(length, parts) {
  const rough = length / parts, power = 10 ** Math.floor(Math.log10(rough));
  return power * ([1, 2, 5].find((k) => k * power >= rough) ?? 10);
}

/// The region |R| <= 1 shaded, with axes; poles as crosses. Where it is asked for, the order star |R(z)| > |e^z| in its place.
function draw_region(canvas, caption, r, half, poles) {
  const star = canvas.parentNode.querySelector("[data-star]").checked;
  caption.textContent = (star ? "shaded: |R(z)| > |eᶻ|" : "shaded: |R(z)| ≤ 1") + (poles.length ? "; × poles of R" : "");
  canvas.setAttribute("aria-label", `${star ? "order star" : "stability region"}, ${half.toPrecision(3)} around 0 in each direction`);
  const scale = window.devicePixelRatio || 1, width = canvas.clientWidth || 360;
  const n = canvas.width = canvas.height = Math.round(width * scale);
  const style = getComputedStyle(canvas), colour = (name) => style.getPropertyValue(name).trim();
  const g = canvas.getContext("2d"), image = g.createImageData(n, n), pixel = (2 * half) / n;
  const inside = rgb(colour("--inside")), outside = rgb(colour("--card")), pixels = new Uint32Array(image.data.buffer);
  const [in_word, out_word] = [inside, outside].map((c) => new Uint32Array(new Uint8Array(c).buffer)[0]);
  for (let row = 0; row < n; ++row)
    for (let column = 0; column < n; ++column) {
      const x = (column + 0.5 - n / 2) * pixel, y = (n / 2 - row - 0.5) * pixel;
      const size = size_squared(r, x, y);
      pixels[row * n + column] = (star ? size > Math.exp(2 * x) : size <= 1) ? in_word : out_word;
    }
  outline(image, n, inside, rgb(colour("--edge")));
  g.putImageData(image, 0, 0);
  axes(g, n, half, scale, colour);
  g.strokeStyle = colour("--bad");
  g.lineWidth = 1.5 * scale;
  const at = (x) => n / 2 + x / pixel, arm = 4 * scale;
  for (const {re, im} of poles) {
    const x = at(Number(re)), y = at(-Number(im));
    g.beginPath();
    for (const side of [-1, 1]) {
      g.moveTo(x - arm, y - side * arm);
      g.lineTo(x + arm, y + side * arm);
    }
    g.stroke();
  }
}

function rgb(hex) {
  return [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16)).concat(255);
}

/// Colours the pixels inside that have a neighbour outside.
function outline(image, n, inside, edge) {
  const is_inside = (k) => image.data[k] === inside[0] && image.data[k + 2] === inside[2];
  const found = [];
  for (let row = 1; row < n - 1; ++row)
    for (let column = 1; column < n - 1; ++column) {
      const k = 4 * (row * n + column);
      if (is_inside(k) && !(is_inside(k - 4) && is_inside(k + 4) && is_inside(k - 4 * n) && is_inside(k + 4 * n)))
        found.push(k);
    }
  for (const k of found) image.data.set(edge, k);
}

function axes(g, n, half, scale, colour) {
  g.strokeStyle = g.fillStyle = colour("--ink");
  g.lineWidth = scale;
  g.font = `${11 * scale}px system-ui, sans-serif`;
  g.beginPath();
  g.moveTo(0, n / 2); g.lineTo(n, n / 2);
  g.moveTo(n / 2, 0); g.lineTo(n / 2, n);
  const step = tick_step(2 * half, 8), tick = 3 * scale;
  for (let k = Math.ceil(-half / step); k * step <= half; ++k) {
    const at = n / 2 + (k * step * n) / (2 * half), label = `${Number((k * step).toPrecision(6))}`;
    if (!k || at < 14 * scale || at > n - 14 * scale) continue;
    g.moveTo(at, n / 2 - tick); g.lineTo(at, n / 2 + tick);
    g.moveTo(n / 2 - tick, at); g.lineTo(n / 2 + tick, at);
    g.textAlign = "center";
    g.textBaseline = "top";
    g.fillText(label, at, n / 2 + 5 * scale);
    g.textAlign = "left";
    g.textBaseline = "middle";
    g.fillText(label.startsWith("-") ? label.slice(1) : `-${label}`, n / 2 + 6 * scale, at);
  }
  g.stroke();
}
