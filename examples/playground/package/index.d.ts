// Runge-Kutta methods: exact tableaux and what is proved of them. Every function throws an Error of one line for input that
// cannot be used (exit_code 2) and where something stays undecided (3).

export type Verdict = "proved" | "refuted" | "consistent" | "inconclusive";

/// "1/2", "0.25", "(3-sqrt(3))/6"; of numbers only whole ones are exact.
export type Entry = string | number;

export interface Claims {
  order?: number;
  embedded_order?: number;
  stage_order?: number;
  dense_order?: number;
  dense_smoothness?: number;
  A_stable?: boolean;
  L_stable?: boolean;
  algebraically_stable?: boolean;
  symplectic?: boolean;
  symmetric?: boolean;
  stiffly_accurate?: boolean;
}

/// A Butcher tableau; c is A times ones where it is left out.
export interface Tableau {
  name?: string;
  source?: string;
  note?: string;
  c?: Entry[];
  A: Entry[][];
  b: Entry[];
  b_embedded?: Entry[];
  b_theta?: Entry[][];
  claims?: Claims;
}

export interface Statement {
  statement: string;
  verdict: Verdict;
  reason: string;
}

/// A property: what it is, and what became of the claim on it, if there was one.
export interface Finding {
  value?: number;
  verdict?: Verdict;
  reason?: string;
  claimed?: number | boolean;
  claim?: Verdict;
}

export interface ComplexNumber {
  re: string;
  im: string;
  multiplicity: number;
  exact?: string;
}

export interface Certificate {
  name: string;
  source: string;
  data: string;
  stages: number;
  /// "nothing claimed", or of the claims: refuted where one is, proved where all are.
  verdict: Verdict | "nothing claimed";
  order?: Finding;
  embedded_order?: Finding;
  stage_order?: Finding;
  row_sums?: Finding;
  A_stable?: Finding;
  L_stable?: Finding;
  algebraically_stable?: Finding;
  symplectic?: Finding;
  symmetric?: Finding;
  stiffly_accurate?: Finding;
  eigenvalues?: ComplexNumber[];
  poles?: ComplexNumber[];
  /// The order conditions that fail, of the first order that has some.
  failures: { condition: string; tree: string; residual: string }[];
  /// Single entries whose change alone restores every claim.
  suspects: { entry: string; written: string; suggest: string }[];
  suspects_note?: string;
  notes?: string[];
  /// What of a program looks like coefficients or a claim and was not used.
  not_used?: string[];
  partners?: Certificate[];
  tableau?: Tableau;
  [other: string]: unknown;
}

export interface Reading {
  /// A tableau file in JSON, or arrays of a program as text. Default "auto": by the first character.
  from?: "auto" | "json" | "text";
  /// What decimals are: the numbers as written, rounded ones, or ("auto") exact where much shorter than usual.
  decimals?: "auto" | "exact" | "rounded";
}

/// The certificates of a program with several tableaux; those of its tableaux that cannot be used say why.
export interface Program {
  methods: (Certificate | { name: string; error: string; exit_code: number })[];
  not_used?: string[];
}

/// What `stagecraft certify --json` prints of a tableau, or of the text of a file or a program.
export function certify(method: Tableau, reading?: Reading): Promise<Certificate>;
export function certify(text: string, reading?: Reading): Promise<Certificate | Program>;

/// Every notion of stability, and orders on differential-algebraic problems: lists of statements by title.
export function stability(method: Tableau | string, reading?: Reading):
  Promise<{ name: string; tableau?: Tableau } & Record<string, Statement[] | string | Tableau | undefined>>;

/// A family's member ("gauss", "radau_iia", "lobatto_iiic", ...), each number correctly rounded to so many digits.
export function tableau(family: string, stages: number, digits?: number):
  Promise<{ family: string; stages: number; digits: number; c: string[]; A: string[][]; b: string[] }>;

/// The collocation method on exact nodes in [0, 1], and what is proved of it.
export function collocate(nodes: Entry | Entry[]): Promise<{ tableau: Tableau; certificate: Record<string, unknown> }>;

/// The exercise of a kind that belongs to a seed, the same everywhere.
export function exercise(kind: string, seed?: number): Promise<{
  kind: string;
  seed: number;
  question: string;
  solution: string;
  question_latex: string;
  solution_latex: string;
  question_html: string;  // formulas as MathML
  solution_html: string;
  certificate: Statement[];
}>;
