"use strict";
// Numbers as the engine writes them, for pictures: exact decisions are the engine's.

/// The value of "1/2-1/6*sqrt(3)", "0.25" or "(3+sqrt(3))/6"; NaN for anything else.
function value_of(text) {
  const tokens = String(text).match(/\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+|sqrt|[-+*/()]|\S/g) || [];
  let at = 0;
  const take = (token) => tokens[at] === token && ++at > 0;
  function sum() {
    let x = product();
    for (;;) {
      if (take("+")) x += product();
      else if (take("-")) x -= product();
      else return x;
    }
  }
  function product() {
    let x = factor();
    for (;;) {
      if (take("*")) x *= factor();
      else if (take("/")) x /= factor();
      else return x;
    }
  }
  function factor() {
    if (take("-")) return -factor();
    if (take("+")) return factor();
    const root = take("sqrt");
    if (take("(")) {
      const x = sum();
      return take(")") ? (root ? Math.sqrt(x) : x) : NaN;
    }
    return root || !/^[\d.]/.test(tokens[at] ?? "") ? NaN : Number(tokens[at++]);
  }
  const x = sum();
  return at === tokens.length ? x : NaN;
}

/// The fraction nearest to x in [0, 1] whose denominator is at most `most`, as [numerator, denominator].
function nearest_fraction(x, most) {
  let best = [Math.round(x), 1];
  for (let q = 2; q <= most; ++q) {
    const p = Math.round(x * q);
    if (Math.abs(p / q - x) < Math.abs(best[0] / best[1] - x) - 1e-12) best = [p, q];
  }
  return best;
}
const fraction_text = ([p, q]) => (q === 1 ? `${p}` : `${p}/${q}`);

/// p(x + iy) as [re, im]; coefficients from the constant term on.
function horner(p, x, y) {
  let re = 0, im = 0;
  for (let k = p.length - 1; k >= 0; --k) {
    const t = re * x - im * y + p[k];
    im = re * y + im * x;
    re = t;
  }
  return [re, im];
}

/// |R|^2 at x + iy.
function size_squared(r, x, y) {
  const [a, b] = horner(r.numerator, x, y), [c, d] = horner(r.denominator, x, y);
  return (a * a + b * b) / (c * c + d * d);
}
