// Run where the package is installed and nothing else: what a program gets from it. Expected are textbook facts.
import assert from "node:assert/strict";
import {certify, collocate, exercise, stability, tableau} from "stagecraft";

const midpoint = {A: [["0", "0"], ["1/2", "0"]], b: ["0", "1"], claims: {order: 2}};
const certificate = await certify(midpoint);
assert.equal(certificate.verdict, "proved");
assert.equal(certificate.order.value, 2);
midpoint.claims.order = 3;
assert.equal((await certify(midpoint)).verdict, "refuted");
assert.equal((await certify("A = [[0.5]]\nb = [1]\norder = 2")).verdict, "proved");
await assert.rejects(certify({A: [["1/0"]], b: [1]}), {message: /A\[1\]\[1\]: '1\/0' division by zero/, exit_code: 2});

const radau = await tableau("radau_iia", 2, 25);
assert.deepEqual(radau.A.map((row) => row.map((x) => Math.round(12 * x))), [[5, -1], [9, 3]]);
assert.equal(radau.A[0][0], "0.4166666666666666666666667");
const said = Object.values(await stability({A: [["1"]], b: ["1"]})).flat();
assert.equal(said.find(({statement}) => statement === "L-stable").verdict, "proved");
assert.deepEqual((await collocate(["0", "1"])).tableau.A, [["0", "0"], ["1/2", "1/2"]]);
assert.equal((await exercise("order", 3)).kind, "order");
console.log("package: passed");
